"""Settings: what a project and a command line say, and what it is about."""
