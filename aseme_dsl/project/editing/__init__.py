"""Editing: changes of source files: layout, repairs, skeletons, new projects."""
