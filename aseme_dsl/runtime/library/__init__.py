"""Library: the Python functions behind the standard library of the language. All are pure."""
