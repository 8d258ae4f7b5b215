"""Delivery: the parts of the reliable delivery between processes."""
