"""One behaviour suite for everything that executes a model: a text, inputs, and what must happen."""
