"""The certificate of the compiler: every chart is what its source says, and a fault in a chart is noticed."""

from __future__ import annotations

import os
import random
from collections import Counter
from dataclasses import replace
from pathlib import Path

import pytest
from hypothesis import given, settings

from aseme_dsl.amola.liveness import Formula, ungrouped
from aseme_dsl.amola.operators import Operator
from aseme_dsl.amola.statechart import Statechart, TransitionKind, transition_text
from aseme_dsl.amola.system import System
from aseme_dsl.compiler import Options
from aseme_dsl.compiler.phases import Inspection, inspect_files
from aseme_dsl.project.building.certified import certificates_of, claims_of
from aseme_dsl.proofs.certificate.certify import NotCertified, certify
from aseme_dsl.proofs.certificate.derivative import Again, Either, Reached, Word, word_of
from aseme_dsl.source import Source
from tests.compiler.models.test_language_of_charts import LETTERS, formulas
from tests.oracle.charts import text as random_text
from tests.oracle.choices import Choices
from tests.support import derivatives
from tests.support.chart_faults import Fault, faults
from tests.support.compiling import system

ROOT = Path(__file__).parents[2]
RANDOM = int(os.environ.get("CERTIFIED_CHARTS", "25"))
PLANTED = int(os.environ.get("CERTIFIED_FAULTS", "150"))
"""How many faults are planted in each system."""

ALL = "CERTIFIED_CHARTS" in os.environ
"""Whether all examples are certified here, too: each test that builds one does it as well."""

EXAMPLES = sorted(
    path
    for pattern in ("examples/*/*.aseme", "tests/acceptance/*.aseme")
    for path in ROOT.glob(pattern)
    if path.name != "relief.aseme"  # another file imports it
    and (ALL or path.name in ("kouretes.aseme", "contract_net.aseme", "testbehavior.aseme", "cell.aseme"))
    and (ALL or "robocup" not in path.parts)
)

LIBRARY = """system Library
import protocols
import resources
srm r { liveness { r = A } }
"""


def inspected(source: Path | str) -> tuple[Inspection, System]:
    """What the compiler makes of a file or a text without errors."""
    root = source if isinstance(source, Path) else Source("test.aseme", source)
    found = inspect_files(root, None, Options())
    assert found.analysis.system is not None, found.analysis.diagnostics
    return found, found.analysis.system


@pytest.mark.parametrize("path", EXAMPLES, ids=lambda path: path.name)
def test_the_charts_of_examples_are_their_formulas(path: Path) -> None:
    found, made = inspected(path)
    certificates = certificates_of(found)
    assert [item.chart.partition(".")[2] for item in certificates] == [c.name for c in made.statecharts]
    assert [item.text for item in certificates] == ["proved"] * len(certificates)


def test_the_charts_of_the_library_are_their_formulas() -> None:
    certificates = certificates_of(inspected(LIBRARY)[0])
    assert {"eac.contract_net", "eac.resource", "eac.auction"} <= {c.chart for c in certificates}
    assert all(item.is_whole for item in certificates)


def test_the_participants_of_a_role_are_those_of_the_protocol() -> None:
    found, _ = inspected(ROOT / "tests/acceptance/kouretes.aseme")
    player = next(item for item in certificates_of(found) if item.chart == "iac.player")
    assert [item.partition(" at ")[0] for item in player.subcharts] == ["attack.center", "attack.center_for"]


def test_random_charts_are_their_formulas() -> None:
    proved = 0
    for seed in range(RANDOM):
        found, _ = inspected(random_text(Choices(seed)))
        proved += sum(item.is_whole for item in certificates_of(found))
    assert proved > RANDOM / 2


def test_what_has_no_formula_is_left_out_by_name() -> None:
    text = """system T
statechart R { state 0 OR "R" state 0.1 START state 0.2 BASIC A state 0.3 END 0.1 -> 0.2 : 0.2 -> 0.3 : }
srm S { liveness { S = A . B } control S { 0.2 -> 0.4 : after(1s)  enter B : after(2s) } }
"""
    by_name = {item.chart: item for item in certificates_of(inspected(text)[0])}
    assert by_name["iac.R"].text == (
        "left out: it is written state by state: there is no formula to compare it with"
    )
    assert by_name["iac.S"].text == "left out: transition 0.2 -> 0.4, which the formula does not have"


# ---- it can fail ---------------------------------------------------------------------------------


def noticed(found: Inspection, made: System, fault: Fault) -> bool:
    """Whether the certificate notices a fault in one of the charts."""
    name, kind = fault.chart.name, fault.chart.kind

    def with_fault(charts: tuple[Statechart, ...]) -> tuple[Statechart, ...]:
        return tuple(fault.chart if (item.name, item.kind) == (name, kind) else item for item in charts)

    wrong = replace(made, eacs=with_fault(made.eacs), iacs=with_fault(made.iacs))
    try:
        certify(wrong, claims_of(found, made))
    except NotCertified as problem:
        assert str(problem).startswith("the statechart of ")
        return True
    return False


SOME = ("kouretes.aseme", "contract_net.aseme", "cell.aseme")


def planted(found: Inspection, made: System, seed: int) -> tuple[Counter[str], list[str]]:
    """How many faults of each kind were planted in the charts of a system, and those that went unnoticed."""
    chosen = [item for chart in made.statecharts if made.srms for item in faults(chart)]
    random.Random(seed).shuffle(chosen)
    missed = [f"{item.kind}: {item.text}" for item in chosen[:PLANTED] if not noticed(found, made, item)]
    return Counter(item.kind for item in chosen[:PLANTED]), missed


@pytest.mark.parametrize("name", SOME)
def test_faults_in_the_charts_of_examples_are_noticed(name: str) -> None:
    path = next(path for path in EXAMPLES if path.name == name)
    kinds, missed = planted(*inspected(path), seed=1)
    assert {"dropped", "doubled", "retargeted", "resourced", "guards", "state"} <= kinds.keys()
    assert missed == []


REACTIVE = """system T
srm R {
  var b : bool
  var c : bool
  liveness {
    R = S
    S = (A . B) | (C || D) | E
  }
  control S reactive {
    enter (A . B) : go / b = true
    enter (C || D) : when [c]
    enter (C || D) : stop
    enter E : hop
    enter E : go / c = true
    enter E : when [b]
    resume (A . B) : else
  }
}
"""


def test_faults_in_a_reactive_choice_are_noticed() -> None:
    found, made = inspected(REACTIVE)
    all_faults = [item for chart in made.statecharts for item in faults(chart)]
    assert len(all_faults) > 150
    assert [f"{item.kind}: {item.text}" for item in all_faults if not noticed(found, made, item)] == []


def test_faults_in_random_charts_are_noticed() -> None:
    missed: list[str] = []
    for seed in range(1000, 1000 + RANDOM // 2):
        found, made = inspected(random_text(Choices(seed)))
        if made.srms:
            missed += planted(found, made, seed)[1]
    assert missed == []


OPTION = """system T
srm R {{ liveness {{ R = A . {} . C }} }}
"""


@pytest.mark.parametrize("other", [" B ", "(B)", "B+ ", "B* "])
def test_another_formula_with_the_same_names_is_noticed(other: str) -> None:
    """`[PassBall]` and `PassBall` have words of the same names."""
    found, made = inspected(OPTION.format("[B]"))
    same = inspected(OPTION.format("[B]"))[1]
    wrong = inspected(OPTION.format(other))[1]
    claims = claims_of(found, made)
    at_home = {id(item.sources[-1]): made.sources[-1] for item in (same, wrong)}

    def here(chart: Statechart) -> Statechart:
        states = tuple(
            replace(item, span=replace(item.span, source=at_home[id(item.span.source)]))
            for item in chart.states
        )
        transitions = tuple(
            replace(item, span=replace(item.span, source=at_home[id(item.span.source)]))
            for item in chart.transitions
        )
        variables = chart.variables
        return replace(chart, states=states, transitions=transitions, variables=variables)

    assert certify(replace(made, iacs=tuple(map(here, same.iacs))), claims)
    with pytest.raises(NotCertified, match="the statechart of R"):
        certify(replace(made, iacs=tuple(map(here, wrong.iacs))), claims)


# ---- the derivatives are those of the formula ----------------------------------------------------


def language(word: Word) -> derivatives.Language:
    """The language of the activities in a word: what does not end in END goes on forever."""
    found = derivatives.DONE
    is_last = True
    for item in reversed(word):
        match item:
            case Again(word=inner):
                found = derivatives.seq(("forever" if is_last else "loop", language((*inner, *END))), found)
            case Either(words=words):
                found = derivatives.seq(derivatives.either(*map(language, words)), found)
            case _:
                part = derivatives.DONE
                if item.reached is Reached.TERM:
                    part = of_term(item.what)
                elif item.reached is Reached.AND:
                    times = item.what.count or 1
                    for operand in item.what.operands * times:
                        part = derivatives.both(of_term(operand), part)
                found = derivatives.seq(part, found)
        is_last = False
    return found


END: Word = (Either(((),)),)


def of_term(term: Formula) -> derivatives.Language:
    term = ungrouped(term)
    return ("do", term.name) if term.operator is Operator.NAME else language(word_of(term, frozenset()))


@given(formulas(3))
@settings(max_examples=40)
def test_the_derivatives_have_the_words_of_the_formula(formula: tuple[str, bool]) -> None:
    made = system(f"system T srm R {{ liveness {{ R = {formula[0]} }} }}", largest=100_000)
    written = made.srms[0].formulas[0].formula
    assert derivatives.words(of_term(written), list(LETTERS), 3) == derivatives.words(
        derivatives.language(written), list(LETTERS), 3
    )


# ---- what it has found ----------------------------------------------------------------------------


def test_the_abandoned_part_of_an_instance_knows_its_number() -> None:
    """What the certificate has found: `index` in `on abandon` was that of no instance."""
    made = system("""system T
topic free { signal Place }
message Place { int number }
aip P {
  participant a { process = A . B }
  participant b { process = C }
  control a { on abandon : / free.signal.Place.number = index; write_messages.free.signal.Place }
}
srm R { plays P.a  liveness { R = (a~)[3] } }
srm S { plays P.b  liveness { S = b } }
""")
    chart = made.iac("R")
    assert chart is not None
    said = [transition_text(item) for item in chart.transitions if item.kind is TransitionKind.ABANDON]
    assert [text.partition(";")[0] for text in said] == [
        f"on abandon / free.signal.Place.number = {number}" for number in (1, 2, 3)
    ]
