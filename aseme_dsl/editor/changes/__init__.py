"""Changes: refactorings and quick fixes."""
