"""What `asemec check` says of the members of messages in the Python of the activities."""

from __future__ import annotations

from pathlib import Path

import pytest

from aseme_dsl.diagnostics import Diagnostic
from aseme_dsl.project.code.activity_code import check_code
from tests.support.compiling import system

SYSTEM = """
system Team

enum Mode { IDLE = 0  BUSY = 1 }
enum Side { LEFT = 0  RIGHT = 1 }
message Pose { double x }
message Battery {
  int percent  double volts  string name  bytes raw  bool low  duration age  Mode mode  Pose where
  optional int cycles  repeated double cells
}
message Job { double weight }
topic power { state Battery  data Battery }

aip deal {
  participant buyer { engage "a" receives inform Job  process = Ask }
  participant seller { engage "b" sends inform Job  process = Sell }
  outcome "done"
}

srm player {
  plays deal.buyer
  liveness { player = Search . buyer }
  activities { Search reads power.state.Battery, power.data.Battery for 2s  writes power.state.Battery }
}
"""
IMPORTS = "from monas.Team.messages import Battery, Job, Mode, Pose, Side\n\n\n"


def say(folder: Path, body: str, imports: str = IMPORTS, takes: str = "self, context") -> list[Diagnostic]:
    lines = "\n        ".join(body.split("\n"))
    code = f"{imports}class Search:\n    def execute({takes}):\n        {lines}\n"
    (folder / "search.py").write_text(code, "utf-8")
    return list(check_code(system(SYSTEM), folder)[0])


def shown(found: list[Diagnostic]) -> list[tuple[str, str]]:
    return [(item.code, item.span.text if item.span else "") for item in found]


@pytest.mark.parametrize(
    "given",
    [
        "percent=1, volts=1, name='x', raw=b'', low=True, age=5, mode=Mode.BUSY, where=Pose(1)",
        "-1, +1.5, f'{context.now_ns}', bytes(3), not 3, int(4.5), Mode(1), Pose(x=-2)",
        "cycles=None, cells=(1, 2.5, *more)",
        "cells=[x for x in more]",
        "cells=tuple(more), percent=round(2.5), name=str(1), mode=0",
        "*more, **others",
    ],
)
def test_values_that_fit_or_are_computed(tmp_path: Path, given: str) -> None:
    assert say(tmp_path, f"return Battery({given})") == []


@pytest.mark.parametrize(
    ("given", "place", "message"),
    [
        ("percent='many'", "'many'", "`percent` of `Battery` is `int`, and this is a `str`"),
        ("'many'", "'many'", "`percent` of `Battery` is `int`, and this is a `str`"),
        ("percent=-1.5", "-1.5", "`percent` of `Battery` is `int`, and this is a `float`"),
        ("percent=None", "None", "`percent` of `Battery` is `int`, and this is `None`"),
        ("volts='1'", "'1'", "`volts` of `Battery` is `double`, and this is a `str`"),
        ("name=3", "3", "`name` of `Battery` is `string`, and this is an `int`"),
        ("name=Mode.BUSY", "Mode.BUSY", "`name` of `Battery` is `string`, and this is a `Mode`"),
        ("raw='x'", "'x'", "`raw` of `Battery` is `bytes`, and this is a `str`"),
        ("low='no'", "'no'", "`low` of `Battery` is `bool`, and this is a `str`"),
        ("age=1.5", "1.5", "`age` of `Battery` is `duration`, and this is a `float`"),
        ("mode='BUSY'", "'BUSY'", "`mode` of `Battery` is `Mode`, and this is a `str`"),
        ("mode=Side.LEFT", "Side.LEFT", "`mode` of `Battery` is `Mode`, and this is a `Side`"),
        ("where=(1, 2)", "(1, 2)", "`where` of `Battery` is `Pose`, and this is a `tuple`"),
        ("where=Job()", "Job()", "`where` of `Battery` is `Pose`, and this is a `Job`"),
        ("cycles='x'", "'x'", "`cycles` of `Battery` is `int`, and this is a `str`"),
        ("cells=1.0", "1.0", "`cells` of `Battery` is repeated `double`, and this is a `float`"),
        ("cells=(1, 'x')", "'x'", "`cells` of `Battery` is repeated `double`, and this element is a `str`"),
    ],
)
def test_values_that_do_not_fit(tmp_path: Path, given: str, place: str, message: str) -> None:
    (found,) = say(tmp_path, f"return Battery({given})")
    assert (found.code, found.span and found.span.text, found.message) == ("W547", place, message)


@pytest.mark.parametrize(
    ("imports", "name"),
    [
        ("from monas.Team.messages import Battery as B\n", "B"),
        ("from monas.Team import messages\n", "messages.Battery"),
        ("import monas.Team.messages\n", "monas.Team.messages.Battery"),
        ("import jade_like.Team.messages as m\n", "m.Battery"),
    ],
)
def test_however_the_messages_are_imported(tmp_path: Path, imports: str, name: str) -> None:
    assert shown(say(tmp_path, f"{name}(percent='x')", imports)) == [("W547", "'x'")]
    assert shown(say(tmp_path, f"{name}(percents=1)", imports)) == [("W530", "percents")]


READ = [
    'context.read("power.state.Battery").NAME',
    'mine = context.read("power.state.Battery")\nreturn mine.NAME',
    'if (mine := context.latest_message("power.state.Battery")) is not None:\n    return mine.NAME',
    'mine = context.latest_sample("power.state.Battery")\nreturn mine.message.NAME',
    'mine = context.at("power.data.Battery", 0.5)\nreturn mine.NAME',
    "mine: Battery | None = other()\nreturn mine.NAME",
    "mine = Battery(percent=1)\nreturn mine.NAME",
    "def told(mine: Battery) -> int:\n    return mine.NAME",
]


@pytest.mark.parametrize("body", READ)
def test_a_member_that_is_read_and_is_not_there(tmp_path: Path, body: str) -> None:
    assert say(tmp_path, body.replace("NAME", "percent")) == []
    (found,) = say(tmp_path, body.replace("NAME", "percents"))
    assert (found.code, found.span and found.span.text) == ("W530", "percents")
    assert (found.message, found.hint) == (
        "`Battery` has no member `percents`",
        "did you mean `percent`?",
    )
    assert [item.message for item in say(tmp_path, body.replace("NAME", "where.y"))] == [
        "`Pose` has no member `y`"
    ]


def test_the_content_of_an_agent_message(tmp_path: Path) -> None:
    text = (
        'mail = context.receive("inform", "Job")\nif mail:\n    context.log(mail.content.NAME + mail.sender)'
    )
    (tmp_path / "ask.py").write_text("")
    body = "\n        ".join(text.split("\n"))
    for name, places in (("weight", []), ("wieght", ["wieght"])):
        code = f"class Ask:\n    def execute(self, context):\n        {body.replace('NAME', name)}\n"
        (tmp_path / "ask.py").write_text(code)
        found = check_code(system(SYSTEM), tmp_path)[0]
        assert [item.span and item.span.text for item in found if item.code == "W530"] == places


@pytest.mark.parametrize(
    "body",
    [
        'mine = context.read("power.state.Battery")\nmine = other(mine)\nreturn mine.anything',
        "for mine in others:\n    mine.anything",
        'name = context.read("power.state.Battery").name.upper()',
        'cells = context.read("power.state.Battery").cells.count(1)',
        "Battery.anything",
        'mine = context.latest_sample("power.state.Battery")\nreturn mine.time',
        'mine = self.context.read("power.state.Battery")\nreturn mine.anything',
        "mine: Other = other()\nreturn mine.anything",
    ],
)
def test_what_cannot_be_known_is_not_reported(tmp_path: Path, body: str) -> None:
    assert say(tmp_path, body) == []


@pytest.mark.parametrize("takes", ["self, ctx", "self, ctx: Any", "self, ctx, /", "this, ctx: 'Agent'"])
def test_the_context_is_what_execute_takes_first(tmp_path: Path, takes: str) -> None:
    assert shown(say(tmp_path, 'ctx.read("power.state.Batery")', takes=takes)) == [
        ("W530", '"power.state.Batery"')
    ]
    assert shown(say(tmp_path, 'ctx.set_variable("x", 1)', takes=takes)) == [("W530", '"x"')]
    assert shown(say(tmp_path, "ctx.publsh(1)", takes=takes)) == [("W530", "publsh")]
    assert shown(say(tmp_path, 'ctx.read("power.state.Battery").percents', takes=takes)) == [
        ("W530", "percents")
    ]


def test_the_execute_of_other_classes_takes_what_it_likes(tmp_path: Path) -> None:
    other = (
        'class Query:\n    def execute(self, cursor):\n        cursor.read("a.b.C") or cursor.fetch()\n\n\n'
    )
    assert say(tmp_path, "return Query()", other) == []
    (tmp_path / "helper.py").write_text(other)
    assert say(tmp_path, "return 1") == []


def test_helpers_are_looked_at_too(tmp_path: Path) -> None:
    code = "def made() -> Battery:\n    return Battery(percent='x', percents=1)\n"
    (tmp_path / "helper.py").write_text(IMPORTS + code)
    assert sorted(shown(say(tmp_path, "return 1"))) == [("W530", "percents"), ("W547", "'x'")]
