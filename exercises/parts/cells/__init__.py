"""What students write in several kinds of question: numbers, matrices, names; how entries are compared.

number_cells     numbers
short_forms      one cell of a matrix: c1, s23 and what a table's cell may hold
matrix_cells     matrices and rows of cells
symbolic_matrix  a matrix of expressions, and what its decimals leave open
exactness        how exactly an answer in names holds
mixed_lengths    lengths by name here and in numbers there
comparison       matrices against each other, cell by cell
by_name          answers that name their lengths, at other lengths
"""
