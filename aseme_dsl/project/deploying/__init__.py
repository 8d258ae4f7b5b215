"""Deployment: certificates of a team, bundles for its robots, and how they come to their hosts."""
