"""What the desk and the carriers do."""
