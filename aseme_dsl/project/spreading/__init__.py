"""Spreading: many runs in virtual time, in processes beside each other or on the workers of a cluster."""
