"""Reading: the texts of an editor, read within a budget."""
