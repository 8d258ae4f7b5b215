"""Together: statements of one scenario that do not go together (E230)."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence

from aseme_dsl.diagnostics import Diagnostic, Related
from aseme_dsl.diagnostics.problems.scenarios import statements as problems
from aseme_dsl.grammar.text import statements as nodes
from aseme_dsl.grammar.text import tree
from aseme_dsl.source import Span

_ONCE = ("for", "network", "world", "stepwise")


def check_together(statements: Sequence[nodes.Statement], agents: Mapping[str, str]) -> Iterator[Diagnostic]:
    """What does not go together in a scenario in which these agents take part."""
    yield from _twice(statements)
    yield from _taking_part(statements)
    yield from _crashes(statements)
    yield from _ends(statements)
    yield from _by_hand(statements)
    for item in statements:
        match item:
            case nodes.Table(rows=()):
                yield Diagnostic(problems.EmptyTable(), item.span)
            case nodes.Simulated(is_real=True) if _does_more(item):
                yield Diagnostic(problems.RealAndSimulated(item.activity.text), item.span)
            case nodes.Hit():
                yield Diagnostic(problems.HitWithoutMoment(), item.span)
            case nodes.Timed(event=nodes.Hit(groups=groups) as hit) if groups:
                yield from _groups(hit, agents)
            case _:
                pass


def _twice(statements: Iterable[nodes.Statement]) -> Iterator[Diagnostic]:
    """What is said once."""
    first: dict[str, Span] = {}
    for item in statements:
        match item:
            case nodes.Setup(word=word) if word in _ONCE:
                what = word
            case nodes.Simulated(activity=activity):
                what = f"activity {activity.text}"
            case nodes.Table():
                what = "table"
            case _:
                continue
        if (place := first.setdefault(what, item.span)) != item.span:
            yield Diagnostic(problems.StatedTwice(what), item.span, (Related(place, "the first one"),))


def _taking_part(statements: Iterable[nodes.Statement]) -> Iterator[Diagnostic]:
    first: dict[str, Span] = {}
    for item in statements:
        if not isinstance(item, nodes.TakesPart):
            continue
        for name, bounds in item.agents:
            numbers = [""] if bounds is None else range(bounds[0], bounds[1] + 1)
            for agent in (f"{name.text}{number}" for number in numbers):
                if (place := first.setdefault(agent, name.span)) != name.span:
                    related = (Related(place, "the first time"),)
                    yield Diagnostic(problems.TakesPartTwice(agent), name.span, related)
                    break


def _crashes(statements: Iterable[nodes.Statement]) -> Iterator[Diagnostic]:
    """At one moment, stimuli come in the order of the text."""
    hits = [
        (item.times[0], item.event)
        for item in statements
        if isinstance(item, nodes.Timed) and item.word == "at" and isinstance(item.event, nodes.Hit)
        if item.event.word in ("crash", "restart")
    ]
    down: set[str] = set()
    for moment, hit in sorted(hits, key=lambda found: found[0].nanoseconds):
        name = hit.agents[0]
        if hit.word == "crash":
            if name.text in down:
                yield Diagnostic(problems.CrashOfCrashed(name.text), hit.span)
            down.add(name.text)
        elif name.text in down:
            down.remove(name.text)
        else:
            yield Diagnostic(problems.RestartWithoutCrash(name.text, moment.span.text), hit.span)


def _ends(statements: Iterable[nodes.Statement]) -> Iterator[Diagnostic]:
    """What is to be later than the end of the run does not come."""
    ends = [
        item.duration
        for item in statements
        if isinstance(item, nodes.Setup) and item.word == "for" and item.duration is not None
    ]
    if not ends:
        return
    end = ends[0]
    for item in statements:
        match item:
            case nodes.Timed(word="at" | "by" | "from", times=(moment, *_)):
                last = moment
            case nodes.Fails(by=by):
                last = by
            case nodes.Rule(word="no before", within=tree.Duration() as within):
                last = within
            case _:
                continue
        if last.nanoseconds > end.nanoseconds:
            yield Diagnostic(problems.BehindTheEnd(end.span.text), last.span)


def _by_hand(statements: Iterable[nodes.Statement]) -> Iterator[Diagnostic]:
    """In a stepwise scenario, activities end and messages arrive by hand; in no other one."""
    is_stepwise = any(isinstance(item, nodes.Setup) and item.word == "stepwise" for item in statements)
    for item in statements:
        match item:
            case nodes.Timed(event=nodes.Does() | nodes.Gets() | nodes.Computes() as event):
                if not is_stepwise:
                    verb = event.span.text.removeprefix(event.agent.span.text).split()[0]
                    yield Diagnostic(problems.NotStepwise(verb), event.span)
            case nodes.Setup(word="network" | "world" as word) if is_stepwise:
                yield Diagnostic(problems.StepwiseWith(word), item.span)
            case nodes.Simulated() if is_stepwise:
                yield Diagnostic(problems.StepwiseWith("activity"), item.span)
            case _:
                pass


def _groups(hit: nodes.Hit, agents: Mapping[str, str]) -> Iterator[Diagnostic]:
    """Each agent that takes part stands in one group. A role stands for its only agent."""
    playing = {role: agent for agent, role in agents.items()}
    named = Counter(name.text if name.text in agents else playing.get(name.text, "") for name in hit.agents)
    wrong = tuple(agent for agent in agents if named[agent] != 1)
    if wrong and "" not in named:
        yield Diagnostic(problems.OutsideGroups(wrong), hit.span)


def _does_more(item: nodes.Simulated) -> bool:
    return bool(item.takes or item.ends or item.fails or item.writes or item.sends or item.sets)


__all__ = ["check_together"]
