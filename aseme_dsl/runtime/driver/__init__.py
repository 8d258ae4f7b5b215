"""Driver: what lets a team go on, in real or in virtual time."""
