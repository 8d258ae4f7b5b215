"""What is proved of the library and of the examples: the cases of the page of certificates."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

from aseme_dsl.project.building.project import compile_root
from aseme_dsl.project.proving.prove import prove, prove_alone
from aseme_dsl.project.proving.results import Result
from aseme_dsl.project.proving.scopes import PREFIX, scope_of
from aseme_dsl.proofs.explore.search import Limits
from aseme_dsl.records import dataclass
from aseme_dsl.source import Source
from aseme_dsl.standard_library import standard_library

ROOT = Path(__file__).parents[2]
FOREVER = 1e9
"""No search is cut by the time that it takes: answers are the same on every machine."""


@dataclass(frozen=True, slots=True)
class Case:
    """A protocol of the library, or an example, under what is assumed.

    With `harsh`, data may be lost, and one of the agents that there are several of crashes, else the last
    one. `states` is how far the search goes.
    """

    what: str
    file: str
    protocol: str | None = None
    robots: int = 3
    harsh: bool = False
    states: int = 4000

    @property
    def under(self) -> str:
        return "data may be lost, one agent crashes" if self.harsh else "any delay"


LIBRARY = {
    "protocols": (
        *("request", "query", "request_when", "contract_net", "iterated_contract_net", "subscribe"),
        *("auction", "dutch_auction", "propose", "brokering", "recruiting"),
    ),
    "resources": ("resource",),
}
EXAMPLES = ("auction", "cell", "goalie", "home", "hospital", "meetings", "patrol", "robocup", "warehouse")


def cases() -> Iterator[Case]:
    for file, protocols in LIBRARY.items():
        for name in protocols:
            for harsh in (False, True):
                yield Case(name, file, name, harsh=harsh)
    for name in EXAMPLES:
        yield Case(name, f"examples/{name}")


def answers(case: Case) -> tuple[Result, ...]:
    """What is proved in a case."""
    limits = Limits(case.states, FOREVER)
    if case.protocol is None:
        return prove(compile_root(ROOT / case.file), (), case.robots, limits)
    library = Source(f"{case.file}.aseme", f'system Certified\nimport {case.file}\n')
    compiled = compile_root(library)
    assert compiled.system is not None, compiled.diagnostics
    aip = next(item for item in compiled.system.aips if item.name == case.protocol)
    scope = scope_of(library, aip, case.robots)
    if case.harsh:
        assert isinstance(scope.root, Source)
        role = f"{PREFIX}{aip.participants[-1].name}"
        said = f'property "surroundings" {{ assume network loss 10%  assume at most 1 of {role} crash }}\n'
        scope = replace(scope, root=Source(scope.root.path, scope.root.text + said))
    return prove_alone(scope, compiled, limits)
