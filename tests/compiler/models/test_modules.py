"""Modules: from the text to the models."""

from __future__ import annotations

import json

from aseme_dsl.amola.as_json import models_json
from aseme_dsl.amola.expression import duration_text
from tests.support.compiling import system

TEXT = """
system S
message Ball { int x }
message Image { bytes data }
topic vision { state Ball }
topic camera { data Image }
srm robot {
  liveness { robot = Walk || Look }
  modules {
    Vision every 33ms takes 5ms as process reads camera.data.Image for 2s writes vision.state.Ball
    Legs every 20ms = "robot.legs:Legs"
  }
}
statechart other {
  state 0 OR  state 0.1 START  state 0.2 BASIC Stand
  0.1 -> 0.2 :
  modules { Vision every 50ms writes vision.state.Ball }
}
"""


def test_modules_belong_to_their_role_and_its_root_knows_their_channels() -> None:
    found = system(TEXT)
    chart = found.iacs[0]
    said = [(item.name, duration_text(item.statement.every or 0), item.target) for item in chart.modules]
    assert said == [("Vision", "33ms", ""), ("Legs", "20ms", "robot.legs:Legs")]
    root, *inner = chart.regions
    assert [str(channel) for channel in root.reads] == ["camera.data.Image"]
    assert [str(channel) for channel in root.writes] == ["vision.state.Ball"]
    assert not any(region.reads or region.writes for region in inner)
    assert found.srms[0].modules == chart.modules
    assert [item.name for item in found.iacs[1].modules] == ["Vision"]
    assert not found.activity("Vision")


def test_modules_are_in_the_models_json() -> None:
    models = models_json(system(TEXT))
    for name in ("srm.robot.json", "iac.robot.json"):
        vision, legs = models[name]["modules"]
        assert (vision["every"], vision["takes"], vision["kind"]) == ("33ms", "5ms", "process")
        assert vision["reads"][0]["history"] == "2s" and vision["target"] is None
        assert (legs["target"], legs["kind"]) == ("robot.legs:Legs", "thread")
    json.dumps(models)
