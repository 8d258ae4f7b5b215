"""An independent interpreter of the semantics, and random charts on which the generated code must agree."""
