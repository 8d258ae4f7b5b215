"""`python -m aseme_dsl` is `asemec`."""

from __future__ import annotations

import sys

from aseme_dsl.cli import main

if __name__ == "__main__":
    sys.exit(main())
