"""Codegen: statecharts to step classes and plans, expressions to Python; shared by every backend."""
