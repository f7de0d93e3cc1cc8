"""How other programs and files of students reach the grader: each adapter translates, one function judges.

`table_files` reads a table as a course writes it, by its `column_titles` and `class_rows` (`workbooks` and
`workbook_extent` those of spreadsheets), `hand_ins` the files of a whole class, `judging` grades an answer,
and each other module speaks the protocol of one host.
"""
