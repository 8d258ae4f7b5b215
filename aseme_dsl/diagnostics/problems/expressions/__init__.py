"""Problems of expressions: what is wrong with paths, values, and what functions and activities are given."""
