"""Ink: a compact drawing as SVG, and as what Graphviz makes PNG and PDF of."""
