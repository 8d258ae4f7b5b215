"""Formula: liveness formulas, checked and expanded to states."""
