"""Agent messages in expressions: what is wrong with them, and what the compiler says."""

from __future__ import annotations

import jsonschema
import pytest

from aseme_dsl.amola.as_json import models_json, schema
from tests.support.compiling import codes, printed, system

PROTOCOL = """system S
message Note { string text  int n }
message Bid { double cost  optional int extra  Note note  repeated int many }
topic t { state Note }
enum Colour { RED }
aip p {
  participant a {
    var best : agent
    var x : int = 0
    sends cfp Note, accept_proposal Note
    receives propose Bid, refuse Note
    process = A . B . C
  }
  participant b {
    sends propose Bid, refuse Note
    receives cfp Note, accept_proposal Note
    process = X
  }
  control a {
    LINE
  }
  control b { enter X : / send propose Bid to a }
}
srm r { plays p.a  liveness { r = a }  activities { A takes 1s  B takes 1s  C takes 1s } }
srm q { plays p.b  liveness { q = b }  activities { X takes 1s } }
"""


LISTS = (
    "    sends cfp Note, accept_proposal Note\n    receives propose Bid, refuse Note\n",
    "    sends propose Bid, refuse Note\n    receives cfp Note, accept_proposal Note\n",
)
LINES = """
    enter A : / send cfp Note { .. } to b; send accept_proposal Note { .. } to b
    enter B : propose Bid from b or refuse Note from b
  }
  control b {
    enter X : cfp Note from a / send propose Bid { .. } to a
    enter X : accept_proposal Note from a
"""
WITH_LINES = PROTOCOL.replace("    LINE\n", LINES).replace(
    "control b { enter X : / send propose Bid to a }", ""
)


def test_lines_say_what_a_participant_exchanges_that_lists_nothing() -> None:
    """The models are those of the lists; `refuse` may come from a role that is busy, or from an activity."""
    written = WITH_LINES.replace("plays p.b", "plays p.b when busy refuse")
    bare = written
    for lists in LISTS:
        assert lists in bare
        bare = bare.replace(lists, "\n\n")
    assert codes(written) == codes(bare)
    assert models_json(system(written))["aip.p.json"] == models_json(system(bare))["aip.p.json"]
    half = written.replace(LISTS[0], "\n\n")
    assert models_json(system(written))["aip.p.json"] == models_json(system(half))["aip.p.json"]


@pytest.mark.parametrize(
    ("change", "code", "said"),
    [
        (("cfp Note from a", "inform Note from a"), "E511", "no line of `b` takes `cfp Note`"),
        (
            ("to b; send accept", "to best; send inform Note { .. } to best; send accept"),
            "E532",
            "Note from …`",
        ),
    ],
)
def test_a_message_that_no_line_takes(change: tuple[str, str], code: str, said: str) -> None:
    text = WITH_LINES.replace(*change)
    for lists in LISTS:
        text = text.replace(lists, "")
    found = printed(text)
    assert f"error[{code}]" in found and said in found, found


@pytest.mark.parametrize(
    ("line", "code", "said"),
    [
        ('enter A : / send cfp Note { text: "a" } to b', "E102", "a member is filled with '='"),
        ('enter A : / send cfp Note { n = 1, text: "a" } to b', "E102", "a member is filled with '='"),
        ("enter A : / send cfp Note { n = 1 to b", "E102", "expected '}' after '1'"),
        ("enter A : / send cfp Note { n = 1 }", "E102", "'to' and a participant"),
        ("enter A : / send cfp Note { n = 1  text = \"a\" } to b", "E102", "',' or '}'"),
        ("enter A : / send cfp { n = 1 } to b", "E102", "expected a message after 'cfp'"),
        ("enter A : / write_messages.t.state.Note { n = 1", "E111", "write '}'"),
        ("enter A : / send cfp Note { m = 1, .. } to b", "E501", "has no member `m`"),
        ('enter A : / send cfp Note { n = "a", .. } to b', "E500", "an int is wanted"),
        ("enter A : / send cfp Note { n = 1.5, .. } to b", "E506", "does not fit"),
        ("enter A : / send cfp Note { n = 1, n = 2, .. } to b", "E225", "filled twice"),
        ("enter A : / write_messages.t.state.Note { x = 1 }", "E501", "has no member `x`"),
        ("enter A : / send cfp Note to b, best", "E102", "found ','"),
        ("enter A : / send cfp Note to b except x", "E531", "an agent is wanted here, not an int"),
        ("enter A : / send cfp Note to best except best", "E531", "has no exceptions"),
        ("enter A : / send cfp Note to bst", "E205", "no participant `bst`"),
        ("enter A : / send cfp Note to x", "E531", "an agent is wanted here, not an int"),
        ("enter A : / send propose Bid to best", "E511", "`a` does not list `sends propose Bid`"),
        ("enter B : propose Bid m from b [m.cst < 1]", "E501", "did you mean `cost`?"),
        ("enter B : propose Bid from b as m [m.cost < 1]", "E102", "write propose Bid m from b"),
        ("enter B : propose Bid m from b [b.cost < 1]", "E502", "the message that is taken is `m`"),
        ("enter B : propose Bid from b [Bid.cost < 1]", "E502", "the message that is taken is `propose.Bid`"),
        ("enter B : propose Bid m from b / best = m", "E500", "an agent is wanted here"),
        ("enter B : propose Bid m from b / send cfp Note to m", "E531", "write `sender(m)`"),
        ("enter B : propose Bid m from b / x = sender(m)", "E500", "an int is wanted here, not an agent"),
        ("enter B : propose Bid m from b / best = sender(best)", "E504", "wants the agent message"),
        ("enter B : propose Bid m from b [m] / best = sender(m)", "E505", "not a Bid"),
        ("enter B : propose Bid best from b [best.cost < 1]", "E226", "a variable has this name"),
        ("enter B : propose Bid m from b or after(1s) [m.cost < 1]", "E530", "a line of its own"),
        ("enter B : propose Bid m from b or refuse Note m from b [m.n < 1]", "E530", "same type"),
        ("enter B : propose Bid m from b or when [m.cost < 1]", "E530", "`when`"),
        ("enter B : propose Bid m from b", "W551", "nothing uses `m`"),
        ("enter B : [propose.Bid.cost < 3]", "E533", "no `propose Bid` is taken here"),
        ("enter B : [propose.Bid.cost < 3]", "E533", "keep what is needed in a variable there"),
        ("enter B : propse Bid from b [propose.Bid.cost < 3]", "E512", "did you mean `propose`?"),
        ("enter B : propose Bud from b [propose.Bid.cost < 3]", "E511", "did you mean `Bid`?"),
        ("enter B : propose Bid m from b [propose.Bid.cost < 3]", "E533", "write `m.cost`"),
        ("enter B : lost c who / best = who", "E205", "no participant `c`"),
        ("enter B : lost b who / best = sender(who)", "E504", "`who` is the agent itself"),
        ("enter B : lost from b", "E102", "expected a participant"),
        ("enter B : [best > best]", "E509", "does not order"),
        ('enter B : [best == "robot1"]', "E509", "cannot be compared"),
        ("enter B : [best]", "E505", "must be a bool, not an agent"),
    ],
)  # fmt: skip
def test_mistakes(line: str, code: str, said: str) -> None:
    text = PROTOCOL.replace("LINE", line)
    found = [item for item in codes(text) if item[0] == "E" or item == code]
    assert found == [code], printed(text)
    assert said in printed(text)


def test_what_is_written_is_shown() -> None:
    line = (
        "enter B : propose Bid m from b [m.cost<1]/best=sender( m );"
        'send cfp Note{n=x,text="a"}to sender(m);send cfp Note { .. } to b except best,sender(m)'
    )
    chart = system(PROTOCOL.replace("LINE", line)).eacs[0]
    (shown,) = [text for item in chart.transitions if "propose Bid m" in (text := _text(item))]
    assert shown == (
        "propose Bid m from b [m.cost < 1] / best = sender(m); "
        'send cfp Note { n = x, text = "a" } to sender(m); send cfp Note { .. } to b except best, sender(m)'
    )


def _text(transition: object) -> str:
    from aseme_dsl.amola.expression import expression_text

    return expression_text(transition.expression)  # type: ignore[attr-defined]


@pytest.mark.parametrize(
    ("asked", "said"),
    [
        ("has(m.extra)", None),
        ("has(m.cost)", "`cost` is there in any case"),
        ("has(m)", "the message that is taken is there in any case"),
        ("has(t.state.Note.n)", "wants the whole message: `t.state.Note`"),
        ("has(x)", "wants a message, not an int"),
    ],
)
def test_what_may_be_absent_can_be_asked_for(asked: str, said: str | None) -> None:
    text = PROTOCOL.replace("LINE", f"enter B : propose Bid m from b [{asked} && m.cost > 0]")
    assert [code for code in codes(text) if code[0] == "E"] == ([] if said is None else ["E504"])
    assert said is None or said in printed(text)


def test_nobody_is_known_at_first() -> None:
    """A variable of type agent has no initial value in the models, nor in the table of the protocol."""
    found = system(PROTOCOL.replace("LINE", "enter B : propose Bid m from b / best = sender(m)"))
    model = models_json(found)["aip.p.json"]
    best, x = model["participants"][0]["variables"]
    assert (best["type"], best["initial"], x["initial"]) == ("agent", None, 0)
    for kind in ("aip", "statechart"):
        name = "aip.p.json" if kind == "aip" else "iac.r.json"
        validator = jsonschema.Draft202012Validator(schema(kind))
        assert list(validator.iter_errors(models_json(found)[name])) == []
    assert found.aips[0].participants[0].variables[0].text == "best : agent"


ANSWERED = """system S
message Note {{ string text }}
message Other {{ string text }}
aip p {{
  participant a {{ sends cfp Note  receives not_understood {message}  process = A . [B] }}
  participant b {{ receives cfp Note  process = X }}
  control a {{
    enter [B] : / send cfp Note to b
    enter B   : not_understood {message} from b
    skip  B   : after(1s)
  }}
  control b {{ enter X : cfp Note from a }}
}}
srm r {{ plays p.a  liveness {{ r = a }}  activities {{ A takes 1s  B takes 1s }} }}
srm q {{ plays p.b  liveness {{ q = b }}  activities {{ X takes 1s }} }}
"""


def test_the_runtime_answers_what_is_not_understood() -> None:
    """Of what a participant sends, and of nothing else: nobody has to list that it sends such an answer."""
    assert codes(ANSWERED.format(message="Note")) == []
    assert codes(ANSWERED.format(message="Other")) == ["E511"]
