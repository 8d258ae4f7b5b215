"""Files: the files that an editor has open, with what is known of them."""
