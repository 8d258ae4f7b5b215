"""The language: a text in, a tree or mistakes out."""
