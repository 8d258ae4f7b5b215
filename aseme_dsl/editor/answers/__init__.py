"""Answers: one file a kind of question of an editor."""
