"""PDF: several drawings as the pages of one file."""

from __future__ import annotations

from collections.abc import Sequence
from io import BytesIO

from aseme_dsl.diagrams.rendering.layout import DrawingFailed


def joined(pages: Sequence[tuple[str, bytes]]) -> bytes:
    """One PDF of several, in their order, with a bookmark for each. `pages` are file names and contents.

    Raises DrawingFailed if there are several and the package pypdf is not installed.
    """
    if len(pages) == 1:
        return pages[0][1]
    try:
        from pypdf import PdfReader, PdfWriter
    except ImportError as error:
        raise DrawingFailed(
            f"one PDF of {len(pages)} drawings needs the package pypdf: pip install 'aseme-dsl[pdf]'; "
            "without it, name a directory instead"
        ) from error
    writer = PdfWriter()
    for name, content in pages:
        writer.append(PdfReader(BytesIO(content)), outline_item=name.removesuffix(".pdf"))
    file = BytesIO()
    writer.write(file)
    return file.getvalue()


__all__ = ["joined"]
