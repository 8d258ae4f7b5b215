"""World: the bodies of agents, and the simulated world that moves them."""
