"""Service: what a node does for the machine that runs it: notices, the health endpoint, exported metrics."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import ExitStack, contextmanager
from typing import TYPE_CHECKING

from aseme_dsl.project.operating.endpoint import Address, Page, json_page, serving
from aseme_dsl.project.operating.health import LOOK, Looker
from aseme_dsl.project.operating.measures import CONTENT_TYPE, as_text, measures
from aseme_dsl.project.operating.notifying import Notifier
from aseme_dsl.project.playing.play import PlayError

if TYPE_CHECKING:
    from aseme_dsl.runtime.control.recent import Recent
    from aseme_dsl.runtime.control.replies import Reply
    from aseme_dsl.runtime.team.team import Team

PINGS = 3
"""So many pings in each period of the watchdog."""


@contextmanager
def served(
    team: Team, recent: Recent, address: Address | None, otel: bool, tell: Callable[[str], None]
) -> Iterator[None]:
    """Inside, the service manager is notified, and the endpoint answers; `tell` is given its address.

    Raises:
        PlayError: the endpoint or the export of metrics cannot be had.
    """
    from aseme_dsl.diagnostics.problems.running import NotPlayed
    from aseme_dsl.runtime.control.status import status_of

    notifier = Notifier()
    pause = LOOK if notifier.watchdog is None else min(LOOK, notifier.watchdog / PINGS)
    looker = Looker(team, notifier.see, pause)

    def status() -> Reply:
        return status_of(team, None, recent, None)

    def health() -> Page:
        found = looker.health
        reply = status()
        return json_page(
            200 if found.is_ready else 503,
            {
                "ready": found.is_ready,
                "alive": found.is_alive,
                "problems": list(found.reasons()),
                "notes": list(found.notes),
                "system": reply["system"],
                "model": reply["model"],
                "agents": [agent["name"] for agent in reply["agents"]],
            },
        )

    def alive() -> Page:
        found = looker.health
        return json_page(200 if found.is_alive else 503, {"alive": found.is_alive})

    def metrics() -> Page:
        return Page(200, CONTENT_TYPE, as_text(measures(status(), looker.health)))

    with ExitStack() as stack:
        if address is not None:
            pages = {"/health": health, "/alive": alive, "/metrics": metrics}
            try:
                mine = stack.enter_context(serving(address, pages))
            except OSError as problem:
                reason = f"the health endpoint {address} cannot be used: {problem.strerror or problem}"
                raise PlayError(NotPlayed(reason)) from problem
            tell(f"health: {mine}")
        if otel:
            from aseme_dsl.project.operating.otel import ExportError, exporting

            try:
                stack.enter_context(exporting(lambda: measures(status(), looker.health), team.system))
            except ExportError as problem:
                raise PlayError(NotPlayed(str(problem))) from problem
        if address is not None or notifier.is_wanted or otel:
            looker.begin()
            stack.callback(looker.close)
            stack.callback(notifier.stopping)
        yield


__all__ = ["served"]
