"""Where the standard library's `.aseme` files are: in a checkout, or in an installed package."""

from __future__ import annotations

from pathlib import Path

_PACKAGE = Path(__file__).resolve().parent


def standard_library() -> Path:
    """Return the folder of the standard library; `import soccer` means `soccer.aseme` in it.

    A wheel has the files in `aseme_dsl/_stdlib`, a checkout in `stdlib` at its root. The wheel's place is
    tried first: a folder `stdlib` beside an installed package is not ours.

    Raises:
        FileNotFoundError: The installation is incomplete: the folder is in neither place.
    """
    for folder in (_PACKAGE / "_stdlib", _PACKAGE.parent / "stdlib"):
        if folder.is_dir():
            return folder
    raise FileNotFoundError(f"the standard library of aseme-dsl is missing beside {_PACKAGE}")
