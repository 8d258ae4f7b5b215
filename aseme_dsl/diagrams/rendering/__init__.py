"""Rendering: Graphviz as a program of its own, and the files that it makes."""
