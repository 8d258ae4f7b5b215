"""Busy: whether what `plays … when busy` answers to invitations can be said (E596)."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence

from aseme_dsl.amola.aip import Aip, Participant, Plays
from aseme_dsl.amola.srm import Srm
from aseme_dsl.amola.statechart import Statechart
from aseme_dsl.codegen.opening import openings_of
from aseme_dsl.compiler.read.builtins import NOT_UNDERSTOOD
from aseme_dsl.diagnostics import Diagnostic, Related
from aseme_dsl.diagnostics.problems.talk import AnswersDiffer, AnswerWithoutContent, NeverInvited


def check_busy(
    aips: Sequence[Aip], eacs: Mapping[str, Statechart | None], srms: Iterable[Srm]
) -> Iterator[Diagnostic]:
    """E596 where nothing invites a participant, its answer has no content, or two answers differ."""
    parts = {(aip.name, part.name): part for aip in aips for part in aip.participants}
    players = (*(part.plays for part in parts.values()), *(srm.plays for srm in srms))
    seen: set[object] = set()
    for plays in players:
        for item in plays:
            if item.busy is not None and item.busy.span not in seen:
                seen.add(item.busy.span)
                part, eac = parts.get((item.protocol, item.participant)), eacs.get(item.protocol)
                if part is not None and eac is not None:
                    yield from _answer(item, part, eac)
                    yield from _others(item, plays)


def _answer(item: Plays, part: Participant, eac: Statechart) -> Iterator[Diagnostic]:
    busy = item.busy
    assert busy is not None
    openings = openings_of(eac, part)
    if not openings:
        yield Diagnostic(NeverInvited(part.name), busy.span, (Related(part.span, "the participant"),))
    elif busy.fills is None and busy.performative not in ("", NOT_UNDERSTOOD):
        others = [" ".join(said) for said in openings if said[1] != busy.message]
        if others:
            problem = AnswerWithoutContent(busy.performative, busy.message, others[0])
            yield Diagnostic(problem, busy.span)


def _others(item: Plays, plays: Sequence[Plays]) -> Iterator[Diagnostic]:
    """The same participant under another name, which answers in another way."""
    for other in plays:
        if other is item:
            return
        if (other.protocol, other.participant) != (item.protocol, item.participant):
            continue
        if other.busy is not None and item.busy is not None and other.busy.text != item.busy.text:
            related = (Related(other.busy.span, "the other answer"),)
            yield Diagnostic(AnswersDiffer(item.participant), item.busy.span, related)
            return


__all__ = ["check_busy"]
