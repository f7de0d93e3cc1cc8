"""Requests that were seen to cost too much, and their neighbours."""
