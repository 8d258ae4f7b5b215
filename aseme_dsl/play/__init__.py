"""Play: the scenarios of a system, with stand-ins for activities, in virtual time."""
