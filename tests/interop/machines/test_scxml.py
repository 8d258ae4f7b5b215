"""State machines of SCXML become roles with a statechart, and play as their engines do."""

from __future__ import annotations

from pathlib import Path

import pytest

from aseme_dsl.interop.emf.report import Fate
from aseme_dsl.project.editing.import_models import import_models
from tests.interop.machines.playing import Player, imported

OVEN = """
<scxml xmlns="http://www.w3.org/2005/07/scxml" version="1.0" name="oven" initial="off">
  <datamodel><data id="seconds" expr="0"/></datamodel>
  <state id="off"><transition event="turn.on" target="on"/></state>
  <parallel id="on">
    <transition event="turn.off" target="off"/>
    <state id="engine">
      <state id="idle"><transition event="start" cond="In('closed')" target="cooking"/></state>
      <state id="cooking">
        <onentry><send event="tick" delay="1s"/></onentry>
        <transition event="tick" cond="seconds &lt; 2" target="cooking">
          <assign location="seconds" expr="seconds + 1"/>
        </transition>
        <transition event="tick" target="idle"/>
        <transition event="door.open" target="idle"/>
      </state>
    </state>
    <state id="door">
      <state id="closed"><transition event="door.open" target="open"/></state>
      <state id="open">
        <onexit><raise event="start"/></onexit>
        <transition event="door.close" target="closed"/>
      </state>
    </state>
  </parallel>
</scxml>
"""


def machine(states: str, data: str = "") -> str:
    return f'<scxml version="1.0" name="m"><datamodel>{data}</datamodel>{states}</scxml>'


def lines(text: str) -> list[str]:
    """The transitions of an imported machine."""
    return [line.strip() for line in imported("m.scxml", text).text.splitlines() if " :" in line]


def active(text: str, *events: str) -> list[set[str]]:
    player = Player(imported("m.scxml", text))
    for event in events:
        player.send(event)
    return player.active()


def test_a_machine_plays() -> None:
    found = imported("oven.scxml", OVEN)
    assert found.lost == ()
    player = Player(found)
    for event, expected in (
        ("turn.on", ["idle", "closed"]),
        ("start", ["cooking", "closed"]),
        ("door.open", ["idle", "open"]),
        ("door.close", ["cooking", "closed"]),  # the exit has raised `start`
    ):
        player.send(event)
        assert player.active()[-2:] == [{name} for name in expected]
    player.wait(3_000_000_000)
    assert player.active()[-2:] == [{"idle"}, {"closed"}]
    player.send("turn.off")
    assert player.active() == [{"off"}]


@pytest.mark.parametrize(
    ("states", "expected"),
    [
        (
            '<state id="a"><transition event="go" cond="n &gt; 1 || !n" target="b"/></state><state id="b"/>',
            "0.2 -> 0.3 : go [n > 1 || !(n != 0)]",
        ),
        (
            '<state id="a"><transition event="cancel error" target="b"/></state><state id="b"/>',
            "0.2 -> 0.3 : cancel_2",
        ),
        (
            '<state id="a"><transition cond="n == 1" target="b"/></state><state id="b"/>',
            "0.2 -> 0.3 : when [n == 1]",
        ),
        (
            '<state id="a"><transition event="e.*"><assign location="n" expr="n*2+1"/></transition></state>',
            "on 0.2 : e / n = n * 2 + 1",
        ),
        ('<state id="a"><transition event="e"/></state>', "on 0.2 : e"),
        (
            '<state id="a"><transition event="done.state.a" target="z"/><state id="b">'
            '<transition event="go" target="c"/></state><final id="c"/></state><final id="z"/>',
            "0.2 -> 0.3 :",
        ),
        (
            '<state id="a"><invoke src="fetch"/><transition event="done.invoke" target="z"/></state>'
            '<final id="z"/>',
            "0.2 -> 0.3 :",
        ),
        (
            '<state id="a"><transition event="go" target="b"/></state><state id="b"><onentry>'
            '<if cond="n &lt; 3"><assign location="n" expr="7"/><else/><assign location="n" expr="0"/></if>'
            "</onentry></state>",
            "0.2 -> 0.3 : go / n = n < 3 ? 7 : 0",
        ),
        (
            '<state id="a"><onexit><script>n++; n += 2</script></onexit></state>',
            "exit 0.2 : / n = n + 1; n = n + 2",
        ),
        (
            '<state id="a"><onexit><script>t = "a;b//c"; n = 2 // t = "d";\n/* n = 3; */ n++</script>'
            "</onexit></state>",
            'exit 0.2 : / t = "a;b//c"; n = 2; n = n + 1',
        ),
    ],
)
def test_what_becomes_what(states: str, expected: str) -> None:
    data = '<data id="n" expr="0"/><data id="t" expr="\'\'"/>'
    assert expected in lines(machine(states, data))


def test_entry_actions_are_done_on_each_way_in() -> None:
    text = machine(
        '<state id="a"><transition event="deep" target="d"/><transition event="flat" target="b"/></state>'
        '<state id="b" initial="c"><onentry><assign location="n" expr="n + 1"/></onentry>'
        '<state id="c"><onentry><assign location="n" expr="n + 10"/></onentry></state>'
        '<state id="d"><onentry><assign location="n" expr="n + 100"/></onentry></state>'
        '<transition event="back" target="a"/></state>',
        '<data id="n" expr="0"/>',
    )
    player = Player(imported("m.scxml", text))
    player.send("deep")
    assert (player.active(), player.chart.variable("n")) == ([{"d"}], 101)
    player.send("back")
    player.send("flat")
    assert (player.active(), player.chart.variable("n")) == ([{"c"}], 112)


def test_a_transition_without_content_hides_its_event_from_what_is_around() -> None:
    text = machine(
        '<state id="s"><transition event="e" target="z"/><state id="a"><transition event="e"/></state>'
        "</state>"
        '<state id="z"/>'
    )
    assert active(text, "e") == [{"a"}]


def test_several_targets_where_the_others_begin_anyway() -> None:
    text = machine(
        '<state id="a"><transition event="go" target="q2 r1"/></state><parallel id="p">'
        '<state id="q"><state id="q1"/><state id="q2"/></state>'
        '<state id="r"><state id="r1"/><state id="r2"/></state></parallel>'
    )
    assert active(text, "go")[-2:] == [{"q2"}, {"r1"}]


def test_an_internal_transition_does_not_leave_its_source() -> None:
    text = machine(
        '<state id="s"><onexit><assign location="n" expr="n + 1"/></onexit>'
        '<transition event="go" type="internal" target="b"/><state id="a"/><state id="b"/></state>',
        '<data id="n" expr="0"/>',
    )
    player = Player(imported("m.scxml", text))
    player.send("go")
    assert (player.active(), player.chart.variable("n")) == ([{"b"}], 0)


SEND = '<state id="a"><onentry><send event="x" target="#b"/></onentry></state>'
ERROR = '<state id="a"><transition event="error" target="a"/></state>'
PARALLEL = (
    '<parallel id="p"><state id="q"><state id="q1"><transition event="e" target="q2"/></state>'
    '<state id="q2"/></state><state id="r"><transition event="{}" target="z"/></state></parallel>'
    '<state id="z"/>'
)


@pytest.mark.parametrize(
    ("text", "fate", "words"),
    [
        (machine('<state id="a"><history id="h"/></state>'), Fate.LEFT_OUT, "history h"),
        (machine('<state id="a"><transition event="x" cond="f(1)"/></state>'), Fate.HOLE, "functions"),
        (machine(PARALLEL.format("e")), Fate.DIFFERS, "both are taken"),
        (
            machine(SEND),
            Fate.LEFT_OUT,
            "#b",
        ),
        (
            machine(ERROR),
            Fate.LEFT_OUT,
            "nothing raises",
        ),
        (machine('<state id="a"/>', '<data id="x" expr="[1]"/>'), Fate.LEFT_OUT, "its first value"),
        (machine('<state id="a"/>', '<thing id="x"/>'), Fate.LEFT_OUT, "<thing>"),
        (
            machine('<state id="a"><invoke id="i" namelist="n"/></state>'),
            Fate.LEFT_OUT,
            "`namelist` of <invoke>",
        ),
        (machine('<state id="a"><invoke id="i" src="f.scxml"/></state>'), Fate.CHANGED, "`src` of <invoke>"),
        (machine('<state id="a"><onentry delay="1s"/></state>'), Fate.LEFT_OUT, "`delay` of <onentry>"),
        (machine('<state id="a"><transition event="x" every="1s"/></state>'), Fate.LEFT_OUT, "`every` of"),
        (
            machine('<state id="a"><onexit><raise event="x" data="1"/></onexit></state>'),
            Fate.LEFT_OUT,
            "`data`",
        ),
    ],
)
def test_what_cannot_be_said_is_named_with_its_place(text: str, fate: Fate, words: str) -> None:
    rows = [row for row in imported("m.scxml", text).rows if row.fate is fate]
    assert any(words in f"{row.element} {row.now}" and row.place is not None for row in rows)


def test_nothing_is_said_where_no_earlier_region_waits_for_the_event() -> None:
    assert imported("m.scxml", machine(PARALLEL.format("f"))).lost == ()


@pytest.mark.parametrize(
    ("text", "reason"),
    [
        ("", "no element found"),
        ("<scxml/>", "it has no state"),
        ("<fsm/>", "not an SCXML document"),
        ('<!DOCTYPE x [<!ENTITY e "e">]><scxml><state id="&e;"/></scxml>', "document type"),
        ('<scxml><state id="a"/><state id="a"/></scxml>', "two states have the id `a`"),
        ('<scxml><state id="a"><transition target="b"/></state></scxml>', "there is no state `b`"),
        ("<scxml>" + "<state>" * 300, "more than 200 deep"),
        ("<scxml>" + "<state/>" * 3_001 + "</scxml>", "more than 3000 states"),
    ],
)
def test_a_file_that_is_no_machine_is_refused(tmp_path: Path, text: str, reason: str) -> None:
    place = tmp_path / "m.scxml"
    place.write_text(text, "utf-8")
    project = import_models([place])
    assert project.files == {}
    assert reason in project.diagnostics[0].message
    assert project.diagnostics[0].span is not None


def test_the_project_has_a_report(tmp_path: Path) -> None:
    place = tmp_path / "oven.scxml"
    place.write_text(OVEN, "utf-8")
    project = import_models([place])
    assert sorted(project.files) == ["import-report.md", "oven.aseme"]
    assert "oven.scxml:4:3" in project.files["import-report.md"].decode()


REGIONS = (
    '<parallel id="p"><state id="q"><state id="q1"/><state id="q2"/><state id="q3"/></state>'
    '<state id="r"><state id="r1"/><state id="r2"><transition event="again" target="r2 q3"/></state></state>'
    '<state id="s"><state id="s1"/></state></parallel>'
)


def test_several_targets_in_regions_of_one_parallel_state() -> None:
    text = machine(f'<state id="a"><transition event="go" target="r2 q2"/></state>{REGIONS}')
    assert active(text, "go")[-3:] == [{"q2"}, {"r2"}, {"s1"}]
    assert active(text, "go", "again")[-3:] == [{"q3"}, {"r2"}, {"s1"}]
    assert "0.2 -> (0.3.1.3, 0.3.2.3) : go" in imported("m.scxml", text).text


def test_a_target_that_is_named_is_not_reached_by_the_transition_of_initial() -> None:
    """What stands in <initial> is done where a region begins by itself, not where a target in it is named."""
    text = machine(
        '<state id="a"><transition event="go" target="c e"/></state><parallel id="p">'
        '<transition event="back" target="a"/><state id="r"><initial><transition target="c">'
        '<raise event="x"/></transition></initial><state id="c"><transition event="x" target="d"/></state>'
        '<state id="d"><transition event="again" target="c e"/></state></state>'
        '<state id="s"><state id="f"/><state id="e"/></state></parallel>'
    )
    assert imported("m.scxml", text).lost == ()
    assert active(text, "go")[-2:] == [{"c"}, {"e"}]
    assert active(text, "go", "x", "again")[-2:] == [{"c"}, {"e"}]


def test_a_machine_that_begins_in_several_regions() -> None:
    text = machine(REGIONS).replace("<scxml", '<scxml initial="q3 r2"', 1)
    assert active(text)[-3:] == [{"q3"}, {"r2"}, {"s1"}]


def test_what_is_done_on_the_way_to_several_targets() -> None:
    """Entries stand on the transition in document order; those of regions beside, at their STARTs."""
    text = machine(
        '<state id="a"><transition event="go" target="q2 r2"><assign location="n" expr="n + 1"/></transition>'
        '</state><parallel id="p"><onentry><assign location="n" expr="n * 2"/></onentry>'
        '<state id="q"><state id="q1"/><state id="q2"/></state>'
        '<state id="r"><onentry><assign location="n" expr="n + 3"/></onentry><state id="r1"/>'
        '<state id="r2"><onentry><assign location="n" expr="n * 10"/></onentry></state></state></parallel>',
        '<data id="n" expr="1"/>',
    )
    player = Player(imported("m.scxml", text))
    player.send("go")
    assert (player.active(), player.chart.variable("n")) == ([{"p"}, {"q2"}, {"r2"}], 70)


@pytest.mark.parametrize("targets", ["q3 q2", "q3 z"])
def test_targets_that_cannot_be_active_together(targets: str) -> None:
    text = machine(
        f'<state id="a"><transition event="go" target="{targets}"/></state>{REGIONS}<state id="z"/>'
    )
    assert any("cannot be active together" in row.now for row in imported("m.scxml", text).rows)


@pytest.mark.parametrize(
    ("source", "target", "expected", "line"),
    [
        ("q1", "r2", [{"q1"}, {"r2"}, {"s"}], "0.2.1.2 -> (0.2.1.2, 0.2.2.3) : go"),
        ("q1", "r", [{"q1"}, {"r1"}, {"s"}], "0.2.1.2 -> 0.2 : go"),
        ("q", "q2", [{"q2"}, {"r1"}, {"s"}], "0.2.1 -> (0.2.1.3, 0.2.2.2) : go"),
        ("s", "r2", [{"q1"}, {"r2"}, {"s"}], "0.2.3.2 -> (0.2.1.2, 0.2.2.3) : go"),
    ],
)
def test_from_one_region_into_another_all_are_left(
    source: str, target: str, expected: list[set[str]], line: str
) -> None:
    way = f'<transition event="go" target="{target}"/>'
    q, r, s = ('<state id="q">', '<state id="r">', '<state id="s">')
    text = (
        f'<parallel id="p">{q}<state id="q1"></state><state id="q2"/></state>'
        f'{r}<state id="r1"/><state id="r2"/></state>{s}</state></parallel>'
    ).replace(f'<state id="{source}">', f'<state id="{source}">{way}')
    assert line in lines(machine(text))
    assert active(machine(text), "go")[-3:] == expected
