"""Tables in Markdown that can be read as they are, too: the cells of a column are as wide as the widest."""

# tabulate is not shorter to call, and marks columns of texts as `:---`.

from __future__ import annotations

from collections.abc import Iterator, Sequence


def table(head: Sequence[str], rows: Sequence[Sequence[str]], texts: int | None = None) -> Iterator[str]:
    """The lines of a table. The first `texts` columns stand left, the others, which are numbers, right."""
    texts = len(head) if texts is None else texts
    widths = [max(3, *map(len, column)) for column in zip(head, *rows, strict=True)]
    places = ["<" if number < texts else ">" for number in range(len(head))]
    yield _line(head, widths, places)
    marks = [
        ("-" * (width + 1)) + ("-" if place == "<" else ":")
        for width, place in zip(widths, places, strict=True)
    ]
    yield f"|{'|'.join(marks)}|"
    for row in rows:
        yield _line(row, widths, places)


def _line(cells: Sequence[str], widths: Sequence[int], places: Sequence[str]) -> str:
    padded = (f"{cell:{place}{width}}" for cell, width, place in zip(cells, widths, places, strict=True))
    return f"| {' | '.join(padded)} |"


__all__ = ["table"]
