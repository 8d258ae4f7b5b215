"""The programs: each compiles without a word, runs, and tells of the mistakes that one would make."""

from __future__ import annotations

import shutil
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import pytest

from aseme_dsl.backends.backend import BackendOptions
from aseme_dsl.backends.monas import BACKEND
from aseme_dsl.compiler import analyse
from aseme_dsl.grammar.layout import format_source
from aseme_dsl.source import Source
from tests.cli.support import Here
from tests.runtime.playing import SECOND, play
from tests.support.generated import generate

EXAMPLES = Path(__file__).parents[2] / "examples"


@dataclass(frozen=True)
class Program:
    """An example, with what its run ends with and how many lines its text may have."""

    name: str
    ends: str
    lines: int = 1000
    lost: int = 0
    """So many agents break down."""

    @property
    def path(self) -> Path:
        return EXAMPLES / self.name / f"{self.name}.aseme"

    def __str__(self) -> str:
        return self.name


PROGRAMS = (
    Program("goalie", "saved 3, kicked away 7, goal 3, beside 1, left 1"),
    Program("auction", "sold to client4 for 130"),
    Program("home", "hall 12.9 °C, kitchen 21.2 °C, bath 21.4 °C, bedroom 17.7 °C"),
    Program("cell", "parts in the tray: left 6, right 12", lines=45),
    Program("patrol", "reports: 6; batteries: guard1 77 %, guard2 74 %, guard3 46 %, guard4 26 %", lines=45),
    Program(
        "warehouse",
        "at the gate: 24 of 24 pallets; announced again: nobody is free 3, the carrier is busy by now 1,"
        " the carrier is lost 1, the pallet slipped 4",
        lines=45,
        lost=1,
    ),
    Program("hospital", "parcels on the ward: 6", lines=160),
    Program("meetings", "the meeting of bob was at 11", lines=110),
)


@pytest.fixture(params=PROGRAMS, ids=str)
def program(request: pytest.FixtureRequest) -> Iterator[Program]:
    yield request.param


def test_it_compiles_without_a_word(program: Program) -> None:
    analysis = analyse(program.path)
    assert analysis.diagnostics == ()
    assert analysis.system is not None


def test_it_is_laid_out_and_short_enough(program: Program) -> None:
    text = program.path.read_text("utf-8")
    assert format_source(Source(str(program.path), text)).text == text
    program_itself = text.partition("\nscenario ")[0]
    assert len(program_itself.splitlines()) <= program.lines


def test_every_activity_is_written(program: Program) -> None:
    system = analyse(program.path).system
    assert system is not None
    used = {item.path.partition("/")[2] for item in BACKEND.generate(system, BackendOptions()) if item.kept}
    written = {path.name for path in (program.path.parent / "activities").glob("*.py")}
    assert used <= written


def test_it_runs(program: Program, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """One seed is one run, to the bit: so its end is known."""
    project = tmp_path / program.name
    shutil.copytree(program.path.parent, project, ignore=shutil.ignore_patterns("build", "__pycache__"))
    done = Here(capsys)("run", project, "--json")
    assert done.code == (1 if program.lost else 0), done.out + done.err
    result = done.json["result"]
    assert program.ends in done.err or program.ends in str(result["summary"])
    assert [agent["name"] for agent in result["agents"] if agent["failure"]] == ["carrier5"][: program.lost]
    assert result["faults"] == 2 * program.lost  # it crashes, and it stops
    observed = Here(capsys)("observe", project, "--json")
    assert observed.code == 0, observed.out
    assert {item["verdict"] for item in observed.json["protocols"]} <= {"kept"}


def test_a_stop_suspends_a_delivery_and_the_lease_inside_it(tmp_path: Path) -> None:
    run = play(generate((EXAMPLES / "hospital" / "hospital.aseme").read_text("utf-8")), until=120 * SECOND)
    stopped = [r for r in run.of("conversation") if r["what"] in ("suspend", "resume")]
    assert {(r["time"] // SECOND, r["what"]) for r in stopped} == {(15, "suspend"), (20, "resume")}
    assert {(r["agent"], r["participant"]) for r in stopped} >= {("porter2", "porter"), ("porter2", "holder")}
    said = Counter(
        (r["agent"], r["performative"], r["message"], r["conversation"]) for r in run.of("agent_message")
    )
    assert [what for what, times in said.items() if times > 1] == []
    assert len(run.of("agent_message", agent="pia", performative="request")) == 6


@dataclass(frozen=True)
class Mistake:
    """What somebody writes in place of what is right, and what the compiler says of it."""

    program: str
    right: str
    wrong: str
    says: str

    def __str__(self) -> str:
        return f"{self.program}: {self.wrong.strip() or 'nothing'}"


MISTAKES = (
    # the branch that nobody would miss: what is done when nothing else holds
    Mistake("goalie", "    enter Scan     : else\n", "", "E404"),
    # a dive that lasts too long would stop the goalie for good
    Mistake("goalie", "    leave Dive     : error  // it lasted too long\n", "", "W604"),
    Mistake("goalie", "|| in(Dive)]", "|| in(Div)]", "E430"),
    # at half-time, in a hurry
    Mistake("goalie", "goalie with limit = 90", "goalie with limits = 90", "E611"),
    # whom, what, and how it ended
    Mistake("auction", "} to best;", "} to bets;", "E205"),
    Mistake("auction", "best = sender(c)", "best = c", "E500"),
    Mistake("auction", "asked = o.price", "asked = o.prize", "E501"),
    Mistake("auction", "outcome(Consider) == yes", "outcome(Consider) == maybe", "E520"),
    Mistake("auction", "lost bidder gone [", "lost bider gone [", "E205"),
    # the first lesson
    Mistake("home", "Lamp { on = false }", "Lamp { off = true }", "E501"),
    Mistake("home", "exit  On : /", "exit  On : [true] /", "E424"),
    Mistake("home", "includes lit\n  var", "includes lid\n  var", "E207"),
    # a part is held: the name of an outcome, misspelt
    Mistake("cell", "outcome(Grasp) == held", "outcome(Grasp) == hold", "E520"),
    # the stop waits for production to be done, which it never is
    Mistake("cell", "enter  halt    : when [", "enter  halt    : [", "E420"),
    # nobody mends a jam
    Mistake("cell", "    enter  halt    : error  // the arm jams, the gripper does not answer\n", "", "W604"),
    # where the arm is to go, forgotten
    Mistake("cell", "pick    = MoveTo(bin) .", "pick    = MoveTo .", "E523"),
    Mistake("patrol", "!in(chase)", "!in(chasing)", "E430"),
    Mistake("patrol", "zone = index }", "zone = Index }", "E200"),
    Mistake("warehouse", "plays contract_net.contractor", "plays contract_net.contracter", "E205"),
    Mistake("warehouse", "with CarryOut =", "with CaryOut =", "E206"),
    Mistake("warehouse", "import protocols\n", "", "E205"),
    Mistake("warehouse", "CollectProposals takes", "CollectProposal takes", "E204"),
    Mistake("warehouse", "Status.free]", "Status.fre]", "E501"),
    Mistake("hospital", "last != LeaseEnd.RETURNED", "last != LeaseEnd.BACK", "E508"),
    Mistake("meetings", "plays meeting.attendee with begins = begins", "plays meeting.attendee", "E590"),
)


@pytest.mark.parametrize("mistake", MISTAKES, ids=str)
def test_a_mistake_is_told_where_it_is(mistake: Mistake) -> None:
    path = EXAMPLES / mistake.program / f"{mistake.program}.aseme"
    text = path.read_text("utf-8")
    assert text.count(mistake.right) == 1
    found = analyse(Source(str(path), text.replace(mistake.right, mistake.wrong))).diagnostics
    assert {item.code for item in found} == {mistake.says}
