"""Agent: one agent with its statechart, alone or as behaviours."""
