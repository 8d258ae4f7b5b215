"""Agent messages in expressions: filled, bound, sent to one agent, and agents that are gone."""

from __future__ import annotations

from aseme_dsl.runtime.chart.inputs import Fault, Sending
from tests.behaviour.conftest import Play
from tests.behaviour.running import Run

PROTOCOL = """
aip p {
  participant a {
    engage   "Always."
    var best : agent
    var low  : int = 100
    sends    cfp M, accept_proposal M, reject_proposal M
    receives propose M, refuse Note, inform M
    process  = A . B . C
  }
  participant b {
    engage   "Always."
    sends    propose M, refuse Note, inform M
    receives cfp M, accept_proposal M, reject_proposal M
    process  = X
  }
  control a { LINES }
}
srm R { plays p.a  liveness { R = a . Z } }
"""


def run_of(play: Play, *lines: str) -> Run:
    return play(PROTOCOL.replace("LINES", "\n".join(lines)))


def test_a_message_is_filled_where_it_is_sent(play: Play) -> None:
    """ "`send P M { f = v, g.h = v } to X`" """
    run = run_of(play, 'enter A : / send cfp M { x = low + 1, s = "go", d = 2.5, on = true, .. } to b').step()
    assert run.did[1] == "send cfp M {x=101 on=True d=2.5 s=go} to b"
    (sending,) = run.last.of(Sending)
    assert sending.filled


def test_a_message_without_braces_is_what_the_activity_has_prepared(play: Play) -> None:
    run = run_of(play, "enter A : / send cfp M to b").step()
    assert run.did[1] == "send cfp M to b"
    run = run_of(play, "enter A : / send cfp M { .. } to b").step()
    assert run.did[1] == "send cfp M {} to b"


def test_a_message_is_not_sent_if_something_of_it_is_absent(play: Play) -> None:
    """ "Missing content or an absent value fails the state that is entered" """
    run = run_of(
        play, "enter A : / send cfp M { x = t.state.M.x, .. } to b; low = 1", "enter B : error"
    ).step()
    assert [line.split()[0] for line in run.did] == ["join", "fault", "start"]
    (fault,) = run.last.of(Fault)
    assert fault.reason == "cfp M is not sent: a value is absent"
    assert run.active == ["B"] and run.variable("low") == 1


def test_a_message_is_not_sent_if_something_of_it_raises(play: Play) -> None:
    run = run_of(play, "enter A : / send cfp M { d = 1 / (low - 100), .. } to b", "enter B : error").step()
    assert [line.split()[0] for line in run.did] == ["join", "fault", "start"]
    (fault,) = run.last.of(Fault)
    assert fault.reason.startswith("cfp M is not sent: ") and run.active == ["B"]


def test_without_a_way_for_the_failure_the_agent_stops(play: Play) -> None:
    run = run_of(play, "enter A : / send cfp M { x = t.state.M.x, .. } to b").step()
    assert "cfp M is not sent: a value is absent (" in (run.last.failure or "")


def test_a_message_on_a_topic_is_filled_and_published(play: Play) -> None:
    """ "`write_messages.t.c.M { f = v }` (= fill, then publish)" """
    run = play(
        "srm R { var n : int = 4  liveness { R = A . B } "
        "control R { enter B : / write_messages.t.state.M { x = n, on = n > 3 } } }"
    ).step()
    run.step(run.done("A"))
    assert run.did == ["publish t.state.M {x=4 on=True}", "start B"]


def test_what_is_taken_is_known_by_its_name(play: Play) -> None:
    run = run_of(play, "enter B : propose M m from b / low = m.x; best = sender(m)").step()
    assert run.variable("best") is None
    run.step(run.mail("propose", "M", "bob", x=7))
    assert (run.variable("low"), run.variable("best")) == (7, "bob")


def test_without_a_name_it_is_known_by_its_kind(play: Play) -> None:
    """ "Without a name, `propose.Bid.cost` in the condition and actions means the same" """
    run = run_of(
        play, "enter B : propose M from b [propose.M.x < 5] / low = propose.M.x; best = sender(propose.M)"
    ).step()
    run.step(run.mail("propose", "M", "bob", x=7))
    assert run.active == ["A"]
    run.step(run.mail("propose", "M", "eve", x=4))
    assert (run.active, run.variable("low"), run.variable("best")) == (["B"], 4, "eve")


def test_the_oldest_for_which_the_condition_holds_is_taken(play: Play) -> None:
    """ "the oldest waiting message of that kind *for which the condition holds* is taken" """
    run = run_of(play, "enter B : propose M m from b [m.x < 10] / best = sender(m)").step()
    run.step(run.mail("propose", "M", "ann", x=20))
    run.step(run.mail("propose", "M", "bob", x=3), run.mail("propose", "M", "eve", x=2))
    assert run.did == ["take mail of bob", "cancel A", "start B"]


def test_of_several_events_the_first_that_fits_is_taken(play: Play) -> None:
    """ "With `or`, all events must bind the same name with the same message type." """
    line = "enter B : inform M m from b or propose M m from b [m.x > 1] / low = m.x"
    run = run_of(play, line).step()
    run.step(run.mail("propose", "M", "ann", x=5), run.mail("inform", "M", "bob", x=0))
    assert run.did == ["take mail of ann", "cancel A", "start B"]
    run = run_of(play, line).step()
    run.step(run.mail("propose", "M", "ann", x=5), run.mail("inform", "M", "bob", x=6))
    assert run.did == ["take mail of bob", "cancel A", "start B"]


def test_what_does_not_fit_waits(play: Play) -> None:
    run = run_of(
        play,
        "enter B : propose M m from b [m.x > low] / best = sender(m)",
        "enter C : propose M m from b / low = m.x",
    ).step()
    run.step(run.mail("propose", "M", "ann", x=5))
    run.step(run.mail("propose", "M", "bob", x=500))
    assert run.active == ["C"] and run.variable("low") == 5
    assert [line for line in run.did if "take" in line] == ["take mail of bob", "take mail of ann"]


def test_a_condition_that_raises_for_one_is_asked_of_the_next(play: Play) -> None:
    run = run_of(play, "enter B : propose M m from b [10 / m.x > 1] / best = sender(m)").step()
    run.step(run.mail("propose", "M", "ann", x=0), run.mail("propose", "M", "bob", x=2))
    assert run.active == ["B"] and run.variable("best") == "bob"
    assert [line for line in run.did if "fault" in line] == [run.did[0]]


def test_a_whole_message_goes_to_a_function(play: Play) -> None:
    run = run_of(play, "enter B : propose M m from b [far(m)] / best = sender(m)").step()
    run.step(run.mail("propose", "M", "ann", x=0), run.mail("propose", "M", "bob", x=100))
    assert run.variable("best") == "bob"


def test_one_agent_is_addressed(play: Play) -> None:
    """ "`to X`: … a value of type agent (a variable, `sender(b)`)" """
    run = run_of(
        play,
        "enter B : propose M m from b / best = sender(m); send reject_proposal M { x = 1, .. } to sender(m)",
        "enter C : / send accept_proposal M to best; send reject_proposal M { .. } to b except best",
    ).step()
    run.step(run.mail("propose", "M", "bob"))
    assert run.did[2] == "send reject_proposal M {x=1} to bob"
    run.step(run.done("B"))
    assert run.did[:2] == ["send accept_proposal M to bob", "send reject_proposal M {} to b except bob"]


def test_nobody_is_addressed_before_an_agent_is_known(play: Play) -> None:
    """ "`var best : agent` has no initial value and is absent until set" """
    run = run_of(
        play,
        "enter B : [has(best)]",
        "enter B : [!has(best)] / send accept_proposal M to best; low = 3",
        "enter C : [best == best] / low = 4",
        "enter C : after(1s)",
    ).step()
    run.step(run.done("A"))
    assert "accept_proposal M is not sent: a value is absent (" in (run.last.failure or "")
    assert run.variable("low") == 3


def test_agents_are_compared(play: Play) -> None:
    run = run_of(
        play,
        "enter B : propose M m from b / best = sender(m)",
        "enter C : propose M m from b [sender(m) == best] / low = m.x",
    ).step()
    run.step(run.mail("propose", "M", "bob", x=1), run.mail("propose", "M", "ann", x=2))
    assert run.active == ["B"]
    run.step(run.mail("propose", "M", "bob", x=3))
    assert run.variable("low") == 3


def test_an_agent_is_told_as_a_text(play: Play) -> None:
    run = run_of(
        play, "enter B : propose M m from b / send reject_proposal M { s = sender(m), .. } to b"
    ).step()
    run.step(run.mail("propose", "M", "bob"))
    assert run.did[2] == "send reject_proposal M {s=bob} to b"


def test_an_agent_is_forgotten_with_its_participant(play: Play) -> None:
    """ "A participant's variables start anew each time its branch is entered." """
    text = PROTOCOL.replace("LINES", "enter B : propose M m from b / best = sender(m)")
    run = play(text.replace("a . Z", "a~").replace("A . B . C", "A . B")).step()
    run.step(run.mail("propose", "M", "bob"))
    assert run.variable("best") == "bob"
    run.step(run.done("B"))
    assert run.active == ["A"] and run.variable("best") is None


def test_an_agent_that_is_gone_is_told_once(play: Play) -> None:
    """ "one event an agent, waits like mail until taken" """
    run = run_of(play, "enter B : lost b who / best = who", "enter C : lost b").step()
    run.step(run.lost("eve"))
    assert run.active == ["B"] and run.variable("best") == "eve"
    assert run.did[0] == "take mail of eve"
    run.step()
    assert run.active == ["B"]
    run.step(run.lost("bob"))
    assert run.active == ["C"]


def test_one_of_several_agents_is_waited_for(play: Play) -> None:
    run = run_of(
        play,
        "enter B : propose M m from b / best = sender(m)",
        "enter C : lost b who [who == best] / low = 0",
    ).step()
    run.step(run.mail("propose", "M", "bob"), run.lost("eve"))
    assert run.active == ["B"]
    run.step(run.lost("bob"))
    assert run.active == ["C"] and run.variable("low") == 0


OPTIONAL = """
message Place { int x  optional int height  optional Note note }
topic map { state Place }
"""


def test_an_optional_member_is_there_or_not(play: Play) -> None:
    """ "optional fields: unset is absent, `has(x.field)` works for members" """
    text = OPTIONAL + (
        "srm R { var n : int = 0  liveness { R = A . (B | C | D) } control R { "
        "enter B : [has(map.state.Place.height) && map.state.Place.height > 2] "
        "enter C : [!has(map.state.Place.height) && has(map.state.Place)] "
        "enter D : [map.state.Place.height <= 2] } }"
    )
    for members, there in (({}, "C"), ({"height": 3}, "B"), ({"height": 0}, "D")):
        run = play(text).step()
        run.step(run.done("A"))
        assert run.active == ["0.3.1"], "no message is there, and then no member is"
        run.step(run.heard("map.state.Place", **members))
        assert run.active == [there]


def test_a_member_of_an_optional_member_is_there_with_it(play: Play) -> None:
    text = OPTIONAL + (
        "srm R { liveness { R = A . (B | C) } control R { "
        "enter B : [has(map.state.Place.note)] enter C : [!has(map.state.Place.note)] } }"
    )
    run = play(text).step()
    run.step(run.done("A"))
    assert run.active == ["C"]
    run = play(text).step(run.heard("map.state.Place", note=run.generated.message("Note")))
    run.step(run.done("A"))
    assert run.active == ["B"]


def test_what_a_message_reads_is_looked_up_before_anything_is_computed(play: Play) -> None:
    """ "An action … that is not done because something is absent draws nothing." """
    run = run_of(play, "enter A : / send cfp M { d = random(), on = even(low), .. } to best").step()
    assert [line.split()[0] for line in run.did] == ["join", "fault", "part"]
