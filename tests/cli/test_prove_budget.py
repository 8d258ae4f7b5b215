"""`asemec prove` shares its budget: each question gets its part, and the time that one leaves goes on."""

from __future__ import annotations

import re
import subprocess
import sys
from collections.abc import Iterator
from itertools import count
from pathlib import Path

import pytest

from aseme_dsl.compiler import phases
from tests.cli.support import Here

COUNTING = """\
system Counting
srm robot {
  var n : int
  var m : int
  liveness { robot = One+ || Two+ || (Wait . Go) }
  activities { Wait waits }
  control robot {
    leave One : [n == 9000]  repeat One : else / n = n + 1
    leave Two : [m == 9000]  repeat Two : else / m = m + 1
    enter Go : after(1s)
  }
}
team T { one : robot }
property "deep"     { never (one in Go and one has [n == 8999] and one has [m == 8998]) }
property "in time"  { every one in Wait leads to one in Go within 1s }
property "deeper"   { never (one in Go and one has [n == 8998] and one has [m == 8999]) }
property "at first" { no one in Go before 1s }
"""


@pytest.mark.parametrize(
    ("more", "said"),
    [
        (("--states", "5"), "asemec prove it.aseme deep --states 25"),
        (("--budget", "100ms"), "asemec prove it.aseme deep --budget 0.5s"),
    ],
)
def test_how_to_ask_for_one_answer_alone_is_said_once(
    here: Here, folder: Path, more: tuple[str, str], said: str
) -> None:
    (folder / "it.aseme").write_text(COUNTING)
    hints = [line for line in here("prove", "it.aseme", *more).out.splitlines() if line.startswith("hint: ")]
    assert len(hints) == 1 and hints[0].endswith(f"with a larger limit: {said}"), hints


@pytest.mark.parametrize("asked", [(), ("deep", "at first", "deeper", "in time")])
def test_no_question_is_left_without_time(here: Here, folder: Path, asked: tuple[str, ...]) -> None:
    (folder / "it.aseme").write_text(COUNTING)
    found = here("prove", "it.aseme", *asked, "--budget", "1s", "--json").json["results"]
    parts = {item["name"]: re.search(r"cut after ([0-9.]+) s", item["reason"]) for item in found}
    for name in ("deep", "in time", "deeper", "at first"):
        part = parts[name]
        assert part is not None and float(part[1]) >= 0.05, found


def test_a_search_that_takes_too_long_leaves_the_others_their_least_part(
    here: Here, folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("aseme_dsl.project.proving.searches.process_time", count(0, 7).__next__)
    (folder / "it.aseme").write_text(COUNTING)
    found = here("prove", "it.aseme", "deep", "deeper", "--budget", "1s", "--json").json["results"]
    assert [item["reason"] for item in found] == ["the search was cut after 0.25 s"] * 2


def test_what_one_question_leaves_goes_to_the_others(here: Here, folder: Path) -> None:
    few = [f'property "{number}" {{ never one has [n > {number}] }}\n' for number in range(3, 60)]
    (folder / "it.aseme").write_text(COUNTING.replace("9000", "3") + "".join(few))
    found = here("prove", "it.aseme", "3", "59", "at first", "--budget", "20s", "--json").json["results"]
    assert {item["name"]: item["verdict"] for item in found} == dict.fromkeys(
        ("3", "59", "at first"), "PROVED"
    ), found


def test_it_ends_in_the_midst_of_a_moment_with_many_outcomes(here: Here, folder: Path) -> None:
    names = [f"p{number}" for number in range(18)]
    regions = "\n".join(f"    {name} = [Do_{name}]" for name in names)
    control = "\n".join(
        f"  control {name} {{ enter Do_{name} : [even({number})]  skip Do_{name} : else }}"
        for number, name in enumerate(names)
    )
    (folder / "it.aseme").write_text(f"""\
system Many
function even(int n) : bool = "tests.oracle.functions:even"
srm robot {{
  liveness {{
    robot = Wait . ({" || ".join(names)})
{regions}
  }}
{control}
}}
team T {{ it : robot }}
property "it" {{ never it in Wait and it in Do_p1 }}
""")
    (found,) = here("prove", "it.aseme", "it", "--budget", "1s", "--json").json["results"]
    assert "the search was cut after" in found["reason"], found


def test_no_file_is_compiled_twice(here: Here, folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    texts: list[str] = []
    inspecting = phases.inspecting

    def counted(root: object, *rest: object) -> Iterator[None]:
        texts.append(str(getattr(root, "text", root)))
        return inspecting(root, *rest)  # type: ignore[arg-type]

    monkeypatch.setattr(phases, "inspecting", counted)
    (folder / "it.aseme").write_text(COUNTING.replace("before 1s", "before 2s"))
    found = here("prove", "it.aseme", "at first", "--budget", "5s", "--json").json["results"]
    assert [item["verdict"] for item in found] == ["REFUTED"], found
    assert len(texts) == 2 and "scenario" in texts[1], "the file, and with the scenario of a counterexample"


def test_a_proof_loads_no_libraries_that_it_does_not_need(folder: Path) -> None:
    (folder / "it.aseme").write_text(COUNTING.replace("9000", "3"))
    arguments = ["prove", "it.aseme", "deep"]
    program = f"import sys; from aseme_dsl.cli import main; main({arguments}); print(*sys.modules)"
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True)
    assert done.stdout.startswith("UNDECIDED deep")
    loaded = {*done.stdout.splitlines()[-1].split()}
    assert not loaded & {"networkx", "textx", "graphviz", "jsonschema", "aseme_dsl.backends.jade_like"}
