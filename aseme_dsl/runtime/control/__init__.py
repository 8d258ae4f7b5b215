"""Control: what an operator may ask of a running team, and who may."""
