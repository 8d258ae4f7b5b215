"""`asemec prove`: what the code of an activity writes of its participant, it may write in a proof, too."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.cli.test_prove import verdicts

SHOP = """\
system Shop
message Order { int n }
aip order {
  participant buyer {
    sends request Order
    var mode : int = 0
    process = Choose . [Haggle] . Ask
  }
  participant seller { receives request Order  process = Serve }
  control buyer {
    enter Choose : / mode = 1
    enter Haggle : [mode == 2]
    skip  Haggle : else
    enter Ask    : / send request Order { n = 1 } to seller
  }
  control seller { enter Serve : request Order from buyer }
}
"""
PROJECT = '[tool.asemec]\nfiles = ["it.aseme"]\nactivities = "activities"\n'
WRITES = """\
class Choose:
    def execute(self, context):
        {}
"""
HELPER = """\
def haggle(known):
    known.set_variable("mode", 2)
"""
COMPUTED = """\
NAMES = ["mode"]
class Choose:
    def execute(self, context):
        context.set_variable(NAMES[0], 2)
"""


@pytest.mark.parametrize(
    ("files", "verdict"),
    [
        ({}, "REFUTED"),
        ({"choose.py": WRITES.format("pass")}, "REFUTED"),
        ({"choose.py": WRITES.format('context.set_variable("mode", 2)')}, "PROVED"),
        ({"choose.py": WRITES.format("helping.haggle(context)"), "helping.py": HELPER}, "PROVED"),
        ({"choose.py": COMPUTED}, "PROVED"),
        ({"serve.py": WRITES.format('context.set_variable("mode", 2)')}, "REFUTED"),
    ],
    ids=[
        "no code",
        "writes nothing",
        "writes",
        "a helper writes",
        "a computed name",
        "another activity writes",
    ],
)
def test_a_variable_that_lines_write_too_is_written_by_the_activity_whose_code_does(  # type: ignore[no-untyped-def]
    prove, folder: Path, files: dict[str, str], verdict: str
) -> None:
    (folder / "pyproject.toml").write_text(PROJECT)
    (folder / "activities").mkdir()
    for name, text in files.items():
        (folder / "activities" / name).write_text(text)
    assert verdicts(prove(SHOP, "dead states", "--json"))["dead states"] == verdict


def test_a_wait_that_such_a_value_causes_is_refuted_and_played(prove, folder: Path) -> None:  # type: ignore[no-untyped-def]
    (folder / "pyproject.toml").write_text(PROJECT)
    (folder / "activities").mkdir()
    waits = SHOP.replace("skip  Haggle : else", "skip  Haggle : [mode == 1]")
    assert verdicts(prove(waits, "deadlock", "--json"))["deadlock"] == "PROVED"
    for name in ("Haggle", "Ask", "Serve"):
        (folder / f"activities/{name.lower()}.py").write_text(WRITES.replace("Choose", name).format("pass"))
    (folder / "activities/choose.py").write_text(WRITES.format('context.set_variable("mode", 3)'))
    (found,) = prove(waits, "deadlock", "--json").json["results"]
    assert found["verdict"] == "REFUTED"
    assert "sets mode = " in found["scenario"]


LENT = """\
system Lab
import resources
srm desk {
  includes resource_keeper
  liveness { desk = service  places = keeper~ }
  activities { ConsiderNeed takes 1s simulated  CloseNeed takes 1s simulated }
}
srm user {
  plays resource.holder with whom = "desk", what = "a saw", urgency = 0, lease = 30s, patience = 1min,
      renewing = false, UseResource = Saw
  liveness { user = holder }
}
team T { desk : desk  one : user }
property "nobody is refused" { never sent refuse Need }
"""


def test_a_keeper_of_a_resource_may_refuse_without_code(prove) -> None:  # type: ignore[no-untyped-def]
    assert verdicts(prove(LENT, "nobody is refused", "--json"))["nobody is refused"] == "REFUTED"


def test_what_comes_from_outside_is_there_for_a_role_whose_code_writes(prove, folder: Path) -> None:  # type: ignore[no-untyped-def]
    """Its chart is looked into like any other."""
    (folder / "pyproject.toml").write_text(PROJECT)
    (folder / "activities").mkdir()
    (folder / "activities" / "choose.py").write_text(WRITES.format('context.set_variable("mode", 2)'))
    text = SHOP.replace(
        "message Order", "message Stock { int left }\ntopic hall { state Stock }\nmessage Order"
    )
    text = text.replace("[mode == 2]", "[mode == 2 && has(hall.state.Stock)]")
    assert verdicts(prove(text, "dead states", "--json"))["dead states"] == "PROVED"
