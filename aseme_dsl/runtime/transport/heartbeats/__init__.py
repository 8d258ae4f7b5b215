"""Heartbeats: datagrams that show whether agents on several machines reach each other."""
