"""What `asemec check` says of the Python of the activities, which it reads and never runs."""

from __future__ import annotations

from pathlib import Path

import pytest

from aseme_dsl.diagnostics import Diagnostic
from aseme_dsl.diagnostics.changes import apply
from aseme_dsl.project.code.activity_code import check_code
from tests.support.compiling import system

SYSTEM = """
system Team

message Ball { bool visible }
topic vision { state Ball  data Ball }
topic motion { signal Ball }

aip deal {
  participant buyer { engage "It wants." var bids : int = 0 process = Collect . Pay }
  participant seller { engage "It has." process = Offer }
  outcome "Sold."
  control buyer { enter Pay : [bids > 0] }
}

srm player {
  plays deal.buyer
  var tired : bool = false
  liveness { player = Look~ || (Search . Walk . buyer) || Legs~ }
  control player {
    enter Walk : seen
    enter buyer : [tired]
    repeat Legs every 1s :
  }
  activities {
    Look    writes vision.state.Ball, vision.data.Ball
    Search  reads vision.state.Ball, vision.data.Ball for 2s, tired  writes tired, motion.signal.Ball
    Legs    reads motion.signal.Ball
    Collect writes bids
  }
}

srm other { plays deal.seller  liveness { other = seller } }

team Team { one, two : player  three : other }
"""


def say(folder: Path, name: str, code: str, *, alone: bool = True, text: str = SYSTEM) -> list[Diagnostic]:
    (folder / name).write_text(code, "utf-8")
    found, _ = check_code(system(text), folder, alone=alone)
    return list(found)


def activity(body: str, name: str = "Search") -> str:
    return f"class {name}:\n    def execute(self, context):\n        {body}\n"


def shown(found: list[Diagnostic]) -> list[tuple[str, str, str | None]]:
    return [(item.code, item.span.text if item.span else "", item.hint) for item in found]


@pytest.mark.parametrize(
    "body",
    [
        'context.read("vision.state.Ball")',
        'context.history("vision.data.Ball", sender="one")',
        'context.mean("vision.data.Ball", "x", 0.5) or context.age("vision.state.Ball")',
        'context.publish("motion.signal.Ball", ball)',
        'context.set_variable("tired", context.get_variable("tired"))',
        'context.raise_event("seen")',
        "context.read(channel)",
        'other.read("no.state.Channel")',
        'context.log("no.state.Channel")',
    ],
)
def test_what_is_right_or_cannot_be_known_is_not_reported(tmp_path: Path, body: str) -> None:
    assert say(tmp_path, "search.py", activity(body)) == []


@pytest.mark.parametrize(
    ("body", "code", "place", "hint"),
    [
        (
            'context.read("vision.state.Bal")',
            "W530",
            '"vision.state.Bal"',
            "did you mean `vision.state.Ball`?",
        ),
        ('context.read(channel="vison.state.Ball")', "W530", '"vison.state.Ball"', None),
        ('context.consume("motion.state.Ball")', "W530", '"motion.state.Ball"', None),
        ('context.history("vision.state.Ball")', "W530", '"vision.state.Ball"', None),
        ('context.at("vision.state.Ball", 0.1)', "W530", '"vision.state.Ball"', None),
        ('context.interpolated("vision.data.Bal", "x", 1)', "W530", '"vision.data.Bal"', None),
        ('context.latest_sample("vision.state.Ball", sender="on")', "W530", '"on"', "did you mean `one`?"),
        ('context.set_variable("tird", True)', "W530", '"tird"', "did you mean `tired`?"),
        ('context.get_variable("x")', "W530", '"x"', "declare it: `var x : …`"),
        ('context.raise_event("sene")', "W532", '"sene"', "did you mean `seen`?"),
        ('context.publish("vision.state.Ball", ball)', "E540", '"vision.state.Ball"', None),
        ('context.read("motion.signal.Ball")', "E540", '"motion.signal.Ball"', None),
    ],
)
def test_what_is_wrong(tmp_path: Path, body: str, code: str, place: str, hint: str | None) -> None:
    ((found, text, said),) = shown(say(tmp_path, "search.py", activity(body)))
    assert (found, text) == (code, place)
    assert hint is None or said == hint


def test_without_a_team_an_agent_is_called_as_its_role(tmp_path: Path) -> None:
    alone = SYSTEM.partition("team ")[0]
    for sender, said in (("one", [("W530", '"one"', None)]), ("player", [])):
        code = activity(f'context.latest_sample("vision.state.Ball", sender="{sender}")')
        assert shown(say(tmp_path, "search.py", code, text=alone)) == said


def test_constants_other_names_of_the_context_and_helpers_of_the_module_are_understood(
    tmp_path: Path,
) -> None:
    code = """from aseme_dsl.runtime import Context

BALL = "vision.state.Bal"


class Search:
    def execute(self, me: Context) -> None:
        print("ö", me.read(BALL))
        self.context = me
        self._more()

    def _more(self) -> None:
        self.context.publish("vison.state.Ball", 1)
"""
    found = say(tmp_path, "search.py", code)
    assert [(item.span.line, item.span.text) for item in found if item.span] == [
        (8, "BALL"),
        (13, '"vison.state.Ball"'),
    ]
    assert found[0].span is not None and found[0].span.column == 28


def test_what_is_done_several_times_is_said_once(tmp_path: Path) -> None:
    body = 'context.read("motion.signal.Ball"); context.consume("motion.signal.Ball")'
    assert [item.code for item in say(tmp_path, "search.py", activity(body))] == ["E540"]


def test_a_participants_variables_are_those_of_its_activities(tmp_path: Path) -> None:
    assert say(tmp_path, "collect.py", activity('context.set_variable("bids", 3)', "Collect")) == []
    assert say(tmp_path, "pay.py", activity('context.set_variable("bids", 3)', "Pay")) == []
    assert say(tmp_path, "pay.py", activity('context.set_variable("tired", True)', "Pay"))[0].code == "E540"
    assert say(tmp_path, "offer.py", activity('context.get_variable("bids")', "Offer"))[-1].code == "W530"


def test_a_module_that_is_no_python_or_has_no_class(tmp_path: Path) -> None:
    (found,) = say(tmp_path, "search.py", "class Search:\n    def execute(self, context)\n        pass\n")
    assert found.code == "E546" and found.span is not None and found.span.line == 2
    (found,) = say(tmp_path, "search.py", activity("pass", "Serach"))
    assert (found.code, found.hint) == ("E546", "did you mean `Search`?")
    (found,) = say(tmp_path, "search.py", "")
    assert (found.code, found.hint) == ("E546", "write `class Search:`")
    assert say(tmp_path, "search.py", "from .others import Search\n") == []
    assert say(tmp_path, "search.py", "Search = make()\n") == []
    assert say(tmp_path, "search.py", "\0")[0].code == "E546"


def test_other_modules_of_the_folder_are_asked_for_channels_only(tmp_path: Path) -> None:
    code = (
        'def look(context):\n    context.set_variable("a", 1)\n    return context.read("vision.state.Bal")\n'
    )
    assert [item.code for item in say(tmp_path, "knowledge.py", code)] == ["W530"]
    (tmp_path / "knowledge.py").write_text("this is not Python")
    assert check_code(system(SYSTEM), tmp_path) == ((), ())


def test_what_another_system_of_the_folder_may_have_is_not_reported(tmp_path: Path) -> None:
    body = 'context.read("game.state.Score"); context.raise_event("goal"); context.set_variable("score", 1)'
    assert len(say(tmp_path, "search.py", activity(body))) == 3
    assert say(tmp_path, "search.py", activity(body), alone=False) == []
    near = activity('context.read("vision.state.Bal")')
    assert [item.code for item in say(tmp_path, "search.py", near, alone=False)] == ["W530"]


def test_a_folder_that_is_not_there_is_no_problem(tmp_path: Path) -> None:
    assert check_code(system(SYSTEM), tmp_path / "nowhere") == ((), ())


def test_a_comment_on_the_line_allows_it(tmp_path: Path) -> None:
    body = 'context.raise_event("goal")  # asemec: allow(W532) the referee\'s program waits for it'
    assert say(tmp_path, "search.py", activity(body)) == []
    _, (allowed,) = check_code(system(SYSTEM), tmp_path)
    assert (allowed.diagnostic.code, allowed.allow.text) == ("W532", "W532")
    assert allowed.reason == "the referee's program waits for it"
    body = 'context.raise_event("goal")  # asemec: allow(W530) not that'
    assert [item.code for item in say(tmp_path, "search.py", activity(body))] == ["W532"]


def test_a_comment_allows_no_error(tmp_path: Path) -> None:
    body = 'context.read("motion.signal.Ball")  # asemec: allow(E540) it is only for tests'
    assert [item.code for item in say(tmp_path, "search.py", activity(body))] == ["E540"]


def test_an_event_that_no_activity_raises(tmp_path: Path) -> None:
    for name in ("Look", "Walk", "Legs", "Collect", "Pay", "Offer"):
        (tmp_path / f"{name.lower()}.py").write_text(activity("pass", name))
    (found,) = say(tmp_path, "search.py", activity("pass"))
    assert (found.code, found.span and found.span.text) == ("N726", "seen")
    assert [item.code for item in say(tmp_path, "search.py", activity('context.raise_event("sen")'))] == [
        "W532"
    ]
    assert say(tmp_path, "search.py", activity("context.raise_event(name)")) == []
    assert say(tmp_path, "search.py", activity('context.raise_event("seen")')) == []
    say(tmp_path, "search.py", activity("pass"))
    (tmp_path / "helper.py").write_text('def tell(context):\n    context.raise_event("seen")\n')
    assert check_code(system(SYSTEM), tmp_path) == ((), ())
    (tmp_path / "helper.py").unlink()
    (tmp_path / "walk.py").unlink()
    assert check_code(system(SYSTEM), tmp_path) == ((), ())


def test_a_history_is_kept_as_long_as_somebody_says(tmp_path: Path) -> None:
    code = activity('context.history("vision.data.Ball")')
    (found,) = say(tmp_path, "search.py", code, text=SYSTEM.replace(" for 2s", "", 1))
    assert (found.code, found.hint) == (
        "E540",
        "declare how far it looks back: `activities { Search reads vision.data.Ball for … }`",
    )


def test_a_class_that_does_nothing_is_reported_where_it_does_something_else(tmp_path: Path) -> None:
    (found,) = say(tmp_path, "search.py", "class Search:\n    def run(self, context):\n        pass\n")
    assert (found.code, found.hint) == ("E546", "is it `run`?")
    assert found.span is not None and found.span.text == "Search"
    for code in ("speed = 1", "def __init__(self):\n        self.speed = 1"):
        (found,) = say(tmp_path, "search.py", f"class Search:\n    {code}\n")
        assert (found.code, found.hint) == ("E546", "`execute` is what an activity does")
    assert say(tmp_path, "search.py", "class Search:\n    pass\n") == []
    assert say(tmp_path, "search.py", "class Search(Base):\n    def aim(self): ...\n") == []


@pytest.mark.parametrize(
    ("body", "place", "hint"),
    [
        ('context.publsh("vision.state.Ball", Ball(True))', "publsh", "did you mean `publish`?"),
        ("Ball(visble=True)", "visble", "did you mean `visible`?"),
        ("Ball(True, 3)", "Ball(True, 3)", None),
    ],
)
def test_words_that_the_context_and_the_messages_do_not_have(
    tmp_path: Path, body: str, place: str, hint: str | None
) -> None:
    code = "from aseme_dsl.runtime import Context\nfrom monas.Team.messages import Ball\n\n\n"
    code += f"class Search:\n    def execute(self, context: Context) -> None:\n        {body}\n"
    assert shown(say(tmp_path, "search.py", code)) == [("W530", place, hint)]


def test_a_message_that_the_system_does_not_have(tmp_path: Path) -> None:
    code = "from monas.Team.messages import Bal\n\n\n" + activity("pass")
    (found,) = say(tmp_path, "search.py", code)
    assert (found.code, found.hint) == ("W530", "did you mean `Ball`?")
    assert say(tmp_path, "search.py", "from monas.Team.messages import CHANNELS\n" + activity("pass")) == []


ENDS = SYSTEM.replace("Legs    reads", "Walk    ends there, lost\n    Legs    reads")


@pytest.mark.parametrize(
    "body",
    [
        'return "there"',
        'return "lost" if context.cancelled else LOST',
        "return how(context)",
        "raise NotImplementedError",
        "while True: context.wait(1)",
        "pass",
        "def inner():\n            return 3\n        return inner()",
    ],
)
def test_outcomes_that_are_right_or_computed(tmp_path: Path, body: str) -> None:
    code = 'LOST = "lost"\n' + activity(body, "Walk")
    assert say(tmp_path, "walk.py", code, text=ENDS) == []


@pytest.mark.parametrize(
    ("body", "place", "hint"),
    [
        ('return "their"', '"their"', "did you mean `there`?"),
        ('return "x" if context.cancelled else "there"', '"x"', "it ends `there` or `lost`"),
        ("return", "return", 'return "there", say'),
        ("context.wait(1)", "context.wait(1)", 'return "there", say'),
        ("return None", "return None", 'return "there", say'),
    ],
)
def test_an_outcome_that_the_activity_does_not_have(tmp_path: Path, body: str, place: str, hint: str) -> None:
    found = say(tmp_path, "walk.py", activity(body, "Walk"), text=ENDS)
    assert shown(found) == [("W530", place, hint)]


MODULES = SYSTEM.replace(
    "  activities {",
    """  modules {
    Vision every 33ms reads vision.state.Ball, tired writes vision.data.Ball, tired
    Sight  every 1s writes vision.data.Ball = "seeing.eyes:Eyes"
  }
  activities {""",
    1,
)


class TestModules:
    def test_an_execute_is_given_the_context_only(self, tmp_path: Path) -> None:
        code = "class Vision:\n    def execute(self, context, speed):\n        context.wait(1)\n"
        found = say(tmp_path, "vision.py", code, text=MODULES)
        assert shown(found) == [("E546", "execute", "leave it out: a module is given nothing")]

    def test_what_is_right_is_not_reported(self, tmp_path: Path) -> None:
        for code in (
            'context.publish("vision.data.Ball", context.read("vision.state.Ball"))',
            'context.set_variable("tired", not context.get_variable("tired"))',
        ):
            assert say(tmp_path, "vision.py", activity(code, "Vision"), text=MODULES) == []

    @pytest.mark.parametrize(
        "body, code, place, hint",
        [
            (
                'context.publish("motion.signal.Ball", ball)',
                "E540",
                '"motion.signal.Ball"',
                "declare it: `modules { Vision writes motion.signal.Ball }`",
            ),
            (
                'context.read("vision.state.Bal")',
                "W530",
                '"vision.state.Bal"',
                "did you mean `vision.state.Ball`?",
            ),
            ('context.set_variable("tyred", True)', "W530", '"tyred"', "did you mean `tired`?"),
            (
                'context.set_variable("bids", 1)',
                "W530",
                '"bids"',
                "declare it: `var bids : …`",
            ),  # a participant's
            ('context.raise_event("sen")', "W532", '"sen"', "did you mean `seen`?"),
        ],
    )
    def test_what_is_wrong(self, tmp_path: Path, body: str, code: str, place: str, hint: str) -> None:
        found = say(tmp_path, "vision.py", activity(body, "Vision"), text=MODULES)
        assert shown(found) == [(code, place, hint)]

    def test_a_class_that_is_missing(self, tmp_path: Path) -> None:
        found = say(tmp_path, "vision.py", "class Vison:\n    pass\n", text=MODULES)
        assert [item.message for item in found] == ["the code of the module `Vision` has no class `Vision`"]
        assert shown(found) == [("E546", "Vison", "did you mean `Vision`?")]

    def test_a_class_elsewhere_in_the_project_is_read_there(self, tmp_path: Path) -> None:
        (tmp_path / "activities").mkdir()
        (tmp_path / "seeing").mkdir()
        eyes = tmp_path / "seeing" / "eyes.py"

        def found(code: str) -> list[Diagnostic]:
            eyes.write_text(code)
            return list(check_code(system(MODULES), tmp_path / "activities", project=tmp_path)[0])

        assert found(activity('context.publish("vision.data.Ball", x)', "Eyes")) == []
        wrong = found(activity('context.publish("vision.data.Bal", x)', "Eyes"))
        assert shown(wrong) == [("W530", '"vision.data.Bal"', "did you mean `vision.data.Ball`?")]
        assert [item.message for item in found("class Ears:\n    pass\n")] == [
            "the code of the module `Sight` has no class `Eyes`"
        ]
        eyes.unlink()
        (gone,) = check_code(system(MODULES), tmp_path / "activities", project=tmp_path)[0]
        assert gone.message == "the code of the module `Sight` cannot be found: there is no `seeing.eyes`"
        assert gone.span is not None and gone.span.text.startswith("Sight")

    def test_an_event_that_only_a_module_raises_is_raised(self, tmp_path: Path) -> None:
        text = MODULES.replace('    Sight  every 1s writes vision.data.Ball = "seeing.eyes:Eyes"\n', "")
        for name in ("Look", "Search", "Walk", "Legs", "Collect", "Pay", "Offer"):
            (tmp_path / f"{name.lower()}.py").write_text(activity("pass", name))
        assert shown(say(tmp_path, "vision.py", activity("pass", "Vision"), text=text)) == [
            ("N726", "seen", 'raise it in an activity: `context.raise_event("seen")`')
        ]
        assert say(tmp_path, "vision.py", activity('context.raise_event("seen")', "Vision"), text=text) == []


IMPORTS = "from monas.Team.messages import Ball, Pose as P\n\n\nclass Point:\n    pass\n\n\n"


class TestMessagesThatDoNotFit:
    TEXT = SYSTEM.replace("topic vision", "message Pose { double x }\ntopic vision")

    @pytest.mark.parametrize(
        "body",
        [
            'context.publish("motion.signal.Ball", Ball(True))',
            'context.publish("motion.signal.Ball", message=ball)',
            'context.publish("motion.signal.Ball", make())',
            'x = Ball()\n        context.publish("motion.signal.Ball", x)',
            'x = P()\n        x = Ball()\n        context.publish("motion.signal.Ball", x)',
            'x = P()\n        for x in balls:\n            context.publish("motion.signal.Ball", x)',
            'context.publish("motion.signal.Ball", Unknown())',
            'context.publish("motion.signal.Ball", Ball() if a else b)',
        ],
    )
    def test_what_fits_or_cannot_be_known(self, tmp_path: Path, body: str) -> None:
        assert say(tmp_path, "search.py", IMPORTS + activity(body), text=self.TEXT) == []

    @pytest.mark.parametrize(
        "body, place, message",
        [
            ('context.publish("motion.signal.Ball", P(1.0))', "P(1.0)", "a `Pose`"),
            ('context.publish("motion.signal.Ball", message=P())', "P()", "a `Pose`"),
            ('context.publish("motion.signal.Ball", True)', "True", "what is not a message"),
            (
                'context.publish("motion.signal.Ball", {"visible": True})',
                '{"visible": True}',
                "what is not a message",
            ),
            (
                'context.publish("motion.signal.Ball", Point())',
                "Point()",
                "a `Point`, which is not a message",
            ),
            ('context.publish("motion.signal.Ball", Ball)', "Ball", "the class `Ball` itself"),
            ('x = P()\n        context.publish("motion.signal.Ball", x)', "x", "a `Pose`"),
        ],
    )
    def test_what_does_not_fit(self, tmp_path: Path, body: str, place: str, message: str) -> None:
        (found,) = say(tmp_path, "search.py", IMPORTS + activity(body), text=self.TEXT)
        assert (found.code, found.span.text if found.span else "") == ("W540", place)
        assert found.message == f"`motion.signal.Ball` carries `Ball`, and this is {message}"

    def test_in_a_module_and_in_a_helper_too(self, tmp_path: Path) -> None:
        text = MODULES.replace("topic vision", "message Pose { double x }\ntopic vision")
        code = IMPORTS + activity('context.publish("vision.data.Ball", P())', "Vision")
        assert [item.code for item in say(tmp_path, "vision.py", code, text=text)] == ["W540"]
        (tmp_path / "vision.py").unlink()
        helper = IMPORTS + 'def tell(context):\n    context.publish("vision.data.Ball", P())\n'
        assert [item.code for item in say(tmp_path, "helper.py", helper, text=text)] == ["W540"]


GIVEN = SYSTEM.replace("Search . Walk .", "Search . Walk(3, 1.5) .").replace(
    "Legs    reads", "Walk(steps : int, far : double)\n    Legs    reads"
)


@pytest.mark.parametrize(
    "signature",
    [
        "self, context, steps, far",
        "self, context, far, steps=3",
        "self, context, *, steps, far=1.0",
        "self, context, **given",
        "self, context, steps, far, more=None",
        "self, context, /, steps, far",
        "self, context, far=1.0, /, **given",
    ],
)
def test_an_execute_that_takes_what_the_activity_is_given(tmp_path: Path, signature: str) -> None:
    code = f"class Walk:\n    def execute({signature}):\n        context.wait(1)\n"
    assert say(tmp_path, "walk.py", code, text=GIVEN) == []


@pytest.mark.parametrize(
    ("signature", "hints"),
    [
        ("self, context", ["write `def execute(self, context, steps, far)`"] * 2),
        ("self, context, step, far", ["did you mean `steps` where it takes `step`?"]),
        (
            "self, context, steps, far, mood",
            ["say so among the activities, `Walk(mood : …)`, or leave it out"],
        ),
        (
            "self, context, steps, /, far",
            ["write `def execute(self, context, steps, far)`, without `/`"],
        ),
        (
            "self, context, steps, far=1.0, /",
            ["write `def execute(self, context, steps, far)`, without `/`"] * 2,
        ),
        ("self, context, steps, /, **given", ["write `def execute(self, context, steps, far)`, without `/`"]),
        ("self, *rest", ["write `def execute(self, context, steps, far)`"] * 2),
    ],
)
def test_an_execute_that_does_not(tmp_path: Path, signature: str, hints: list[str]) -> None:
    code = f"class Walk:\n    def execute({signature}):\n        context.wait(1)\n"
    found = say(tmp_path, "walk.py", code, text=GIVEN)
    assert shown(found) == [("E546", "execute", hint) for hint in hints]
    decorated = code.replace("    def", "    @timed\n    def")
    found = say(tmp_path, "walk.py", f"from timing import timed\n\n\n{decorated}", text=GIVEN)
    assert shown(found) == [("W530", "execute", hint) for hint in hints]


def test_a_static_execute_takes_no_self(tmp_path: Path) -> None:
    code = "class Walk:\n    @staticmethod\n    def execute({}):\n        return 1\n"
    assert say(tmp_path, "walk.py", code.format("context, steps, far"), text=GIVEN) == []
    found = say(tmp_path, "walk.py", code.format("context, steps"), text=GIVEN)
    assert shown(found) == [("E546", "execute", "write `def execute(context, steps, far)`")]


@pytest.mark.parametrize(
    ("body", "line"),
    [
        (
            'context.publish("motion.signal.Ball", b)',
            "Legs    reads motion.signal.Ball writes motion.signal.Ball",
        ),
        ('context.read("vision.state.Ball")', "Legs    reads motion.signal.Ball, vision.state.Ball"),
        ('context.at("vision.data.Ball", 3)', "Legs    reads motion.signal.Ball, vision.data.Ball for 3s"),
    ],
)
def test_the_fix_declares_what_is_used(tmp_path: Path, body: str, line: str) -> None:
    (found,) = say(tmp_path, "legs.py", activity(body, "Legs"))
    changed = apply(SYSTEM, found.edits)
    assert line in changed
    assert say(tmp_path, "legs.py", activity(body, "Legs"), text=changed) == []


def test_the_fix_describes_an_activity_of_which_nothing_is_said(tmp_path: Path) -> None:
    (found,) = say(tmp_path, "walk.py", activity('context.set_variable("tired", True)', "Walk"))
    changed = apply(SYSTEM, found.edits)
    assert "    Walk writes tired\n" in changed
    assert (
        say(tmp_path, "walk.py", activity('context.set_variable("tired", True)', "Walk"), text=changed) == []
    )


def test_a_function_that_the_class_does_not_use_may_be_for_another_activity(tmp_path: Path) -> None:
    helper = 'def ask(context):\n    return context.read("motion.signal.Ball")\n\n\n'
    assert say(tmp_path, "search.py", helper + activity("pass")) == []
    assert [item.code for item in say(tmp_path, "search.py", helper + activity("ask(context)"))] == ["E540"]


@pytest.mark.parametrize("takes", ["", "self", "context", "self, *, context"])
def test_an_execute_that_takes_no_context_cannot_run(tmp_path: Path, takes: str) -> None:
    found = say(tmp_path, "search.py", f"class Search:\n    def execute({takes}):\n        return 1\n")
    assert shown(found) == [("E546", "execute", "write `def execute(self, context)`")]


@pytest.mark.parametrize(
    "takes", ["self, context", "self, ctx, /", "*all", "self, *rest", "self, context, more=1"]
)
def test_an_execute_that_takes_a_context(tmp_path: Path, takes: str) -> None:
    code = f"class Search:\n    def execute({takes}):\n        return 1\n"
    assert say(tmp_path, "search.py", code) == []


@pytest.mark.parametrize(
    "line",
    ["from monas.Old.messages import Ball", "import jade_like.Old.messages as m", "from monas import Old"],
)
def test_an_import_from_a_system_that_was_renamed(tmp_path: Path, line: str) -> None:
    found = say(tmp_path, "search.py", f"{line}\n" + activity("return 1"))
    backend = "jade_like" if "jade" in line else "monas"
    assert shown(found) == [("E546", "Old", f"did you mean `{backend}.Team`?")]
    assert found[0].fix == "Team"
    assert say(tmp_path, "search.py", f"{line.replace('Old', 'Team')}\n" + activity("return 1")) == []
    assert say(tmp_path, "search.py", f"{line}\n" + activity("return 1"), alone=False) == []
    tried = f"try:\n    {line}\nexcept ImportError:\n    pass\n"
    assert say(tmp_path, "search.py", tried + activity("return 1")) == []


@pytest.mark.parametrize(
    ("line", "place", "hint"),
    [
        ("from monas.Team.mesages import Ball, Other", "mesages", "did you mean `messages`?"),
        ("import monas.Team.mesages as m", "mesages", "did you mean `messages`?"),
        ("from monas.Team import mesages", "mesages", "did you mean `messages`?"),
        ("from jade_like.Team.playr import step", "playr", "did you mean `player`?"),
        ("from jade_like.Team.player import behaviour", "behaviour", "did you mean `behaviours`?"),
        ("import monas.Team.player.stp", "stp", "did you mean `step`?"),
        ("import monas.Team.player.agent", "agent", "there is `plan`, `step`"),
        ("from monas.Team.zz import Ball", "zz", "there is `messages`, `player`, `other`"),
    ],
)
def test_an_import_of_a_module_that_is_not_generated(
    tmp_path: Path, line: str, place: str, hint: str
) -> None:
    assert shown(say(tmp_path, "search.py", f"{line}\n" + activity("return 1"))) == [("E546", place, hint)]


@pytest.mark.parametrize(
    ("line", "place", "hint"),
    [
        (
            "from aseme_dsl.runtime.directory import Entry",
            "directory",
            "it is `aseme_dsl.runtime.conversation.directory` now",
        ),
        ("import aseme_dsl.runtime.machine", "machine", "it is `aseme_dsl.runtime.plain.machine` now"),
        ("from aseme_dsl.nothing.at import all", "nothing", None),
    ],
)
def test_an_import_of_a_module_of_ours_that_was_moved(
    tmp_path: Path, line: str, place: str, hint: str | None
) -> None:
    found = say(tmp_path, "search.py", f"{line}\n" + activity("return 1"))
    assert shown(found) == [("E546", place, hint)]
    right = (
        "from aseme_dsl.runtime import Context, ports, plain\nimport aseme_dsl.runtime.plain.machine\n"
        "import aseme_dsl\n"
    )
    assert say(tmp_path, "search.py", right + activity("return 1")) == []


@pytest.mark.parametrize(
    "line",
    [
        "from monas.Team import TEAM, messages as m, player, PlayerStep",
        "from monas.Team import *",
        "from monas.Team.messages import *",
        "import monas.Team.other.plan",
        "from monas.Team.player import PLAYER",
        "from jade_like.Team.player.behaviours import Search",
        "import monas",
        "try:\n    import monas.Team.mesages\nexcept ImportError:\n    pass",
    ],
)
def test_an_import_of_what_is_generated(tmp_path: Path, line: str) -> None:
    assert say(tmp_path, "search.py", f"{line}\n" + activity("return 1")) == []


BROKEN = "def far(:\n    return 1\n"


@pytest.mark.parametrize(
    "line",
    ["from .helper import far", "from . import helper", "import acts.helper", "from acts import helper"],
)
def test_a_file_that_an_activity_imports_and_that_is_no_python(tmp_path: Path, line: str) -> None:
    folder = tmp_path / "acts"
    folder.mkdir()
    (folder / "helper.py").write_text(BROKEN)

    def found(code: str) -> list[Diagnostic]:
        (folder / "search.py").write_text(code + activity("return 1"))
        return list(check_code(system(SYSTEM), folder, project=tmp_path)[0])

    (problem,) = found(f"{line}\n")
    assert problem.code == "E546" and problem.message.endswith("; `search.py` imports it")
    assert problem.span is not None
    assert (problem.span.source.path, problem.span.line) == (str(folder / "helper.py"), 1)
    assert found("") == []  # nobody imports it
    assert found(f"try:\n    {line}\nexcept Exception:\n    pass\n") == []
    assert found(f"from typing import TYPE_CHECKING\n\nif TYPE_CHECKING:\n    {line}\n") == []
    (folder / "between.py").write_text(f"{line}\n")
    (problem,) = found("from .between import far\n")
    assert problem.message.endswith("; `between.py` imports it")
