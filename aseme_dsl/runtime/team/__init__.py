"""Team: agents together: from the start of a run to its end, and swaps between."""
