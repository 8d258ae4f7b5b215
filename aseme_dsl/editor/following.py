"""Following: a page in a browser that shows the model that the cursor of an editor is in."""

from __future__ import annotations

import asyncio
from collections.abc import Awaitable, Callable, Coroutine, Mapping
from typing import Generic, TypeVar

from aseme_dsl.diagrams import GraphvizMissing
from aseme_dsl.editor.answers.diagram import LiveDrawing
from aseme_dsl.editor.files.view import View
from aseme_dsl.editor.viewer import Viewer, page_state
from aseme_dsl.source import Span

PAUSE = 0.05
"""Seconds for which the cursor has to stay where it is."""

Place = TypeVar("Place")
Drawn = tuple[View, LiveDrawing]


class Page(Generic[Place]):
    """The page. `drawn` gives the picture for a place in a file, `go` takes the editor to one.

    It belongs to the event loop that it is made in.
    """

    def __init__(
        self,
        drawn: Callable[[str, Place], Awaitable[Drawn | None]],
        go: Callable[[View, Span], Coroutine[object, object, None]],
    ) -> None:
        loop = asyncio.get_running_loop()

        def acted(said: Mapping[str, object]) -> None:
            loop.call_soon_threadsafe(self.act, said)

        self.viewer = Viewer(acted)
        self._drawn = drawn
        self._go = go
        self._place: tuple[str, Place] | None = None
        self._shown: Drawn | None = None
        self._soon: asyncio.TimerHandle | None = None
        self._tasks: set[asyncio.Task[None]] = set()
        self.viewer.show(page_state(title="Move the cursor into a model."))

    def moved(self, uri: str, place: Place) -> None:
        """The cursor is somewhere else: draw that, if it stays there for a moment."""
        self._place = (uri, place)
        self.renew()

    def renew(self) -> None:
        """Something has changed."""
        if self._soon is not None:
            self._soon.cancel()
        self._soon = asyncio.get_running_loop().call_later(PAUSE, lambda: self._run(self._show()))

    def act(self, said: Mapping[str, object]) -> None:
        """Carry out a click of the user: go to the place in the text."""
        match said:
            case {"act": "click", "id": str(element)} if self._shown is not None:
                view, picture = self._shown
                if element in picture.elements:
                    self._run(self._go(view, picture.elements[element]))
                    self.viewer.show(page_state(picture, here=element))

    async def _show(self) -> None:
        if self._place is None:
            return
        try:
            found = await self._drawn(*self._place)
        except GraphvizMissing as missing:
            self.viewer.show(page_state(title=str(missing)))
            return
        if found is not None:  # else what was there before stays
            self._shown = found
            self.viewer.show(page_state(found[1], here=found[1].here))

    def _run(self, work: Coroutine[object, object, None]) -> None:
        task = asyncio.ensure_future(work)
        self._tasks.add(task)
        task.add_done_callback(self._tasks.discard)


__all__ = ["Page"]
