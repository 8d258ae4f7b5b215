"""Names: what the declarations and paths of all files mean."""
