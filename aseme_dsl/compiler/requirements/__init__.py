"""Requirements: goals, use cases, and what follows from them for protocols and roles."""
