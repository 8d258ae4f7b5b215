"""One cause gives one message, and the message says which of two names is the slip."""

from __future__ import annotations

import pytest

from aseme_dsl.compiler import analyse
from aseme_dsl.diagnostics import Diagnostic
from aseme_dsl.diagnostics.changes import apply
from aseme_dsl.source import Source


def found(text: str) -> list[Diagnostic]:
    return [item for item in analyse(Source("one.aseme", text)).diagnostics if item.code[0] != "N"]


def codes(text: str) -> list[str]:
    return [item.code for item in analyse(Source("one.aseme", text)).diagnostics if item.code != "N704"]


def test_a_timer_misspelt_in_a_choice_is_no_gap() -> None:
    [item] = found(
        "system S srm r { liveness { r = A . (B | C)+ }  control r {"
        "  enter (B | C) : / start_timer(shift, 1s)"
        "  enter B : [1 < 2]  enter C : else"
        "  repeat (B | C) : [!expired(shift)]  leave (B | C) : [expired(shif)] } }".replace(
            "[1 < 2]", "[f()]"
        )
        + '  function f() : bool = "m:f"'
    )
    assert (item.code, item.hint) == ("W501", "did you mean `shift`?")


def test_a_timer_that_is_asked_twice_and_never_started() -> None:
    [item] = found(
        "system S srm r { liveness { r = A . B+ }  control r {"
        "  repeat B : [!expired(shift)]  leave B : [expired(shift)] } }"
    )
    assert item.code == "W501"
    assert [place.message for place in item.related] == ["also here"]


@pytest.mark.parametrize("line", ["repeat A : go / n = new M { a = 1 }", "leave A : stop / n ="])
def test_a_line_that_cannot_be_read_may_say_how_a_state_is_left(line: str) -> None:
    lines = {"repeat A": "repeat A : go / n = 1", "leave A": "leave A : stop / n = 2"}
    lines[line.partition(" :")[0]] = line
    text = "\n".join(lines.values())
    [item] = found(
        "system S srm r { var n : int = 0  liveness { r = A+ }  activities { A waits }\n"
        f"control r {{\n{text}\n}} }}"
    )
    assert item.code == "E102"


FORMULAS = """system S
topic t { state M }
message M { bool a }
srm r {
  liveness {
    r = Wait . (USE | Rest)
    DECLARED = Turn . Drive*
  }
  control r {
    enter CONTROLLED : [t.state.M.a]
    enter Rest : else
  }
}
"""


def test_a_formula_misspelt_where_it_is_used() -> None:
    text = """system S
topic t { state M }
message M { bool a }
srm r {
  liveness {
    r = Wait . serch
    search = Turn . [Drive]
  }
  control search {
    enter Drive : [t.state.M.a]
    skip Drive : else
  }
}
"""
    [item] = found(text)
    assert (item.code, item.fix, item.hint) == ("E302", "search", "did you mean `search`?")
    assert item.span is not None and item.span.text == "serch"


def test_a_formula_misspelt_where_it_is_declared() -> None:
    text = FORMULAS.replace("USE", "search").replace("DECLARED", "serch").replace("CONTROLLED", "search")
    [item] = found(text)
    assert (item.code, item.fix) == ("E302", "search")
    assert item.span is not None and item.span.text == "serch"


def test_a_formula_that_is_not_there_has_no_activities() -> None:
    text = """system S
srm r {
  liveness {
    r = Wait . search
    search =
    carry = Lift
  }
  activities { Turn takes 1s  Drive takes 1s }
}
"""
    assert codes(text) == ["E100"]


def test_a_protocol_misspelt_in_plays() -> None:
    text = """system S
suc { usecase deal by r, s includes Offer, Take }
aip deal {
  participant r { process = Offer }
  participant s { process = Take }
}
srm r { plays dael.r  liveness { r = r } }
srm s { plays deal.s  liveness { s = s } }
"""
    text = text.replace(
        "srm r { plays dael.r  liveness { r = r } }", "srm x { plays dael.r  liveness { x = r } }"
    )
    text = text.replace(
        "srm s { plays deal.s  liveness { s = s } }", "srm y { plays deal.s  liveness { y = s } }"
    )
    text = text.replace("by r, s", "by x, y")
    assert codes(text) == ["E205"]


def test_swapped_arguments() -> None:
    [item] = found(
        "system S message B { double x }  topic t { state B }"
        '  function near(B ball, double limit) : bool = "m:near"'
        "  srm r { liveness { r = A | C }  control r { enter A : [near(2.0, t.state.B)]  enter C : else } }"
    )
    assert item.code == "E504"
    assert item.hint is not None and "near(t.state.B, 2.0)" in item.hint


def test_a_variable_assigned_to_itself() -> None:
    [item] = found(
        "system S srm r { var n : int = 0  liveness { r = A | C }"
        "  control r { enter A : [n > 2] / n = n  enter C : else } }"
    )
    assert item.code == "W500"


def test_other_words_for_operators() -> None:
    for word, meant in (("AND", "&&"), ("OR", "||"), ("And", "&&")):
        [item] = found(
            "system S srm r { var a : bool  var b : bool  liveness { r = A | C }"
            f"  control r {{ enter A : [a {word} b]  enter C : else }} }}"
        )
        assert item.code == "E102"
        assert item.hint is not None and meant in item.hint
        assert item.fix == meant


def test_a_variable_is_read_by_a_clause() -> None:
    text = "system S  srm r { var tries : int = 0  liveness { r = A }  activities { A reads tries } }"
    assert codes(text) == []
    assert codes(text.replace("reads tries", "reads tries for 2s")) == ["E503"]


def test_a_wait_with_a_time_limit_is_meant() -> None:
    text = """system S
topic t { state M }
message M { bool a }
srm r {
  liveness { r = Look . Go }
  activities { Look takes 1s  Go takes 1s  See writes t.state.M }
  control r { enter Go : when [t.state.M.a]  enter Go : after(5s) }
}
"""
    text = text.replace("r = Look . Go", "r = See~ || go  go = Look . Go").replace("control r", "control go")
    assert codes(text) == []
    assert codes(text.replace("enter Go : after(5s)", "")) == []
    assert codes(text.replace("enter Go : when [t.state.M.a]", "")) == ["N724"]


PLAYED = """system S
topic t { state M }
message M { bool a }
aip share {
  participant first { process = Look }
  participant second { process = Wait . [Go] }
  control second { enter Go : [t.state.M.a]  skip Go : else }
}
srm robot {
  plays share.first
  plays share.second
  liveness { robot = (first | second)~ }
  control robot { enter first : [t.state.M.a]  enter second : else }
}
team Robots { one, two : robot }
property once: always one.Look or two.Look
"""


def test_uses_that_agree_are_not_renamed() -> None:
    """Where nothing but its declaration has a name, the declaration is the slip."""
    for declaration, slip in (
        ("participant second", "participant scond"),
        ("    robot = (first", "    roboot = (first"),
        ("liveness { robot", "liveness { robt"),
        ("srm robot", "srm robt"),
        ("aip share", "aip shar"),
        ("message M", "message MM"),
    ):
        text = PLAYED.replace(declaration, slip)
        for _ in range(3):
            edits = [edit for item in analyse(Source("one.aseme", text)).diagnostics for edit in item.changes]
            assert all(slip.endswith(edit.span.text) for edit in edits), (slip, edits)
            text = apply(text, edits)
        assert text == PLAYED.replace(declaration, slip) or text == PLAYED


def test_a_state_that_never_completes_is_not_asked_to_be_left_then() -> None:
    text = """system S
srm r {
  liveness { r = (work . Rest)~  work = LOOP }
  activities { A takes 1s  Rest takes 1s }
  control r { enter Rest : after(5s) }
}
"""
    assert codes(text.replace("LOOP", "A~")) == []
    assert codes(text.replace("LOOP", "A . A")) == ["N724"]


TIDY = """system S
message M { bool a }
topic flour { state M }
let low = flour.state.M.a
aip share { participant first { process = Look } }
srm r {
  plays share.first
  liveness { r = (first . Go)~ }
  activities { Look takes 1s  Go takes 1s }
  modules { See every 1s writes flour.state.M }
  control r { enter Go : [low] }
}
team T { one : r }
"""


def only(text: str) -> Diagnostic:
    [item] = [item for item in found(text) if item.code[0] == "E"]
    return item


def test_conditions_as_other_languages_write_them() -> None:
    for written in ("if low", "when low", "if [low]", "if low / read_messages"):
        item = only(TIDY.replace("[low]", written))
        assert (item.code, "[low]" in (item.fix or item.hint or "") or "without" in item.message) == (
            "E102",
            True,
        )
    assert only(TIDY.replace("[low]", "if low")).fix == "[low]"
    assert only(TIDY.replace("[low]", "when low")).fix == "[low]"


def test_a_process_by_almost_its_name() -> None:
    item = only(TIDY.replace("process =", "proces ="))
    assert (item.code, item.fix) == ("E305", "process")
    assert item.span is not None and item.span.text == "proces"


def test_the_library_is_offered_for_what_it_declares_as_that() -> None:
    item = only(TIDY.replace("low = flour", "low = floor"))
    assert (item.code, item.fix) == ("E502", "flour"), "`floor` of the library is a function"
    item = only(TIDY.replace("low = flour.state.M.a", "low = game.state.M.a"))
    assert "import" not in (item.hint or ""), "the library's topic does not carry it"
    item = only(TIDY.replace("low = flour.state.M.a", "low = vision.state.Ball.visible"))
    assert item.hint == "`import soccer` declares it"


def test_what_a_publisher_is_declared_in_was_not_read() -> None:
    text = TIDY.replace("{ state M }", "{ state M from See }")
    assert found(text) == []
    [item] = found(text.replace("srm r {", "srm r {{"))
    assert item.code == "E100"


def test_a_topic_with_a_message_that_is_none() -> None:
    [item] = [item for item in found(TIDY.replace("{ state M }", "{ state X }")) if item.code[0] == "E"]
    assert (item.code, item.message) == ("E502", "there is no message `X`")


def test_words_of_other_languages() -> None:
    assert only(TIDY.replace("aip share", "protocol share")).fix == "aip"
    item = only(TIDY.replace("one : r", "one[3] : r"))
    assert (item.code, item.fix) == ("E100", "1..3")
    [item] = [item for item in found(TIDY.replace("[low]", "[low && !low]")) if item.code == "W412"]
    assert item.hint is not None


def test_a_term_misspelt_in_resume() -> None:
    [item] = found(
        "system S srm r { liveness { r = idle . patrols  idle = Rest  patrols = Walk . Look }"
        "  control r { resume patrol : } }"
    )
    assert (item.code, item.hint) == ("E400", "did you mean `patrols`?")


def test_what_waits_to_cut_short_what_never_ends() -> None:
    [item] = found(
        "system S srm r { var b : bool = false  liveness { r = (work [> Recharge)~  work = A~ }"
        "  activities { A takes 1s writes b  Recharge takes 1s }  control r { enter Recharge : [b] } }"
    )
    assert item.code == "E420"


AUCTION = """system S
message M { int x }
aip p {
  participant a {
    engage "Always."
    var best : agent
    var zone : int = 0
    sends cfp M  receives propose M  process = X . Y
  }
  participant o { engage "Always."  sends propose M  receives cfp M  process = Z }
  control a { enter Y : propose M m from o / best = sender(m); LINE }
}
srm R { plays p.a  liveness { R = a } }
srm Q { plays p.o  liveness { Q = o } }
"""


def test_an_agent_misspelt_behind_to() -> None:
    (item, *_) = found(AUCTION.replace("LINE", "send cfp M { x = zone } to bets"))
    assert (item.code, item.hint, item.fix) == ("E205", "did you mean `best`?", "best")
    (item, *_) = found(AUCTION.replace("LINE", "send cfp M { x = zone } to nobody"))
    assert (item.code, item.hint) == ("E205", "there are `a` and `o`")


def test_index_misspelt() -> None:
    (item, *_) = found(AUCTION.replace("LINE", "zone = Index"))
    assert (item.code, item.hint) == ("E200", "did you mean `index`?")


def test_a_pace_of_what_is_no_loop_beside_an_else() -> None:
    [item] = found(
        "system S srm r { var n : int = 0  liveness { r = A . [B] }  activities { A takes 1s writes n }"
        "  control r { enter B every 5s : [n > 1]  skip B : else } }"
    )
    assert item.code == "E432"


def test_an_exit_that_does_nothing_is_not_told_to_wait() -> None:
    [item] = found("system S srm r { liveness { r = A . B }  control r { exit A : } }")
    assert (item.code, item.hint) == ("E423", "write what is done: `exit A : / light = true`")


def test_an_activity_with_parameters_in_a_statechart() -> None:
    """A statechart has no place for what an activity is given."""
    [item] = found(
        "system S statechart c { state 0 OR  state 0.1 START  state 0.2 BASIC Go  state 0.3 END"
        "  0.1 -> 0.2 :  0.2 -> 0.3 :  activities { Go(to : int) takes 1s } }"
    )
    assert (item.code, item.span and item.span.text) == ("E523", "Go")


def test_a_participant_where_one_agent_of_it_is_meant() -> None:
    (item, *_) = found(AUCTION.replace("LINE", "best = o"))
    assert item.code == "E200"
    assert (
        item.hint == "it is a participant; one agent of it is the `sender(…)` of a message that it has sent"
    )


def test_a_formula_that_is_replaced_with_its_control() -> None:
    [item] = found(
        "system S abstract srm base { var n : int = 0  liveness { walk = A . B }"
        "  control walk { enter B : [n > 3] / n = n + 1 } }"
        "srm robot { includes base  liveness { robot = walk  walk = C . D }"
        "  control walk { enter D : [n > 1] } }"
    )
    assert item.code == "E223" and "the formula `walk`" in item.message


def test_a_blank_before_a_unit_hides_the_outcomes_behind_it() -> None:
    text = """system S
srm r {
  liveness { r = (Brew . Pour)~ }
  activities {
    Brew within 10 s ends ok, bad
    Pour takes 2s
  }
  control r {
    repeat (Brew . Pour) : [outcome(Brew) == ok or outcome(Brew) != bad]
  }
}
"""
    [item] = found(text)
    assert (item.code, item.fix) == ("E108", "10s")
    assert found(text.replace("10 s ends ok, bad", "10s"))[0].code == "E520"


CONTROL = """system S
srm r {
  var NAME : int = 0
  liveness { r = (Brew . work)~  work = A . B }
  control r {
    repeat (Brew . work) :
    LINE
    repeat (Brew . work) : error
  }
}
"""


@pytest.mark.parametrize(
    ("line", "after"),
    [
        ("resume work", "'work'"),
        ("exit work / n = 1", "'work', found '/'"),
        ("exit (A . B) / n = 1", "')', found '/'"),
        ("on work [n > 2] / n = 1", "'work', found '['"),
        ("on work . A / n = 1", "'work . A', found '/'"),
        ("on work when [n > 2] / n = 1", "'work', found 'when'"),
    ],
)
def test_a_verb_without_its_colon(line: str, after: str) -> None:
    [item] = found(CONTROL.replace("NAME", "n").replace("LINE", line))
    assert (item.code, item.message) == ("E102", f"expected ':' after {after}")
    assert item.hint is not None
    assert item.hint.startswith(f"write {line.split()[0]} TERM :")


@pytest.mark.parametrize("name", "enter skip repeat leave start finish on exit resume".split())
def test_a_variable_may_be_called_like_a_verb(name: str) -> None:
    line = "enter work : [NAME < 2 && (1 == NAME) || !(2 > NAME)] / NAME = NAME + 1; NAME = 2"
    codes = {item.code for item in found(CONTROL.replace("LINE", line).replace("NAME", name))}
    assert codes <= {"W438"}  # where the variable is 0, nothing leads on


TEAM = """system S
topic kitchen { state Kitchen }
message Kitchen { bool stop }
srm R {
  var strength : int = 1
  liveness { R = A . B } COMMENT
  MEMBER
  activities { A takes 1s writes kitchen.state.Kitchen }
  control R { enter B : CONDITION }
}
team T { ann AGENT }
"""


@pytest.mark.parametrize(
    ("wrong", "right", "code", "hint"),
    [
        ("MEMBER", "int rounds = 0", "E100", "write var rounds : int = 0"),
        ("COMMENT", "# both", "E100", "comments begin with '//'"),
        ("CONDITION", "[kitchen.stop]", "E503", "write `kitchen.state.Kitchen.stop`"),
        ("AGENT", "= R", "E100", "write ann : R"),
        ("AGENT", ": R with (strength = 2)", "E100", "write with NAME = VALUE, NAME = VALUE"),
    ],
)
def test_what_is_written_so_in_other_languages(wrong: str, right: str, code: str, hint: str) -> None:
    text = TEAM.replace(wrong, right)
    for place, usual in (("MEMBER", ""), ("COMMENT", ""), ("CONDITION", ""), ("AGENT", ": R")):
        text = text.replace(place, usual)
    [item] = found(text)
    assert (item.code, item.hint) == (code, hint)


def test_a_type_before_the_name_behind_another_variable() -> None:
    [item] = found("system S srm R { var n : int = 0\n int rounds = 0\n liveness { R = A } }")
    assert (item.code, item.hint) == ("E102", "write var rounds : int")


def test_a_message_is_known_only_in_the_line_that_takes_it() -> None:
    text = """system S
message Q { int n }
aip ask {
  participant one { engage "Always."  sends request Q  receives inform Q  process = Ask . Wait }
  participant two { engage "Always."  sends inform Q  receives request Q  process = Get . (Answer | Refuse) }
  control one { enter Ask : / send request Q { n = 1 } to two }
  control two {
    enter Get : request Q q from one
    enter Answer : [q.n > 2]
    enter Refuse : else
  }
}
"""
    items = [item for item in found(text) if item.code == "E502"]
    assert [item.hint for item in items] == [
        "`q` is known only in the line that takes the message: keep what is needed in a variable"
    ]


@pytest.mark.parametrize(
    ("declared", "line", "expected"),
    [
        ("message Bidd { double cost }", "[bid.cost < 3]", ["E502"]),
        ("message Bidd { double cost }", "/ best = sender(bid)", ["E502"]),
        ('message Bid { double cost } import "gone.aseme"', "[cheap(bid)]", ["E004"]),
        ('message Bid { double cost } import "gone.aseme"', "[limit > bid.cost]", ["E004"]),
        ('message Bid { double cost } import "gone.aseme"', "/ best = first(best, sender(bid))", ["E004"]),
        (
            'message Bid { double cost } import "gone.aseme" topic t { state Bid }',
            "/ write_messages.t.state.Bid { cost = rounded(bid.cost) }",
            ["E004"],
        ),
        (
            'message Bid { double cost } import "gone.aseme" topic t { state Bid }',
            "/ write_messages.t.state.Bid { cost = 3 }",
            ["E004", "W551"],
        ),
    ],
)
def test_what_uses_the_message_that_is_taken_may_be_wrong_itself(
    declared: str, line: str, expected: list[str]
) -> None:
    text = f"""system S
{declared}
aip p {{
  participant a {{
    var best : agent
    engage "Always."
    sends cfp Bid
    receives propose Bid
    process = A . B
  }}
  participant b {{ engage "Always."  sends propose Bid  receives cfp Bid  process = X }}
  control a {{
    enter A : / send cfp Bid to b
    enter B : propose Bid bid from b {line}
  }}
  control b {{ enter X : cfp Bid from a / send propose Bid to a }}
}}
srm r {{ plays p.a  liveness {{ r = a }} }}
srm q {{ plays p.b  liveness {{ q = b }} }}
"""
    assert [code for code in codes(text) if code[0] != "N"] == expected


CROSSING = """system S
message Road {{ double wait  double cars }}
topic road {{ state Road }}
srm light {{
  var near : bool
  liveness {{ light = (Red | Green)~ }}
  control light {mode}{{ enter Red : {red}  enter Green : {green} }}
}}
"""


def test_an_event_in_a_condition_is_no_missing_function() -> None:
    text = CROSSING.format(mode="", red="when [ped && after(5s)]", green="else")
    undeclared, event = found(text)
    assert (undeclared.code, undeclared.span and undeclared.span.text) == ("E200", "ped")
    assert (event.code, event.span and event.span.text) == ("E502", "after(5s)")
    assert event.message == "`after(…)` is an event, not a part of a condition"


def test_a_random_condition_does_not_blame_the_operator_around_it() -> None:
    [item] = found(
        CROSSING.format(mode="", red="[near && random() < 0.7]", green="else") + "team T { l : light }"
    )
    assert item.code == "E526"
    assert item.message.startswith("a condition is looked at many times")


def test_branches_in_a_meant_order_may_overlap() -> None:
    pytest.importorskip("z3")
    branches = {"red": "[road.state.Road.cars > 3]", "green": "[road.state.Road.wait > 5]"}
    assert "W410" in codes(CROSSING.format(mode="", **branches))
    assert "W410" not in codes(CROSSING.format(mode="first ", **branches))
