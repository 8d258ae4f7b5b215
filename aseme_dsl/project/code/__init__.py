"""Code: the Python of activities and functions, checked and begun."""
