"""Statecharts for other tools: lowered once for those that run them, and one file a format."""
