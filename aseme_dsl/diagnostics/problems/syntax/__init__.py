"""Problems of syntax: what cannot be read in the text of a file."""
