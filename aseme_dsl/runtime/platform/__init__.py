"""Platform: agent platforms that carry messages."""
