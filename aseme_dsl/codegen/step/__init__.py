"""Step: a statechart as the class that an agent runs."""
