"""Project: one on disk: what is read, what is written where, and what is played."""
