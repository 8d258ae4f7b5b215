"""Properties and clauses in real time: in one process, in one agent's process, and in a process for each."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from aseme_dsl.runtime.trace.trace_reading import TraceReader
from tests.cli.support import GOOD, Here, asemec
from tests.runtime.playing import check_line
from tests.support.network import own_name

BEATS = """\
system NAME
message Pulse { int number }
topic air { signal Pulse queued }
srm drummer {
  var n : int = 0
  liveness { drummer = Beat~ }
  activities { Beat takes 20ms }
  control drummer {
    repeat Beat : / n = n + 1 ; air.signal.Pulse.number = n ; write_messages.air.signal.Pulse
  }
}
srm listener {
  liveness { listener = Hear~ }
  activities { Hear takes 1ms }
  control listener { repeat Hear : [has(air.signal.Pulse)] }
}
team Band { ann : drummer  bob : listener }
property "it ends" { never ann has [n > 3] }
property "it is heard" { every sent air.signal.Pulse leads to received air.signal.Pulse by bob within 10min }
property "both play" { always bob in listener  never fault }
"""
"""One counts and publishes for ever; the other hears it."""


def breaches(path: Path) -> list[Any]:
    """What the trace says is broken."""
    records = [line.record for line in TraceReader(path)]
    for record in records:
        check_line(record)
    return [record for record in records if record["kind"] == "breach"]


@pytest.fixture
def band(tmp_path: Path) -> Path:
    path = tmp_path / "band.aseme"
    path.write_text(BEATS.replace("NAME", own_name("Band")))
    return path


def verdicts(done: Any) -> list[tuple[str, str]]:
    return [(item["of"], item["verdict"]) for item in done.json["result"]["watched"]]


ALL = [
    ('property "it ends"', "broken"),
    ('property "it is heard"', "kept"),
    ('property "both play"', "kept"),
    ('property "both play"', "kept"),
]


def test_a_breach_ends_a_strict_run_in_real_time(band: Path) -> None:
    done = asemec(
        "run",
        "band.aseme",
        "-o",
        "out",
        "--real",
        "--strict",
        "--for",
        "60s",
        "--json",
        "-q",
        cwd=band.parent,
    )
    assert (done.code, done.json["result"]["reason"]) == (1, "a property or clause is broken"), done.out
    assert [item for item in verdicts(done) if item[0] != ALL[1][0]] == [ALL[0], *ALL[2:]]
    (found,) = breaches(band.parent / "out" / "trace.jsonl.gz")
    assert (found["of"], found["at"]) == ('property "it ends"', "band.aseme:18:22")
    assert found["broken"] <= found["time"]


def test_the_line_is_the_same_in_virtual_time(
    band: Path, here: Here, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(band.parent)
    done = here("run", "band.aseme", "-o", "out", "--strict", "--json", "-q")
    assert (done.code, done.json["result"]["reason"]) == (1, "a property or clause is broken")
    (found,) = breaches(band.parent / "out" / "trace.jsonl.gz")
    assert (found["of"], found["at"], found["broken"]) == (
        'property "it ends"',
        "band.aseme:18:22",
        80_000_000,
    )
    # An output directory has the texts of its model.
    again = here("run", "out", "--strict", "--json", "-q")
    assert (again.code, verdicts(again)) == (1, verdicts(done))


def test_the_process_of_one_agent_watches_what_that_decides(band: Path) -> None:
    pytest.importorskip("zenoh")
    done = asemec("node", "ann", "band.aseme", "-o", "out", "--for", "60s", "--strict", cwd=band.parent)
    assert done.code == 1, done.out + done.err
    told = [line.strip() for line in done.out.splitlines() if "band.aseme:" in line or "other agents" in line]
    broken = [line for line in told if line.startswith("broken at")]
    assert told[:4] == [
        'watched for ann only: property "both play" (band.aseme:20:48)',
        'not decided here: property "it is heard" (band.aseme:19:26)',
        'not decided here: property "both play" (band.aseme:20:24)',
        "other agents decide it: `asemec run --process-per-agent` watches the whole team",
    ]
    assert len(broken) == 2 and all('property "it ends" (band.aseme:18:22)' in line for line in broken)
    (found,) = breaches(band.parent / "out" / "trace.ann.jsonl.gz")
    assert found["of"] == 'property "it ends"'
    other = asemec("node", "bob", "--from", "out", "--for", "200ms", "--strict", cwd=band.parent)
    assert (other.code, 'not decided here: property "it ends"' in other.out) == (0, True), other.out


def test_the_supervisor_watches_what_all_processes_do(band: Path) -> None:
    pytest.importorskip("zenoh")
    options = ("--process-per-agent", "--strict", "--for", "60s", "--json", "-q")
    done = asemec("run", "band.aseme", "-o", "out", *options, cwd=band.parent)
    assert (done.code, done.json["result"]["reason"]) == (1, "a property or clause is broken"), done.err
    assert [item for item in verdicts(done) if item[0] != ALL[1][0]] == [ALL[0], *ALL[2:]]
    assert dict(verdicts(done))[ALL[1][0]] in ("kept", "open")
    (found,) = breaches(band.parent / "out" / "trace.ann.jsonl.gz")
    assert (found["of"], found["at"]) == ('property "it ends"', "band.aseme:18:22")


def test_a_run_without_properties_is_as_before(folder: Path, here: Here) -> None:
    (folder / "good.aseme").write_text(GOOD)
    done = here("run", "good.aseme", "-o", "out", "--for", "10ms", "--real", "--json", "-q")
    assert done.json["result"]["watched"] == []


def test_what_a_step_sets_was_not_so_before_it(here: Here, folder: Path) -> None:
    (folder / "clock.aseme").write_text(
        "system Clock\nsrm clock {\n  var n : int = 0\n  liveness { clock = Tick~ }\n"
        "  activities { Tick waits }\n  control clock { repeat Tick : after(20ms) / n = n + 1 }\n}\n"
        'team T { one : clock }\nproperty "few" { never one has [n > 3] }\n'
    )
    done = here("run", "clock.aseme", "-o", "out", "--for", "600ms", "--json", "-q")
    (found,) = breaches(folder / "out" / "trace.jsonl.gz")
    assert (done.code, found["broken"]) == (1, 80_000_000)


GONE = """\
system Gone
function gone(double x) : double = "math:not_there"
srm robot {
  var n : double = 0
  liveness { robot = Walk~ }
  activities { Walk takes 20ms simulated }
  control robot { repeat Walk : / n = n + 1 }
}
team T { one : robot }
property "p" { never one has [gone(n) > 3] }
"""


@pytest.mark.parametrize("how", [(), ("--real",)])
def test_a_function_that_is_not_there_ends_the_watching_only(
    how: tuple[str, ...], here: Here, folder: Path
) -> None:
    (folder / "gone.aseme").write_text(GONE)
    done = here("run", "gone.aseme", "-o", "out", "--for", "600ms", *how)
    assert (done.code, 'open: property "p"' in done.out) == (0, True), done.out + done.err
    assert "are not watched from" in done.out and "no function not_there in module math" in done.out


MANY = """\
system NAME
message Pulse { int number }
topic air { signal Pulse queued }
aip calls {
  participant caller { process = Ring . Talk }
  participant callee { process = Wait . Answer }
  clause Answer@callee before Ring@caller
  clause Wait@callee before Talk@caller
  clause Answer@callee before Talk@caller
}
srm first {
  plays calls.caller
  liveness { first = caller }
  activities { Ring takes 100ms  Talk takes 300ms }
}
srm second {
  plays calls.callee
  liveness { second = callee }
  activities { Wait takes 300ms  Answer takes 100ms }
}
srm drummer {
  var n : int = 0
  liveness { drummer = Beat~ }
  activities { Beat takes 20ms }
  control drummer { repeat Beat : / n = n + 1 ; write_messages.air.signal.Pulse { number = n } }
}
srm listener {
  liveness { listener = Hear . Rest }
  activities { Hear takes 1ms  Rest takes 100ms }
  control listener { enter Rest : [air.signal.Pulse.number == 6] }
}
team Band { ann : drummer  bob : listener  cid : first  dan : second }
property "early" { never ann has [n > 3] }
property "late" { never bob in Rest }
property "in time" { every bob in Rest leads to ann has [n == 1000] within 95ms }
property "kept" { every bob in Hear leads to bob in Rest within 1s  always some listener in listener }
"""
"""`early` and a clause are broken before all else; each of the others shows in states that come later."""

MANY_FOUND = [
    ('property "early"', "broken", 80),
    ('property "late"', "broken", 120),
    ('property "in time"', "broken", 215),
    ('property "kept"', "kept", 0),
    ('property "kept"', "kept", 0),
    ("clause of calls", "broken", 0),
    ("clause of calls", "kept", 0),
    ("clause of calls", "broken", 100),
]


def found(watched: Any) -> list[tuple[str, str, int]]:
    return [(item["of"], item["verdict"], round(item["time_ns"] / 1e6)) for item in watched]


@pytest.fixture
def many(folder: Path) -> Path:
    path = folder / "many.aseme"
    path.write_text(MANY.replace("NAME", own_name("Many")))
    return path


def test_what_comes_after_a_breach_is_watched_too(many: Path, here: Here) -> None:
    done = here("run", "many.aseme", "-o", "out", "--for", "600ms", "--json", "-q")
    assert (done.code, found(done.json["result"]["watched"])) == (1, MANY_FOUND)
    order = [round(item["broken"] / 1e6) for item in breaches(many.parent / "out" / "trace.jsonl.gz")]
    assert order == [0, 80, 100, 120, 215]
    again = here("replay", "out", "--json")
    (trace,) = again.json["traces"]
    assert (again.code, found(trace["watched"])) == (1, MANY_FOUND)


def test_a_strict_run_ends_with_the_first_breach(many: Path, here: Here) -> None:
    text = many.read_text().replace("  clause Answer@callee before Ring@caller\n", "")
    many.write_text(text.replace("n > 3", "n > 300"))
    done = here("run", "many.aseme", "-o", "out", "--for", "600ms", "--json", "-q", "--strict")
    result = done.json["result"]
    assert (done.code, result["time"], [item[1] for item in found(result["watched"])].count("broken")) == (
        1,
        100_000_000,
        1,
    )
    many.write_text(text.replace("n > 3", "n > 300").replace("clause Answer@callee before Talk@caller", ""))
    many.write_text(
        many.read_text().replace("never bob in Rest", "never bob in Hear and cid in Talk and fault")
    )
    done = here("run", "many.aseme", "-o", "out", "--for", "600ms", "--json", "-q", "--strict")
    assert done.json["result"]["time"] == 215_000_001  # nothing else happens then


def test_breaches_in_real_time_are_those_of_the_whole_run(many: Path, here: Here) -> None:
    done = here("run", "many.aseme", "-o", "out", "--for", "1s", "--real", "--json", "-q")
    assert [item[:2] for item in found(done.json["result"]["watched"])] == [item[:2] for item in MANY_FOUND]
    again = here("replay", "out", "--json")
    (trace,) = again.json["traces"]
    assert found(trace["watched"]) == found(done.json["result"]["watched"])


def test_a_scenario_fails_for_what_is_broken_first(many: Path, here: Here) -> None:
    text = many.read_text().replace("  clause Answer@callee before Ring@caller\n", "")
    text = text.replace("  clause Answer@callee before Talk@caller\n", "").replace("n > 3", "n > 300")
    scenario = """
scenario "both deadlines pass while all rest" {
  dan : second  cid : first
  by 900ms cid in Ring and dan in Answer
  every cid in Talk leads to cid in Ring within 450ms
  for 2s
}
"""
    many.write_text(text + scenario)
    done = here("test", "many.aseme", "--json")
    (item,) = done.json["scenarios"]
    assert (item["verdict"], item["time_ns"]) == ("failed", 550_000_000)


TALKS = """\
system Talks
message Word { int n }
aip talk {
  participant asker {
    sends request Word
    receives inform Word
    process = Ask . Listen . Think
  }
  participant other {
    sends inform Word
    receives request Word
    process = Hear . Muse . Reply
  }
  clause Reply@other before Muse@other
  clause every Hear@other leads to Think@asker within 250ms
  clause Hear@other before Think@asker
  control asker {
    enter Ask    : / send request Word { n = 1 } to other
    enter Think  : inform Word from other
  }
  control other {
    enter Hear  : request Word from asker
    enter Reply : / send inform Word { n = 2 } to asker
  }
}
srm one {
  plays talk.asker
  liveness { one = asker }
  activities { Ask takes 20ms  Listen takes 1ms  Think takes 50ms }
}
srm two {
  plays talk.other
  liveness { two = other }
  activities { Hear takes 100ms  Muse takes 500ms  Reply takes 1ms }
}
team Pair { ann : one  bob : two }
"""


def test_each_conversation_has_its_clauses(here: Here, folder: Path) -> None:
    (folder / "talks.aseme").write_text(TALKS)
    done = here("run", "talks.aseme", "-o", "out", "--for", "3s", "--json", "-q", "--allow", "waiting")
    assert found(done.json["result"]["watched"]) == [
        ("clause of talk", "broken", 100),
        ("clause of talk", "broken", 250),
        ("clause of talk", "kept", 0),
    ]
    records = breaches(folder / "out" / "trace.jsonl.gz")
    assert [record["time"] for record in records] == [100_000_000, 250_000_001]
