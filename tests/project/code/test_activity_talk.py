"""What activities send and take is compared with what their participants do, and with what nobody does."""

from __future__ import annotations

from pathlib import Path

import pytest

from aseme_dsl.diagnostics import Diagnostic
from aseme_dsl.diagnostics.changes import apply
from aseme_dsl.project.code.activity_code import check_code
from tests.support.compiling import system

SYSTEM = """
system Kitchen
message Order { int table }
message Meal { int table }
aip serving {
  participant waiter {
    sends    request Order, cancel Order
    receives inform Meal, refuse Order
    process  = Ask . Serve
  }
  participant cook {
    sends    inform Meal, refuse Order
    receives request Order, cancel Order
    process  = Wait . Cook
  }
  control waiter {
    enter Ask   : / send request Order to cook
    enter Serve : inform Meal from cook or after(60min)
  }
  control cook { enter Wait : request Order from waiter }
}
srm human { plays serving.waiter  liveness { human = waiter } }
srm robot { plays serving.cook with Cook = Boil  liveness { robot = cook . Rest } }
team Kitchen { ann : human  pan : robot }
"""


def say(folder: Path, alone: bool = True, **bodies: str) -> list[Diagnostic]:
    for name, body in bodies.items():
        code = f"class {name}:\n    def execute(self, context):\n        {body}\n"
        (folder / f"{name.lower()}.py").write_text(code, "utf-8")
    found, _ = check_code(system(SYSTEM), folder, alone=alone)
    return [item for item in found if item.code in ("W555", "W556")]


@pytest.mark.parametrize(
    "body",
    [
        'context.send("inform", Meal(1), "waiter")',
        'context.send("refuse", order, "waiter")',
        "context.send(what, Order(1), whom)",
        'context.receive("cancel", "Order")',
        'context.receive(performative="cancel")',
        "context.receive()",
        'context.last_received("request", "Order", "ann")',
        'other.send("tell", Meal(1), "waiter")',
    ],
)
def test_what_a_participant_does_is_not_told(tmp_path: Path, body: str) -> None:
    assert say(tmp_path, Boil=body) == []


@pytest.mark.parametrize(
    ("body", "says", "hint"),
    [
        ('context.send("tell", Meal(1), "waiter")', "FIPA has no performative `tell`", "it has"),
        ('context.send("infrom", Meal(1), "waiter")', "FIPA has no performative", "did you mean `inform`?"),
        ('context.send("inform", Order(1), "waiter")', "`Boil` sends `inform Order`", "inform Meal"),
        ('context.send("request", Order(1), "waiter")', "sends `request Order`, and `cook` does not", ""),
        ('context.receive("inform", "Meal")', "receives `inform Meal`, and `cook` does not", ""),
        (
            'context.last_received("request", "Meal")',
            "receives `request Meal`",
            "did you mean `request Order`?",
        ),
    ],
)
def test_what_no_participant_of_the_activity_does(tmp_path: Path, body: str, says: str, hint: str) -> None:
    (found,) = say(tmp_path, Boil=body)
    assert found.code == "W555" and says in found.message
    assert hint in (found.hint or "")


def test_a_folder_of_several_systems_is_not_judged(tmp_path: Path) -> None:
    assert say(tmp_path, alone=False, Boil='context.send("tell", Meal(1), "waiter")') == []


def test_what_nothing_sends_or_takes_is_told_once_all_code_is_there(tmp_path: Path) -> None:
    assert say(tmp_path, Boil="pass") == [], "Wait may send it"
    found = say(tmp_path, Wait="pass")
    assert [item.message for item in found] == [
        "no line and no activity of `cook` sends `inform Meal`",
        "no line and no activity of `cook` sends `refuse Order`",
        "no line and no activity of `cook` takes `cancel Order`",
    ]
    sent = 'context.send("inform", Meal(1), "waiter"); context.send("refuse", order, "waiter")'
    assert say(tmp_path, Boil=f'context.receive("cancel"); {sent}') == []


@pytest.mark.parametrize("empty", ['"""Called once."""', "..."])
def test_an_activity_as_the_build_starts_it_may_still_do_it(tmp_path: Path, empty: str) -> None:
    assert say(tmp_path, Boil="pass", Wait=empty) == []
    assert len(say(tmp_path, Wait="pass")) == 3, "pass says that there is nothing to do"


def test_a_module_that_activities_share_may_do_it(tmp_path: Path) -> None:
    assert len(say(tmp_path, Boil="pass", Wait="pass")) == 3
    (tmp_path / "talking.py").write_text(
        "def talk(context, what, whom):\n    context.send(what, whom, whom)\n", "utf-8"
    )
    assert [item.message for item in say(tmp_path)] == [
        "no line and no activity of `cook` takes `cancel Order`"
    ]


SIMULATED = SYSTEM.replace(
    "liveness { robot = cook . Rest }",
    "liveness { robot = cook . Rest }\n"
    "  activities { Wait takes 1s simulated  Boil takes 1s simulated  Rest takes 1s simulated }",
)


def test_a_simulated_activity_sends_and_takes_nothing(tmp_path: Path) -> None:
    for folder in (tmp_path, tmp_path / "nowhere"):
        found, _ = check_code(system(SIMULATED), folder)
        assert [item.message for item in found if item.code == "W556"] == [
            "no line and no activity of `cook` sends `inform Meal`",
            "no line and no activity of `cook` sends `refuse Order`",
            "no line and no activity of `cook` takes `cancel Order`",
        ]
    partly = SIMULATED.replace("Boil takes 1s simulated", "Boil takes 1s")
    assert not [item for item in check_code(system(partly), tmp_path)[0] if item.code == "W556"]
    found, _ = check_code(system(SIMULATED), tmp_path, alone=False)
    assert not found, "another system may have the code"


@pytest.mark.parametrize(
    ("body", "left"),
    [
        ('context.send("tell", Meal(1), "waiter")', ["sends `refuse Order`", "takes `cancel Order`"]),
        ('context.send("refuse", Meal(1), "waiter")', ["takes `cancel Order`"]),
        ('context.receive("cancel", "Meal")', ["sends `inform Meal`", "sends `refuse Order`"]),
    ],
)
def test_what_a_wrong_call_was_meant_for_is_not_told_again(
    tmp_path: Path, body: str, left: list[str]
) -> None:
    found = say(tmp_path, Boil=body, Wait="pass")
    assert [item.code for item in found] == ["W555"] + ["W556"] * len(left)
    assert [item.message.partition("`cook` ")[2] for item in found[1:]] == left


SENT = SYSTEM.replace(
    "control cook { enter Wait : request Order from waiter }",
    """control cook {
    enter Wait : request Order from waiter
    enter Cook : / send inform Meal to waiter
  }""",
)
PREPARED = "context.prepare(Meal(1))"


@pytest.mark.parametrize(
    ("wait", "found"),
    [
        pytest.param("context.log('x')", ["`Wait`"], id="it prepares nothing"),
        pytest.param("context.prepare(Order(1))", ["`Wait`"], id="it prepares another message"),
        pytest.param(PREPARED, [], id="it prepares the message"),
        pytest.param("context.prepare(meal)", [], id="it prepares something"),
        pytest.param("helper(context)", [], id="a helper may prepare it"),
        pytest.param("say = context.prepare; say(Meal(1))", [], id="it prepares by another name"),
    ],
)
def test_what_is_sent_and_no_activity_prepares(wait: str, found: list[str], tmp_path: Path) -> None:
    code = f"class Wait:\n    def execute(self, context):\n        {wait}\n"
    (tmp_path / "wait.py").write_text(code, "utf-8")
    (tmp_path / "boil.py").write_text(code.replace("Wait", "Boil").replace(wait, PREPARED), "utf-8")
    items = [item for item in check_code(system(SENT), tmp_path)[0] if item.code == "W576"]
    assert [item.message.partition(" prepares")[0] for item in items] == [f"the Python of {n}" for n in found]
    fixed = [apply(SENT, item.changes) for item in items]
    assert all("send inform Meal { .. } to waiter" in text for text in fixed)


def test_what_only_a_line_may_send(tmp_path: Path) -> None:
    code = "class Boil:\n    def execute(self, context):\n        CALL\n"
    calls = {
        'context.send("inform", Meal(1), "waiter")': True,
        'context.send("inform", meal, "waiter")': True,
        'context.send("refuse", order, "waiter")': False,
        "context.send(what, Meal(1), whom)": False,
    }
    for call, is_found in calls.items():
        (tmp_path / "boil.py").write_text(code.replace("CALL", call), "utf-8")
        messages = [item.message for item in check_code(system(SENT), tmp_path)[0] if item.code == "W555"]
        assert messages == ["a line of `cook` sends `inform Meal`, so `Boil` may not"] * is_found


def test_a_simulated_activity_prepares_defaults(tmp_path: Path) -> None:
    text = SENT.replace("robot = cook . Rest }", "robot = cook . Rest }  activities { Wait takes 1s }")
    (tmp_path / "boil.py").write_text("class Boil:\n    def execute(self, context):\n        pass\n", "utf-8")
    assert [item for item in check_code(system(text), tmp_path)[0] if item.code == "W576"] == []


OPENS = """system Opens
message Meal { int number }
message Done { int number }
aip talk {
  participant boss { sends request Meal  receives inform Done  process = Wait . Close }
  participant hand { receives request Meal  sends inform Done  process = Work . Tell }
  control boss { enter Wait : / send request Meal to hand  enter Close : inform Done from hand }
  control hand { enter Work : request Meal from boss  enter Tell : / send inform Done { number = 1 } to boss }
}
srm chief { plays talk.boss liveness { chief = boss } activities { Wait waits  Close takes 1s } }
srm crew  { plays talk.hand liveness { crew = hand } activities { Work takes 1s  Tell takes 1s } }
"""


@pytest.mark.parametrize(
    ("old", "new", "is_told"),
    [
        pytest.param("", "", True, id="no activity of the role can have run"),
        pytest.param("= boss }", "= Plan . boss }", False, id="an activity of the role has run"),
        pytest.param("= boss }", "= [Plan] . boss }", False, id="one may have run"),
        pytest.param("= boss }", "= boss || Plan }", False, id="one runs beside it"),
        pytest.param("= boss }", "= boss~ }", False, id="the part before has prepared it"),
        pytest.param("Close takes 1s", "Close takes 1s simulated", False, id="without code it says defaults"),
        pytest.param("request Meal to", "request Meal { .. } to", False, id="it has content"),
    ],
)
def test_what_opens_a_conversation_before_any_activity(
    tmp_path: Path, old: str, new: str, is_told: bool
) -> None:
    (tmp_path / "close.py").write_text(f"class Close:\n    def execute(self, context):\n        {PREPARED}\n")
    (tmp_path / "plan.py").write_text("class Plan:\n    def execute(self, context):\n        f(context)\n")
    problems, _ = check_code(system(OPENS.replace(old, new, 1)), tmp_path)
    told = [item.span.text for item in problems if item.code == "W576" and item.span is not None]
    assert told == (["send request Meal to hand"] if is_told else [])
