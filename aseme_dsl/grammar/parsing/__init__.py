"""Parsing: the rules of the grammar, and a file read by them."""
