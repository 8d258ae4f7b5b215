"""The compact drawing of a statechart: one line from state to state, laid out like a railroad diagram."""
