"""Activity: the code of the user: its context, its starts and its ends."""
