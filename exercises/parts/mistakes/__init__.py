"""Find the mistake: what was planted, where, what it is called and how it is mended.

find_mistake     in a table
matrix_mistake   in a matrix
frame_mistake    in frames on a drawing
compare_tables   two tables: one robot or two
found_mistakes   what the first three share
planting         mistakes in tables
planted_matrices mistakes in matrices
"""
