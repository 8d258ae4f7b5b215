"""Typing: what may come next where somebody types."""
