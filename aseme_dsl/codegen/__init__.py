"""Codegen: models to Python, descriptors and `.proto` text; shared by every backend."""
