"""The wire's shapes: strict pydantic models, and nothing computed."""
