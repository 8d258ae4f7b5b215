"""Text: characters, tokens and the tree of a file."""
