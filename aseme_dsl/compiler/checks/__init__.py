"""Checks: what is looked for in the finished models; nothing is made from what they find."""
