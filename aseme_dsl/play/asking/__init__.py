"""Asking: why an agent is somewhere, and why it is not; tried out on the state that a trace tells."""
