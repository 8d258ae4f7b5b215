"""`guarantees`: what is read, kept in the model, laid out and reported."""

import pytest
from jsonschema import Draft202012Validator

from aseme_dsl.amola.as_json import schema, srm_json
from tests.support.compiling import codes, system

SYSTEM = """
system S
message Order {{ int to  int kind }}
message Ball {{ int x }}
topic team {{ state Order }}
topic sight {{ state Ball }}
srm boss {{
  liveness {{ boss = Give . Rest }}
  activities {{
    Give reads sight.state.Ball writes team.state.Order
      {promise}
    Rest takes 1s simulated
  }}
}}
"""

LEASE = "guarantees no sent Order b [b.to != 0 && b.to != a.to] within 1400ms after sent Order a [a.to != 0]"


def test_the_model_and_its_json_have_it() -> None:
    made = system(SYSTEM.format(promise=f"{LEASE} guarantees never sent team.state.Order o"))
    give, rest = made.activities
    assert not rest.guarantees
    lease, never = give.guarantees
    assert (lease.within, lease.said.called, [str(item) for item in lease.said.channels]) == (
        1_400_000_000,
        "b",
        ["team.state.Order"],
    )
    assert (never.within, never.earlier, never.said.condition) == (None, None, None)
    found = srm_json(made.srms[0], made.activities, made.name)
    Draft202012Validator(schema("srm")).validate(found)
    told = found["activities"][0]["guarantees"]
    assert told[0]["after"] == {"channels": ["team.state.Order"], "name": "a", "condition": "a.to != 0"}
    assert told[0]["within"] == "1400ms"


@pytest.mark.parametrize(
    ("promise", "code"),
    [
        ("guarantees never sent Ordr o", "E231"),
        ("guarantees never sent Ball o", "E231"),
        ("guarantees never sent sight.state.Ball o", "E231"),
        ("guarantees never sent Order o [o.to == sight.state.Ball.x]", "E231"),
        ("guarantees never sent Order o [index == o.to]", "E231"),
        ("guarantees never sent Order o [o.tu < 0]", "E501"),
        ("guarantees never sent Order o [p.to < 0]", "E502"),
        ("guarantees never sent Order o [o.to]", "E500"),
        ("guarantees never sent Order o [o.to <]", "E102"),
        ("guarantees no sent Order b within 0ms after sent Order a", "E231"),
        ("guarantees no sent Order a within 1s after sent Order a", "E231"),
        ("guarantees no sent Order a within 1s", "E100"),
        ("guarantees never sent Order", "E100"),
    ],
)
def test_what_is_wrong_is_reported(promise: str, code: str) -> None:
    assert codes(SYSTEM.format(promise=promise)) == [code]


def test_two_roles_do_not_guarantee_differently() -> None:
    other = """srm deputy {{ liveness {{ deputy = Give }} activities {{ Give {} }} }}"""
    text = SYSTEM.format(promise=LEASE) + other.format(
        "writes team.state.Order guarantees never sent Order o"
    )
    assert codes(text) == ["E203"]
    same = SYSTEM.format(promise=LEASE) + other.format(f"writes team.state.Order {LEASE}")
    assert codes(same) == []
