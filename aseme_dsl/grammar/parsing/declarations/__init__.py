"""Declarations: one file a subject, from the objects that textX makes to the tree."""
