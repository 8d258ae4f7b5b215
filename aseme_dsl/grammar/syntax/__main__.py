"""Writes every file that follows from the grammar into a checkout of the project."""

from __future__ import annotations

from pathlib import Path

from aseme_dsl.grammar.syntax import files

ROOT = Path(__file__).resolve().parents[3]


def main() -> None:
    """Write what has changed, and say so."""
    for name, text in files().items():
        path = ROOT / name
        if not path.exists() or path.read_text(encoding="utf-8") != text:
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text, encoding="utf-8", newline="\n")
            print(f"wrote {name}")


if __name__ == "__main__":
    main()
