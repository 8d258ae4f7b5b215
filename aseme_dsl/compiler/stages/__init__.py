"""Stages: what each part of the compilation makes of those before it; `phases.py` has their order."""
