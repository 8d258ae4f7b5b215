"""What is proved of the library and of the examples: the cases of the page of certificates."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

from aseme_dsl.project.building.project import compile_root, inputs_of
from aseme_dsl.project.proving.prove import prove, prove_alone
from aseme_dsl.project.proving.results import Bounds, Result, Verdict
from aseme_dsl.project.proving.scopes import role_of, scope_of
from aseme_dsl.project.proving.searches import EACH_ALONE
from aseme_dsl.proofs.explore.search import Limits
from aseme_dsl.records import dataclass
from aseme_dsl.source import Source

ROOT = Path(__file__).parents[2]
PAGE = ROOT / "docs/reference/certificates.md"
FOREVER = 1e9
"""No search is cut by the time that it takes: answers are the same on every machine."""
QUICK = ("propose", "examples/goalie", "examples/cell")
"""What is proved again in every run of the tests; the others in the long lane."""
_LONGEST = 160
"""A reason is cut behind so many letters."""


@dataclass(frozen=True, slots=True)
class Case:
    """A protocol of the library, or an example, under what is assumed.

    With `harsh`, data may be lost, and one agent of the last participant crashes. Each search ends with so
    many `states`.
    """

    name: str
    file: str
    protocol: str | None = None
    robots: int = 3
    harsh: bool = False
    states: int = 1000

    @property
    def title(self) -> str:
        """`request`, or `request, with loss and a crash`, or `auction, one of each`."""
        few = ", one of each" if self.protocol in _GROUPS and self.robots == 1 else ""
        return f"{self.name}{few}{', with loss and a crash' if self.harsh else ''}"


_PAIRS = ("request", "query", "request_when", "subscribe", "propose", "resource")
_GROUPS = ("contract_net", "iterated_contract_net", "auction", "dutch_auction", "brokering", "recruiting")
_OF_ONE = ("contract_net", "auction")
"""Those that are explored as a whole if there is one agent of each participant."""
_EXAMPLES = ("auction", "cell", "goalie", "home", "hospital", "meetings", "patrol", "robocup", "warehouse")


def cases() -> Iterator[Case]:
    """All cases, in the order of the page."""
    for name in (*_PAIRS, *_GROUPS):
        file = "resources" if name == "resource" else "protocols"
        for harsh in (False, True):
            yield Case(name, file, name, harsh=harsh, states=3000 if name in _PAIRS else 1000)
    for name in _OF_ONE:
        for harsh in (False, True):
            yield Case(name, "protocols", name, robots=1, harsh=harsh, states=3000)
    for name in _EXAMPLES:
        yield Case(f"examples/{name}", f"examples/{name}")


def answers(case: Case) -> tuple[Result, ...]:
    """What is proved in a case."""
    limits = Limits(case.states, FOREVER)
    if case.protocol is None:
        (root,) = inputs_of([str(ROOT / case.file)], bytes).roots
        return prove(compile_root(root), (), case.robots, limits)
    source = Source("certified.aseme", f"system Certified\nimport {case.file}\n")
    compiled = compile_root(source)
    assert compiled.system is not None, compiled.diagnostics
    aip = next(item for item in compiled.system.aips if item.name == case.protocol)
    scope = scope_of(source, aip, case.robots)
    if case.harsh:
        assert isinstance(scope.root, Source)
        role = role_of(aip.name, aip.participants[-1].name)
        said = f'property "surroundings" {{ assume network loss 10%  assume at most 1 of {role} crash }}\n'
        scope = replace(scope, root=Source(source.path, scope.root.text + said))
    return prove_alone(scope, compiled, limits)


def section(case: Case) -> str:
    """What the page says of a case: a table for all answers with the same bounds."""
    tables: dict[str, list[str]] = {}
    for item in answers(case):
        of = f"{item.of}: `{replace(item.bounds, states=None).text}`"
        states = "" if item.bounds.states is None else str(_size(item.bounds, case.states))
        line = f"| {_plain(item.name)} | {item.verdict} | {states} | {_plain(item.reason)} |"
        tables.setdefault(f"{of[0].upper()}{of[1:]}", []).append(line)
    head = ["| question | verdict | states | reason |", "| --- | --- | --- | --- |"]
    parts = ("\n".join([of, "", *head, *lines]) for of, lines in tables.items())
    return "\n\n".join([f"### {case.title}", *parts]) + "\n"


def _size(bounds: Bounds, limit: int) -> int:
    """How many states there are; those of the last moves of a search that was cut make no difference."""
    assert bounds.states is not None
    return bounds.states if EACH_ALONE in bounds.parts else min(bounds.states, limit)


def _plain(text: str) -> str:
    """A text in a table, not too long, without the places in files."""
    text = re.sub(r" \([\w./-]+\.aseme:[0-9:]+\)", "", text)
    text = text.replace("; abstract: ", ". Abstract: ")
    if len(text) > _LONGEST:
        text = text[:_LONGEST].rsplit(" ", 1)[0]
        text = f"{text} …`" if text.count("`") % 2 else f"{text} …"
    parts = text.split("`")
    parts[::2] = [part.replace("<", "&lt;") for part in parts[::2]]
    return "`".join(parts).replace("|", "\\|")


def written(page: str) -> dict[str, str]:
    """The sections of the page, by their titles."""
    parts = re.split(r"(?m)^(?=### )", page)[1:]
    return {
        part.split("\n", 1)[0].removeprefix("### "): re.sub(r"(?ms)^## .*", "", part).rstrip()
        for part in parts
    }


def counted(page: str) -> str:
    """`81 proved, 20 refuted, 103 undecided`."""
    counts = {verdict: len(re.findall(rf"\| {verdict} \|", page)) for verdict in Verdict}
    return ", ".join(f"{counts[verdict]} {verdict.lower()}" for verdict in Verdict)
