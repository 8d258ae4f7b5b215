"""Plain: statecharts for programs without agents."""
