"""Warnings about what looks like something else: timers that nobody starts, participants not played."""

from __future__ import annotations

from aseme_dsl.compiler import analyse
from aseme_dsl.diagnostics import Diagnostic
from aseme_dsl.source import Source


def warnings(text: str) -> list[Diagnostic]:
    return [item for item in analyse(Source("w.aseme", text)).diagnostics if item.code[0] == "W"]


def test_a_timer_that_is_never_started() -> None:
    [found] = warnings(
        "system S srm r { liveness { r = A . B } control r { enter A : / start_timer(pace, 1s)"
        "  enter B : [expired(pase)] } }"
    )
    assert (found.code, found.hint) == ("W501", "did you mean `pace`?")
    assert found.span is not None and found.span.text == "expired(pase)"


def test_a_timer_of_another_region() -> None:
    [found] = warnings(
        "system S srm r { liveness { r = (A . B) || (C . D) }"
        "  control r { enter B : / start_timer(pace, 1s)  enter D : [expired(pace)] } }"
    )
    assert found.code == "W501"
    assert found.hint is not None and "region" in found.hint


def test_a_timer_that_is_started_in_its_region_is_fine() -> None:
    text = """system S srm r { liveness { r = (A | B)+ }
      control r {
        enter (A | B) : / start_timer(pace, 1s)
        repeat (A | B) : [expired(pace)] / start_timer(pace, 1s)
        leave (A | B) : after(9s)
        enter A : [1 < 2]
        enter B : else
      } }"""
    assert warnings(text) == []


def test_a_participant_that_the_role_does_not_play() -> None:
    text = """system S
    aip deal {
      participant buyer  { engage "a" process = Ask }
      participant seller { engage "b" process = Sell }
      outcome "done"
    }
    srm r { PLAYS liveness { r = Wait . buyer } }"""
    [found] = warnings(text.replace("PLAYS", ""))
    assert (found.code, found.hint) == ("W202", "write `plays deal.buyer` in srm r")
    assert warnings(text.replace("PLAYS", "plays deal.buyer")) == []
    other = text.replace("aip deal", "aip swap { participant buyer { process = Offer } }\n    aip deal")
    [found] = warnings(other.replace("PLAYS", ""))
    assert (found.code, found.hint) == ("W202", "write `plays swap.buyer` or `plays deal.buyer` in srm r")
    assert [item.message for item in found.related] == ["the participant of swap", "the participant of deal"]


def test_states_and_transitions_of_a_statechart_may_be_mixed() -> None:
    text = """system S statechart r {
      state 0 OR
      state 0.1 START
      0.1 -> 0.2 :
      state 0.2 BASIC A
      0.2 -> 0.3 : after(3s) / read_messages
      state 0.3 END
    }"""
    analysis = analyse(Source("w.aseme", text))
    assert analysis.diagnostics == ()
    assert analysis.system is not None
    assert len(analysis.system.iacs[0].transitions) == 2


def test_else_is_right_beside_a_timer_that_has_not_run_out() -> None:
    text = """system S srm r { liveness { r = A . (B | C) } control r {
      enter A : / start_timer(t, 1s)
      enter B : [NOT expired(t)]
      enter C : else
    } }"""
    assert warnings(text.replace("NOT", "!")) == []
    assert [item.code for item in warnings(text.replace("NOT", ""))] == ["W401"]


def test_a_condition_without_brackets_is_no_event() -> None:
    text = """system S let near = 1 < 2 srm r { var tired : bool = false
      liveness { r = A . (B | C | D) }
      control r { enter B : near  enter C : tired  enter D : bumped } }"""
    found = analyse(Source("w.aseme", text)).diagnostics
    assert [(item.code, item.span.text) for item in found if item.span] == [
        ("E517", "near"),
        ("E517", "tired"),
        ("W405", "enter D : bumped"),
    ]
    assert found[0].hint == "write `[near]`; a name without brackets is an event that an activity raises"
