"""Typing: what may come next where the author types."""
