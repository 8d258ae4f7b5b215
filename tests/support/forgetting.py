"""What finished tests have imported is forgotten: it makes each import slower to remember thousands."""

from __future__ import annotations

import sys
import tempfile
import weakref
from pathlib import Path

_left: set[str] = set()
"""Packages that no test can ask for any more."""


def forget_with(owner: object, package: str) -> None:
    """Have a package forgotten when its owner is gone and the file of the test has ended."""
    weakref.finalize(owner, _left.add, package).atexit = False


def forget_folders(root: Path) -> None:
    """Have Python look again at what is in a folder."""
    for place in [place for place in list(sys.path_importer_cache) if place.startswith(str(root))]:
        sys.path_importer_cache.pop(place, None)


def forget_what_is_left() -> None:
    """Forget what the tests of a file have left: what one holds may import more as long as it lasts."""
    left = frozenset(_left)
    _left.difference_update(left)
    for name in list(sys.modules):
        package = name.partition(".")[0]
        if package in left or package.startswith("aseme_activities_"):
            sys.modules.pop(name, None)
    forget_folders(Path(tempfile.gettempdir()))
