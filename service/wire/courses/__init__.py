"""What students and lecturers are shown of a course, and what a platform keeps of a link."""
