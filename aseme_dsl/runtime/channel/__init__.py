"""Channel: what is published reaches whom it concerns, and some of it is kept."""
