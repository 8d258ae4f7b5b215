"""Plain: a statechart as a class for programs without agents."""
