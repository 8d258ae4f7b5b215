"""Interop: one file a foreign format, each way."""
