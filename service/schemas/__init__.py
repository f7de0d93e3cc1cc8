"""Shapes that several calls share: strict pydantic models, and nothing computed."""
