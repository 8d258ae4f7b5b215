"""Driver: what advances a team, in real or in virtual time."""
