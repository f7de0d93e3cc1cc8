"""The HTTP service: translate, call, translate back."""
