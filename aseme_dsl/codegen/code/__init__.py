"""Code: expressions and statements of Python as data, and how they are written."""
