"""What the backends for agents have in common: the same plans, step classes, messages and activities."""
