"""Files: what is read and written on disk, never over what is not ours."""
