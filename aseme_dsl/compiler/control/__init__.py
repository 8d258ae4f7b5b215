"""Control: the lines of `control` blocks on the transitions of a chart."""
