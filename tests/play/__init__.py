"""Tests of what plays, and plays again."""
