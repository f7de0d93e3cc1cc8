"""What needs a database: launches, students, lecturers, publishers and the administrator."""
