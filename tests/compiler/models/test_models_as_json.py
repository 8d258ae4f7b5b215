"""Models as JSON: of the form that the schemas describe, for every acceptance file and in the details."""

from __future__ import annotations

import json
from pathlib import Path

import jsonschema
import pytest

from aseme_dsl.amola.as_json import json_text, models_json, schema
from aseme_dsl.compiler import analyse
from tests.support.compiling import system

ACCEPTANCE = Path(__file__).resolve().parents[2] / "acceptance"
KIND = {"eac": "statechart", "iac": "statechart"}


def check(models: dict[str, dict[str, object]]) -> None:
    for name, model in models.items():
        kind = name.split(".")[0]
        validator = jsonschema.Draft202012Validator(schema(KIND.get(kind, kind)))
        assert list(validator.iter_errors(json.loads(json_text(model)))) == [], name


@pytest.mark.parametrize("kind", ["sag", "suc", "aip", "srm", "statechart"])
def test_a_schema_is_a_schema(kind: str) -> None:
    found = schema(kind)
    jsonschema.Draft202012Validator.check_schema(found)
    assert found["$schema"] == "https://json-schema.org/draft/2020-12/schema"


@pytest.mark.parametrize("name", ["testbehavior", "kouretes", "contract_net"])
def test_every_model_of_the_acceptance_files(name: str) -> None:
    found = analyse(ACCEPTANCE / f"{name}.aseme").system
    assert found is not None
    models = models_json(found)
    check(models)
    if name == "kouretes":
        assert list(models) == [
            *("sag.json", "suc.json", "aip.attack.json", "srm.player.json", "srm.goalie.json"),
            *("eac.attack.json", "iac.player.json", "iac.goalie.json"),
        ]


EVERYTHING = """\
system Everything
enum Mode { OFF ON }
message Ball { bool seen  double size  Mode mode }
topic vision { state Ball  data Ball  signal Ball }

aip meeting {
  participant host [2..3] {
    engage "There is time."
    var wait : duration = 1.5s
    sends request Ball   receives inform Ball
    process = Talk . [Listen]
  }
  participant guest [1..*] { sends inform Ball  receives request Ball  process = Listen }
  outcome "All agree."
  clause every Talk@host leads to (Listen@host or Listen@guest) within 10s
  control host { enter Listen : inform Ball from guest  skip Listen : after(2s) }
}

srm one {
  plays meeting.host as chair with Talk = Sing
  capability sing "Well." = Sing
  var count : int = 3   var mode : Mode = Mode.ON   var name : string = "a \\"b\\""   var share : double = 0.5
  let big = vision.state.Ball.size > 2 && vision.state.Ball.seen
  liveness { one = Look~ || chair~ || (A | B)+ }
  activities {
    Look every 33ms takes 5ms as process uses camera, head
         reads vision.data.Ball for 2s  writes vision.state.Ball, count
  }
  functionality camera { technology "CMOS"  permissions "none"  environment "indoors"  algorithm "blobs" }
  control one {
    repeat (A | B) : when [count < 3 && big]
                     / count = count + 1; vision.signal.Ball.size = 2; write_messages.vision.signal.Ball
    leave  (A | B) : [big]
    enter A        : error or done
    enter B        : else
  }
}
statechart two {
  state 0 OR
  state 0.1 START
  state 0.2 BASIC Blink activity LedOn
  0.1 -> 0.2 : after(1min)
}
team T { a[1..2] : one  b : two }
"""


def test_every_kind_of_thing() -> None:
    found = system(EVERYTHING)
    models = models_json(found)
    check(models)
    chart = models["iac.one.json"]
    assert chart["variables"] == [
        {"name": "count", "type": "int", "initial": 3},
        {"name": "mode", "type": "Mode", "initial": "ON"},
        {"name": "name", "type": "string", "initial": 'a "b"'},
        {"name": "share", "type": "double", "initial": 0.5},
        {"name": "wait@0.2.2.2.2", "type": "duration", "initial": "1500ms"},
    ]
    repeat = next(item for item in chart["transitions"] if item["source"] == item["target"] == "0.2.3.2.2")
    assert repeat["event"] == "when"
    # A `let` is written out: the model says everything by itself.
    assert repeat["condition"] == "count < 3 && (vision.state.Ball.size > 2 && vision.state.Ball.seen)"
    assert repeat["actions"] == [
        "count = count + 1",
        "vision.signal.Ball.size = 2",
        "write_messages.vision.signal.Ball",
    ]
    assert repeat["origin"] == "formula one.one"
    assert chart["regions"][3] == {
        "label": "0.2.3",
        "reads": ["vision.state.Ball"],
        "writes": ["vision.signal.Ball"],
    }
    assert chart["regions"][0]["reads"] == ["vision.data.Ball", "vision.state.Ball"]
    assert models["srm.one.json"]["plays"][0]["bindings"] == {"Talk": "Sing"}
    activity = models["srm.one.json"]["activities"][0]
    assert (activity["every"], activity["takes"], activity["kind"]) == ("33ms", "5ms", "process")
    assert activity["writes"] == ["vision.state.Ball", "count"]
    assert models["iac.two.json"]["states"][2]["name"] == "Blink"
    assert models["iac.two.json"]["states"][2]["activity"] == "LedOn"
    assert models["aip.meeting.json"]["clauses"][0]["text"] == (
        "every Talk@host leads to (Listen@host or Listen@guest) within 10s"
    )


def test_places_are_as_given_and_never_absolute(tmp_path: Path) -> None:
    (tmp_path / "shared").mkdir()
    (tmp_path / "team").mkdir()
    (tmp_path / "shared" / "roles.aseme").write_text("srm other { liveness { other = Walk } }", "utf-8")
    path = tmp_path / "team" / "main.aseme"
    text = 'system S\nimport "../shared/roles.aseme"\nsrm one { liveness { one = Walk } }'
    path.write_text(text, "utf-8")
    found = analyse(path).system
    assert found is not None
    models = models_json(found)
    check(models)
    assert models["iac.one.json"]["states"][0]["span"] == {
        "file": "main.aseme",
        **{"line": 3, "column": 5, "end_line": 3, "end_column": 8},
    }
    assert models["iac.other.json"]["states"][0]["span"]["file"] == "../shared/roles.aseme"
    assert str(tmp_path) not in "".join(map(json_text, models.values()))
