"""Testing: the scenarios of a system, played, and what each has shown."""
