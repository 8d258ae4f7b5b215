"""Behaviours described once, as data, for every engine that the benchmarks compare."""
