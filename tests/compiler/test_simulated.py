"""`simulated`: what is read, kept in the model, drawn and reported."""

from jsonschema import Draft202012Validator

from aseme_dsl.amola.as_json import schema, srm_json
from aseme_dsl.diagrams.models.srm import sheet
from tests.support.compiling import analysis, codes, system

SYSTEM = """
system S
srm robot {{
  liveness {{ robot = Walk . Rest }}
  activities {{ {activities} }}
}}
"""


def written(activities: str) -> str:
    return SYSTEM.format(activities=activities)


def test_it_stands_among_the_clauses_in_any_order() -> None:
    for text in ("Walk simulated takes 2s Rest takes 1s", "Walk takes 2s simulated\nRest takes 1s"):
        activities = {item.name: item for item in system(written(text)).activities}
        assert activities["Walk"].simulated and activities["Walk"].takes == 2_000_000_000
        assert not activities["Rest"].simulated


def test_it_is_said_once() -> None:
    assert codes(written("Walk takes 1s simulated simulated  Rest takes 1s")) == ["E114"]


def test_without_takes_nothing_says_how_long_it_lasts() -> None:
    (found,) = analysis(written("Walk simulated  Rest takes 1s")).diagnostics
    assert (found.code, found.span.text if found.span else "") == ("W201", "Walk simulated")
    assert found.hint == "say what it takes: `Walk takes 1s simulated`"


def test_another_role_may_say_how_long_it_takes() -> None:
    other = "srm other { liveness { other = Walk } activities { Walk takes 1s } }"
    text = written("Walk simulated  Rest takes 1s") + other
    assert codes(text) == []
    assert [(item.name, item.simulated) for item in system(text).activities] == [
        ("Walk", True),
        ("Rest", False),
    ]


def test_a_module_is_not_simulated() -> None:
    text = "system S srm r { liveness { r = A } modules { Eyes every 1s simulated } }"
    assert codes(text) == ["E545"]


def test_it_is_a_name_where_no_clause_begins() -> None:
    text = "system S message Told { bool simulated } srm robot { liveness { robot = simulated . Walk } }"
    assert codes(text) == []


def test_no_activity_is_called_so_in_its_block() -> None:
    assert codes(written("simulated takes 2s  Walk takes 1s  Rest takes 1s"))[0] == "E100"


def test_the_model_and_its_drawing_show_it() -> None:
    made = system(written("Walk takes 2s simulated  Rest takes 1s"))
    model = srm_json(made.srms[0], made.activities, made.name)
    Draft202012Validator(schema("srm")).validate(model)
    assert [item.get("simulated") for item in model["activities"]] == [True, None]
    assert "simulated" in str(sheet(made.srms[0], made.activities, "robot"))
