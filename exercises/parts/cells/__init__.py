"""What students write in several kinds of question: numbers, matrices, names; how entries are compared."""
