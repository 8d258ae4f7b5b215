"""Playing: teams run, followed and operated."""
