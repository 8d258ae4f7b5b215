"""Control: the lines of `control` blocks on the arrows of a chart."""
