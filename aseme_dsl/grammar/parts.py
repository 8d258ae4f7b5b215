"""Parts: a file as a sequence of texts that are read one by one, so that what stays is not read again.

The tree of a part has spans in the part; a `Layout` says where in the file each part begins.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace

from aseme_dsl.diagnostics import Diagnostic, Edit, Related
from aseme_dsl.source import Source, Span


@dataclass(frozen=True, slots=True)
class Layout:
    """The file of each part, and the offset at which it begins there; other texts are their own files."""

    places: Mapping[Source, tuple[Source, int]] = field(default_factory=dict)

    def whole(self, span: Span) -> Span:
        """The same place in the file."""
        place = self.places.get(span.source)
        if place is None:
            return span
        file, base = place
        return Span(file, span.start + base, span.end + base)

    def parts_of(self, file: Source) -> tuple[tuple[int, Source], ...]:
        """The parts of a file, each with the offset at which it begins; empty if it was read in one piece."""
        return tuple((base, part) for part, (other, base) in self.places.items() if other is file)

    def diagnostic(self, item: Diagnostic) -> Diagnostic:
        """The same with all its places in files."""
        spans = [item.span, *(other.span for other in item.related), *(edit.span for edit in item.edits)]
        if not any(span is not None and span.source in self.places for span in spans):
            return item
        return replace(
            item,
            span=None if item.span is None else self.whole(item.span),
            related=tuple(Related(self.whole(other.span), other.message) for other in item.related),
            edits=tuple(Edit(self.whole(edit.span), edit.text) for edit in item.edits),
        )


NO_PARTS = Layout()
"""Of files that were read in one piece."""
