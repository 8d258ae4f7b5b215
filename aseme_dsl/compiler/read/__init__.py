"""Read: a file and what it imports, its declarations, and what is remembered of them."""
