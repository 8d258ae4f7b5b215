"""Machines of SCXML and XState: import, and play."""
