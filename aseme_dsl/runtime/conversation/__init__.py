"""Conversation: protocols while they run, and the directory of agents."""
