"""Models of KSE: what goes out is a model of its metamodel, and what comes home is the chart that went out.

Identity is meant literally but for this: the places in the texts, where a state is said to come from, and
the order of transitions of different sources. States that are named by their terms are compared as KSE
spells them; a state without a name may come home as a term, and has that name then.
"""

from __future__ import annotations

import io
import os
import random
from collections.abc import Iterator
from pathlib import Path

import pytest
from hypothesis import HealthCheck, Phase, example, given, settings
from hypothesis import strategies as st

from aseme_dsl.amola.original_names import labels_as_original
from aseme_dsl.amola.statechart import Statechart, transition_text
from aseme_dsl.amola.system import System
from aseme_dsl.codegen.proto import proto_files
from aseme_dsl.compiler import analyse
from aseme_dsl.diagnostics import render_text
from aseme_dsl.diagnostics.problems.exporting import Foreign
from aseme_dsl.interop.emf.report import Fate
from aseme_dsl.interop.export.formats import Format, files_of
from aseme_dsl.interop.export.stct import NAMESPACE
from aseme_dsl.project.editing.import_models import import_models, write_project
from tests.support.generated import system_of

EXAMPLES = int(os.environ.get("ASEME_ROUND_TRIPS", "8"))
ECORE = Path(__file__).with_name("statechart.ecore")
ROOT = Path(__file__).parents[3]

HEAD = """\
system S
message Inner { int y }
message M { int x  bool on  double d  string s  Inner inner  repeated int many }
topic t { state M  signal M  data M }
function f(M m) : bool = "tests.oracle.functions:even"
"""


class _Random:
    """Random charts of what a model of KSE can say: formulas with `control`, and charts state by state."""

    def __init__(self, seed: int) -> None:
        self.chance = random.Random(seed)
        self.states: list[str] = []
        self.lines: list[str] = []
        self.names = 0

    def number(self, most: int) -> int:
        return self.chance.randint(0, most)

    def one(self, *texts: str) -> str:
        return texts[self.number(len(texts) - 1)]

    # ---- expressions

    def member(self) -> str:
        return f"t.{self.one('state', 'signal', 'data')}.M"

    def condition(self, depth: int = 2) -> str:
        kind = self.number(10 if depth else 6)
        message = self.member()
        if kind <= 2:
            sign = self.one("==", "!=", "<", "<=", ">", ">=")
            return self.one(
                f"{message}.x {sign} {self.number(9)}",
                f"{message}.d {sign} {self.number(9)}.5",
                f"{message}.inner.y {sign} -{self.number(9) + 1}",
                f"{message}.x {sign} t.state.M.x",
                f"{message}.many[{self.number(3)}] {sign} 3",
                f'{message}.s == "a b"',
                "count > 3",
            )
        if kind <= 6:
            return self.one(
                f"has({message})", f"!has({message})", f"{message}.on", f"!{message}.on", "expired(pace)",
                "!expired(pace)", f"f({message})", f"!f({message})", "ready", "!ready",
            )  # fmt: skip
        if kind == 7:
            return f"!({self.condition(0)} {self.one('&&', '||')} {self.condition(0)})"
        sign = self.one("&&", "||")
        return f" {sign} ".join(f"({self.condition(depth - 1)})" for _ in range(2 + self.number(1)))

    def actions(self) -> str:
        said = [
            self.one(
                f"start_timer(pace, {1 + self.number(900)}ms)",
                "read_messages",
                "write_messages.t.signal.M",
                f"t.state.M.x = {self.number(9)}; write_messages.t.state.M",
                "t.data.M.on = true; write_messages.t.data.M",
            )
            for _ in range(self.number(2))
        ]
        return f" / {'; '.join(said)}" if said else ""

    def asked(self, is_composite: bool) -> str:
        event = self.one("", "", "go", "hop")
        if event and self.number(1):
            return event + self.actions()
        when = "when " if is_composite and not event else ""
        return f"{event} {when}[{self.condition()}]{self.actions()}".strip()

    # ---- charts

    def statechart(self) -> str:
        self.composite("0", 3)
        return "\n".join(
            [
                HEAD,
                "statechart R {",
                "  var count : int = 0",
                "  var ready : bool = false",
                *self.states,
                *self.lines,
                "}",
                "team T { me : R }",
            ]
        )

    def composite(self, label: str, depth: int) -> None:
        """An OR: its START, some states and its END, and transitions between them."""
        self.states.append(f"  state {label} OR {self.name(label)}")
        self.states.append(f"  state {label}.1 START")
        inner = 1 + self.number(3)
        kinds: dict[str, bool] = {}
        for child in range(2, 2 + inner):
            place = f"{label}.{child}"
            chosen = self.number(5) if depth else 0
            kinds[place] = chosen >= 4
            if chosen == 4:
                self.composite(place, depth - 1)
            elif chosen == 5:
                self.states.append(f"  state {place} AND {self.name(place)}")
                for region in range(1, 3):
                    self.composite(f"{place}.{region}", depth - 1)
            else:
                self.states.append(f"  state {place} BASIC A{self.number(9)}")
        end = f"{label}.{inner + 2}"
        self.states.append(f"  state {end} END")
        self.lines.append(f"  {label}.1 -> {label}.2 :{self.actions()}")
        places = list(kinds)
        for place, is_composite in kinds.items():
            for _ in range(self.number(2)):
                target = self.one(*places, end)
                self.lines.append(f"  {place} -> {target} : {self.asked(is_composite)}")
            if self.number(2):
                self.lines.append(f"  {place} -> {end} :{self.actions()}")
        if self.number(2) == 0:
            choice = f"{label}.{inner + 3}"
            self.states.append(f"  state {choice} CONDITION")
            self.lines.append(f"  {places[0]} -> {choice} : {self.asked(kinds[places[0]])}")
            self.lines.append(f"  {choice} -> {end} : [{self.condition()}]{self.actions()}")
            self.lines.append(f"  {choice} -> {places[-1]} : else{self.actions()}")

    def name(self, label: str) -> str:
        self.names += 1
        return self.one("", f"S{self.names}", f'"odd name {self.names}"') if label != "0" else "R"

    def formula(self) -> str:
        terms: list[str] = []
        whole = self.term(3, terms)
        control = [f"    {line}" for line in terms]
        return "\n".join(
            [
                HEAD,
                "srm R {",
                "  var count : int = 0",
                "  var ready : bool = false",
                "  liveness {",
                f"    R = Begin . ({whole})",
                "  }",
                "  control R {",
                *control,
                "  }",
                "}",
                "team T { me : R }",
            ]
        )

    def term(self, depth: int, lines: list[str]) -> str:
        """A term, and the lines of control for what is inside it."""
        self.names += 1
        kind = self.number(8) if depth else 0
        if kind == 8:
            lines.append(f"enter A{self.names} :{self.actions()}")
            lines.append(f"leave A{self.names} : [{self.condition()}]")
            return f"A{self.names}[{2 + self.number(1)}]"
        if kind <= 1:
            return f"A{self.names}"
        if kind in (2, 3, 4):
            parts = [self.term(depth - 1, lines) for _ in range(2 + self.number(1))]
            if kind == 3:
                for part in parts[:-1]:
                    lines.append(f"enter {part} : [{self.condition()}]{self.actions()}")
                lines.append(f"enter {parts[-1]} : else{self.actions()}")
            return f"({(' . ', ' | ', ' || ')[kind - 2].join(parts)})"
        name = f"B{self.names}"
        is_composite = self.number(1)
        inner, when = (f"({name} . C{self.names})", "when ") if is_composite else (name, "")
        if kind == 5 or kind == 7:
            lines.append(f"enter {inner} : [{self.condition()}]{self.actions()}")
            lines.append(f"skip {inner} : else{self.actions()}")
        if kind == 5:
            return f"[{inner}]"
        lines.append(f"repeat {inner} : {when}[{self.condition()}]{self.actions()}")
        return f"{inner}{'+' if kind == 6 else '*'}"


def described(chart: Statechart, unnamed: frozenset[str] = frozenset()) -> dict[str, object]:
    """All that a chart says, by the places of its states, but the names of those that are `unnamed`."""
    as_kse = labels_as_original(chart)
    return {
        "name": chart.name,
        "states": [
            (item.label, "" if item.label in unnamed else item.name, item.type, item.parent, item.activity)
            for item in as_kse.states
        ],
        "transitions": {
            state.label: [
                (item.target, item.kind, transition_text(item), item.expression.when, repr(item.resume))
                for item in chart.outgoing(state.label)
            ]
            for state in chart.states
        },
        "variables": [(item.name, item.type, item.initial.value) for item in chart.variables],
        "regions": [(item.label, item.reads, item.writes) for item in chart.regions],
    }


def exported(system: System) -> str:
    files, refused = files_of(system, system.iacs[0], Format.STCT)
    assert not refused, render_text(refused)
    ((_, text),) = files
    return text


def at_home(system: System, folder: Path) -> Statechart:
    """The chart of a system after it was exported and imported."""
    (folder / "model.stct").write_text(exported(system), "utf-8")
    for name, text in proto_files(system).items():
        (folder / name).write_text(text, "utf-8")
    project = write_project(import_models([folder / "model.stct"]), folder / "new")
    assert not project.diagnostics, render_text(project.diagnostics)
    assert not [row for row in project.rows if row.fate is Fate.HOLE]
    analysis = analyse(next((folder / "new").glob("*.aseme")))
    assert analysis.system is not None, render_text(analysis.diagnostics)
    return analysis.system.iacs[0]


@pytest.mark.parametrize("form", ["statechart", "formula"])
@settings(
    max_examples=EXAMPLES,
    deadline=None,
    suppress_health_check=list(HealthCheck),
    phases=(Phase.explicit, Phase.generate),  # a smaller seed is not a smaller chart
)
@example(seed=8941380)
@given(seed=st.integers(0, 10**9))
def test_what_comes_home_is_what_went_out(
    form: str, seed: int, tmp_path_factory: pytest.TempPathFactory
) -> None:
    text = getattr(_Random(seed), form)()
    system = system_of(text)
    home = at_home(system, tmp_path_factory.mktemp("kse"))
    (chart,) = system.iacs
    unnamed = frozenset(item.label for item in chart.states if item.name == item.label)
    assert described(home, unnamed) == described(chart, unnamed), text


@pytest.mark.parametrize(
    "formula",
    ["Paint[3]", "(Paint[3] | Rest)", "Paint[2]+", "(Paint[3] || Rest)", "Walk . Paint[2]", "wall[2]"],
)
def test_so_many_at_once_comes_home_as_it_was_written(formula: str, tmp_path: Path) -> None:
    inner = " wall = Paint . Rest" if "wall" in formula else ""
    text = f"system S\nsrm R {{\n  liveness {{ R = {formula} . Clean{inner} }}\n"
    lines = "enter Paint[3] : [true]  enter Rest : else" if "|" in formula and "||" not in formula else ""
    lines += " repeat Paint[2] : when [false]" if "+" in formula else ""
    system = system_of(f"{text}  control R {{ {lines} }}\n}}\nteam T {{ me : R }}\n")
    home = at_home(system, tmp_path)
    assert described(home) == described(system.iacs[0])
    (written,) = (tmp_path / "new").glob("*.aseme")
    assert f" = {formula} . Clean" in written.read_text("utf-8").replace("((", "(").replace("))", ")")


def test_so_many_that_were_edited_come_home_one_by_one(tmp_path: Path) -> None:
    text = "system S\nsrm R {\n  liveness { R = Paint[2] }\n  control R { leave Paint : [true] }\n}\n"
    system = system_of(f"{text}team T {{ me : R }}\n")
    edited = exported(system).replace(' TE="[true]"', "", 1)
    (tmp_path / "model.stct").write_text(edited, "utf-8")
    project = write_project(import_models([tmp_path / "model.stct"]), tmp_path / "new")
    assert project.files
    (written,) = (tmp_path / "new").glob("*.aseme")
    assert "R = Paint || Paint\n" in written.read_text("utf-8")


def test_enums_of_a_proto_file_come_home(tmp_path: Path) -> None:
    proto = 'syntax = "proto2";\nenum Mode { MODE_OFF = 3; MODE_ON = 4; }\n'
    proto += "message Light { optional Mode mode = 1; }\n"
    (tmp_path / "light.proto").write_text(proto, "utf-8")
    text = (
        'system S\nimport "light.proto"\ntopic t { state Light }\nsrm R {\n  liveness { R = Rest+ }\n'
        "  control R { repeat Rest : [t.state.Light.mode == Mode.MODE_ON] }\n}\n"
    )
    (tmp_path / "s.aseme").write_text(text, "utf-8")
    analysis = analyse(tmp_path / "s.aseme")
    assert analysis.system is not None, render_text(analysis.diagnostics)
    home = at_home(analysis.system, tmp_path)
    assert described(home) == described(analysis.system.iacs[0])


def problems(text: str) -> list[str]:
    """What the metamodel says against a model; references that lead nowhere are among it."""
    ecore = pytest.importorskip("pyecore.resources", reason="NOT TRIED, for there is no pyecore here")
    resources = ecore.ResourceSet()
    package = resources.get_resource(ecore.URI(str(ECORE))).contents[0]
    resources.metamodel_registry[package.nsURI] = package
    stream = ecore.URI("model.stct")
    stream.create_instream = lambda: io.BytesIO(text.encode())
    stream.close_stream = lambda: None
    try:
        (model,) = resources.get_resource(stream).contents
        nodes = [item for item in model.eAllContents() if item.eClass.name == "Node"]
        found = [f"{node.label}: no name" for node in nodes if not node.name or not node.type]
        found += [
            f"transition {item.name}"
            for item in model.transitions
            if not item.source.label or not item.target.label
        ]
        return found if len(model.nodes) == 1 else ["not one root"]
    except Exception as problem:  # whatever a reader of models says
        return [f"{type(problem).__name__}: {problem}"]


def documents() -> Iterator[str]:
    for path in sorted((ROOT / "tests/acceptance").glob("*.aseme")):
        text = path.read_text("utf-8").replace(") : [", ") : when [")  # as in Monas, not once complete
        system = system_of(text)
        for chart in system.iacs:
            yield from (text for _, text in files_of(system, chart, Format.STCT)[0])
    for seed in range(EXAMPLES):
        yield exported(system_of(_Random(seed).statechart()))


def test_a_model_is_one_of_the_metamodel() -> None:
    made = list(documents())
    assert len(made) > EXAMPLES
    assert [found for text in made if (found := problems(text))] == []


@pytest.mark.parametrize(
    ("written", "instead"),
    [
        ("<transitions ", "<moves "),
        ('label="0.1"', 'place="0.1"'),
        ('source="//@nodes.0/', 'source="//@nodes.7/'),
        (' type="START"', ""),
        (NAMESPACE, "http://statechart/9"),
    ],
)
def test_what_is_not_of_the_metamodel_is_noticed(written: str, instead: str) -> None:
    text = exported(system_of(_Random(1).statechart()))
    assert problems(text) == [] and written in text
    assert problems(text.replace(written, instead)) != []


LAMP = """\
system Lamp
enum Mode {{ OFF ON }}
message Light {{ int level  string colour }}
topic room {{ state Light  signal Light }}
srm lamp {{
  {var}
  liveness {{ lamp = (Dark . Shine)+ }}
  control lamp {{
    {line}
    leave (Dark . Shine) : when [room.state.Light.level == 3]
  }}
  {more}
}}
team T {{ me, you : lamp }}
"""


@pytest.mark.parametrize(
    ("line", "var", "more", "lacks"),
    [
        ("enter Shine : after(2s)", "", "", Foreign.TIMED),
        ("enter Shine : a or b", "", "", Foreign.SEVERAL_EVENTS),
        ("enter Shine : when [room.state.Light.level > 1]", "", "", Foreign.WHEN),
        ("repeat (Dark . Shine) : [room.state.Light.level > 1]", "", "", Foreign.COMPLETE_AND),
        ("enter Shine : [room.state.Light.level + 1 > 1]", "", "", Foreign.ARITHMETIC),
        ("enter Shine : [you.room.state.Light.level > 1]", "", "", Foreign.HOSTS),
        ("enter Shine : [age(room.state.Light) > 1s]", "", "", Foreign.VALUES),
        ("enter Shine : [in(Dark)]", "", "", Foreign.STATES),
        ('enter Shine : [room.state.Light.colour == "a;b"]', "", "", Foreign.TEXTS),
        ("enter Shine : / raise e", "", "", Foreign.RAISING),
        ("enter Shine : / n = 2", "var n : int = 0", "", Foreign.ASSIGNING),
        ("enter Shine : / start_timer(p, 0.5ms)", "", "", Foreign.TIMES),
        ("enter Shine : / room.signal.Light.level = 1", "", "", Foreign.SETTERS),
        (
            'enter Shine : / room.signal.Light.level = 1; room.signal.Light.colour = "x";'
            " write_messages.room.signal.Light",
            "",
            "",
            Foreign.SETTERS,
        ),
        ("enter Shine : error", "", "", Foreign.ERRORS),
        ("resume Shine : [true]", "", "", Foreign.RESUMING),
        ("exit Shine : / read_messages", "", "", Foreign.ACTIONS_INSIDE),
        ("repeat (Dark . Shine) every 2s :", "", "", Foreign.PACES),
        ("enter Shine : [n > 1]", "var n : int = 3", "", Foreign.FIRST_VALUES),
        ("enter Shine : [n > 1]", "var n : int 0..9 = 0", "", Foreign.BOUNDS),
        ("enter Shine : [m == Mode.ON]", "var m : Mode = Mode.OFF", "", Foreign.VARIABLES),
        ("enter Shine :", "", "activities { Dark waits }", Foreign.WAITING),
        ("enter Shine :", "", "activities { Dark within 2s }", Foreign.DEADLINES),
    ],
)
def test_what_a_model_cannot_say_is_refused(line: str, var: str, more: str, lacks: Foreign) -> None:
    system = system_of(LAMP.format(line=line, var=var, more=more))
    files, refused = files_of(system, system.iacs[0], Format.STCT)
    assert files == ()
    assert lacks in {getattr(item.problem, "feature", None) for item in refused}
    assert all(item.span is not None for item in refused)
