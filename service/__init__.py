"""The HTTP service: translate, call, translate back."""

__version__ = "0.1.0"
