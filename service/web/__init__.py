"""The student web form: its pages and the files they load."""
