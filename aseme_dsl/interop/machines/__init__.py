"""State machines of SCXML and XState: read into one form, and written as a `statechart`."""
