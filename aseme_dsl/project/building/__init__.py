"""Building: everything that follows from a system, into a folder."""
