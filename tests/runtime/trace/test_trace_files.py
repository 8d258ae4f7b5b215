"""Trace files under real trouble: a process killed amid a run, full and slow disks, and MCAP."""

from __future__ import annotations

import gzip
import json
import os
import resource
import signal
import subprocess
import sys
import threading
import time
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from aseme_dsl.runtime import Context
from aseme_dsl.runtime.trace import trace_blocks, trace_files, trace_gzip, trace_mcap
from aseme_dsl.runtime.trace.trace import Trace, format_for
from aseme_dsl.runtime.trace.trace_files import TraceError
from aseme_dsl.runtime.trace.trace_reading import TraceReader
from tests.runtime.playing import SECOND, check_line, lines_of, play
from tests.support.generated import Generated, generate
from tests.support.traces import HEADER

ROOT = Path(__file__).parents[3]
TEXT = """
system S
enum Mood { GOOD BAD }
message Place { double x  optional double y }
message M { int n  Mood mood  bytes raw  repeated Place places  Place at  string class_ }
topic t { state M  signal M }
srm R {
  liveness { R = (A . B)~ }
  activities {
    A every 50ms takes 10ms writes t.state.M
  }
  control R { enter B : [t.state.M.n >= 0] }
}
team T { ann, bob : R }
"""


@pytest.fixture(scope="module")
def generated() -> Generated:
    return generate(TEXT)


def run(generated: Generated, trace: Path, **options: Any) -> Any:
    place = generated.messages.Place

    class A:
        def execute(self, context: Context) -> None:
            n = context.random.randrange(5)
            places = (place(x=float("nan")), place(x=float("inf"), y=-0.0))
            message = generated.message("M", n=n, mood=1, raw=bytes([n, 255]), places=places, class_="ω")
            context.publish("t.state.M", message)

    return play(generated, {"A": A}, trace=trace, until=options.pop("until", SECOND), **options)


def texts_of(path: Path) -> list[str]:
    return [line.text for line in TraceReader(path)]


# ---- killed ------------------------------------------------------------------------------------

KILLED = """
import sys, time
sys.path.insert(0, {root!r})
from pathlib import Path
from aseme_dsl.runtime.trace.trace_reading import TraceReader
from tests.runtime.playing import make

def is_written():
    return any(line.record.get("text") == "number 500" for line in TraceReader(Path({trace!r})))

class A:
    def execute(self, context):
        for number in range(100_000):
            context.log(f"number {{number}}")
            if number == 500:
                while not is_written():
                    time.sleep(0.05)
                print("now", flush=True)
            context.wait(0.002)

team, _ = make("system S srm R {{ liveness {{ R = A }} }}", {{"A": A}}, clock="real", trace=Path({trace!r}))
team.run()
"""


@pytest.mark.parametrize("suffix", ["jsonl", "jsonl.gz", "mcap"])
def test_a_killed_run_leaves_a_trace_that_can_be_read(suffix: str, tmp_path: Path) -> None:
    """What is told is written soon, and is there, whatever happens to the process."""
    trace = tmp_path / f"run.{suffix}"
    script = KILLED.format(root=str(ROOT), trace=str(trace))
    with subprocess.Popen([sys.executable, "-c", script], stdout=subprocess.PIPE, text=True) as process:
        assert process.stdout is not None
        assert process.stdout.readline() == "now\n"
        process.send_signal(signal.SIGKILL)
        assert process.wait() == -signal.SIGKILL
    assert not trace.exists()
    reader = TraceReader(trace)  # the name of the trace will do
    told = [line.record["text"] for line in reader if line.record["kind"] == "log"]
    assert told[:501] == [f"number {number}" for number in range(501)]
    assert reader.path.name == f"run.{suffix}.part" and not reader.finished
    assert reader.problem is not None


def test_a_torn_last_line_is_reported_and_not_fatal(generated: Generated, tmp_path: Path) -> None:
    path = tmp_path / "run.jsonl"
    run(generated, path)
    whole = path.read_bytes()
    lines = whole.splitlines(keepends=True)
    for cut in (1, 2, 40, len(lines[-1]) - 1, len(lines[-1])):
        torn = tmp_path / "torn.jsonl"
        torn.write_bytes(whole[:-cut])
        reader = TraceReader(torn)
        read = [line.text for line in reader]
        if cut == 1:  # only the end of the line is missing
            assert len(read) == len(lines) and reader.problem is None
            continue
        assert [f"{text}\n".encode() for text in read] == lines[:-1]
        word = "did not come to its end" if cut == len(lines[-1]) else f":{len(lines)}: the trace breaks off"
        assert reader.problem is not None and word in reader.problem


def test_what_is_no_trace_is_named_with_its_line(tmp_path: Path) -> None:
    path = tmp_path / "x.jsonl"
    header = json.dumps(HEADER) + "\n"
    for text, said in (
        ("", "x.jsonl is empty"),
        ("hello\n{}\n", "x.jsonl:1: the header of a trace is wanted, not 'hello'"),
        (header + "{oops}\n" + header, "x.jsonl:2: a line of a trace is wanted, not '{oops}'"),
        (header + '{"kind":"log","time":0.5}\n' + header, "x.jsonl:2: a line of a trace is wanted"),
    ):
        path.write_text(text)
        with pytest.raises(TraceError, match=said.replace("{", r"\{")):
            list(TraceReader(path))
    with pytest.raises(TraceError, match="nowhere cannot be read: No such file"):
        TraceReader(tmp_path / "nowhere")


# ---- full and slow disks -----------------------------------------------------------------------


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="needs a device that is always full")
@pytest.mark.parametrize("clock", ["virtual", "real"])
@pytest.mark.parametrize("suffix", ["jsonl", "jsonl.gz", "mcap"])
def test_a_full_disk_ends_the_trace_and_not_the_run(clock: str, suffix: str, tmp_path: Path) -> None:
    path = tmp_path / f"run.{suffix}"
    path.write_text("old")
    path.with_name(path.name + ".part").symlink_to("/dev/full")

    class A:
        def execute(self, context: Context) -> None:
            for _ in range(30):
                context.log("x" * 1000)
                context.wait(0.05)

    played = play("system S srm R { liveness { R = A } }", {"A": A}, trace=path, clock=clock)
    assert played.result.reason == "finished"
    error = played.result.trace_error or ""
    assert "ends early: No space left on device; what was written is in run." in error
    assert played.of("fault") == [{**played.of("fault")[0], "agent": "", "reason": error}]
    assert path.read_text() == "old"


LIMITED = """
import resource, sys
sys.path.insert(0, {root!r})
from aseme_dsl.cli import main
resource.setrlimit(resource.RLIMIT_FSIZE, (200_000, 200_000))
sys.exit(main(["run", "out", "--for", "2min", "--quiet", "--trace", "run.jsonl"]))
"""


def test_a_file_that_may_not_grow_ends_the_trace_and_the_exit_code_says_so(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    from aseme_dsl.cli import main

    assert resource.getrlimit(resource.RLIMIT_FSIZE)[1] == resource.RLIM_INFINITY
    monkeypatch.chdir(tmp_path)
    (tmp_path / "s.aseme").write_text("system S srm R { liveness { R = A~ } activities { A takes 20ms } }")
    assert main(["build", "s.aseme", "-o", "out", "--only", "monas"]) == 0
    script = LIMITED.format(root=str(ROOT))
    done = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, timeout=120)
    assert done.returncode == 1
    assert "after 120 s" in done.stdout
    assert (
        "the trace run.jsonl ends early: File too large; what was written is in run.jsonl.part" in done.stderr
    )
    assert 190_000 < (tmp_path / "run.jsonl.part").stat().st_size <= 200_000
    reader = TraceReader(tmp_path / "run.jsonl")
    assert len(list(reader)) > 500 and reader.problem is not None


def test_a_slow_disk_makes_gaps_and_never_stops_the_run(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A pipe that nobody reads for a while is as slow as a disk gets."""
    monkeypatch.setattr(trace_files, "MOST_LINES", 100)
    path = tmp_path / "run.jsonl"
    pipe = path.with_name("run.jsonl.part")
    os.mkfifo(pipe)
    reader = os.open(pipe, os.O_RDONLY | os.O_NONBLOCK)  # before somebody writes: who finds nobody gives up
    os.set_blocking(reader, True)
    read: list[bytes] = []
    go = threading.Event()

    def reading() -> None:
        with os.fdopen(reader, "rb") as file:
            go.wait()
            read.append(file.read())

    thread = threading.Thread(target=reading)
    thread.start()
    told: list[dict[str, Any]] = []
    trace = Trace(path, [told.append], background=True)
    for number in range(1000):
        trace.write("log", number, agent="a", activity="A", label="0.1", text="x" * 1000)
        if number % 100 == 99:
            time.sleep(3 * trace_files.GATHER_SECONDS)
    go.set()
    while trace._output is not None and not trace._output.has_room(True):
        time.sleep(0.01)
    trace.write("log", 1000, agent="a", activity="A", label="0.1", text="last")
    trace.write("finish", 1000, reason="time", agents=[])
    trace.close()
    thread.join()
    assert trace.error is None
    lines = [json.loads(line) for line in read[0].splitlines()]
    gaps = [line for line in lines if line["kind"] == "gap"]
    for gap in gaps:
        check_line(gap)
    logs = sum(line["kind"] == "log" for line in lines)
    assert gaps and logs + sum(gap["lines"] for gap in gaps) == 1001
    assert (lines[-2]["text"], lines[-1]["kind"]) == ("last", "finish")
    assert [line["reason"] for line in told if line["kind"] == "fault"] == [
        "the trace has gaps: the disk is slower than the run"
    ]


def test_a_disk_that_hangs_does_not_hang_the_end(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(trace_files, "CLOSE_SECONDS", 0.1)
    path = tmp_path / "run.jsonl"
    pipe = path.with_name("run.jsonl.part")
    os.mkfifo(pipe)
    reader = os.open(pipe, os.O_RDONLY | os.O_NONBLOCK)
    trace = Trace(path, background=True)
    for number in range(200):
        trace.write("log", number, agent="a", activity="A", label="0.1", text="x" * 1000)
    trace.close()
    assert "the disk is too slow" in (trace.error or "")
    os.close(reader)


def test_real_and_virtual_time_write_the_same_lines(generated: Generated, tmp_path: Path) -> None:
    """The thread that writes in real time changes nothing: the lines come in their order."""
    listened: list[str] = []
    path = tmp_path / "run.jsonl"
    played = run(generated, path, clock="real", until=SECOND // 2)
    listened = [json.dumps(r, ensure_ascii=False, separators=(",", ":")) for r in played.records]
    assert texts_of(path) == listened


# ---- MCAP --------------------------------------------------------------------------------------


def test_an_mcap_trace_has_every_line_and_every_message(generated: Generated, tmp_path: Path) -> None:
    from google.protobuf.json_format import MessageToDict
    from mcap.reader import make_reader
    from mcap_protobuf.decoder import DecoderFactory

    run(generated, tmp_path / "run.jsonl")
    run(generated, tmp_path / "run.mcap")
    assert texts_of(tmp_path / "run.mcap") == (tmp_path / "run.jsonl").read_text().splitlines()
    with (tmp_path / "run.mcap").open("rb") as file:
        reader = make_reader(file, validate_crcs=True, decoder_factories=[DecoderFactory()])
        summary = reader.get_summary()
        assert summary is not None and summary.statistics is not None and summary.chunk_indexes
        assert reader.get_header().profile == "aseme"
        [metadata] = reader.iter_metadata()
        assert metadata.name == "aseme"
        assert metadata.metadata["system"] == "S" and metadata.metadata["seed"] == "1"
        assert metadata.metadata["agents"] == "ann:R bob:R" and metadata.metadata["models"]
        for schema in summary.schemas.values():
            assert schema.encoding in ("jsonschema", "protobuf")
            if schema.encoding == "jsonschema":
                assert json.loads(schema.data)["type"] == "object" and b"$ref" not in schema.data
        topics = {channel.topic: channel for channel in summary.channels.values()}
        assert {"ann/t/state/M", "bob/t/state/M", "trace/step", "trace/header"} <= topics.keys()
        assert topics["ann/t/state/M"].metadata["commType"] == "state"
        decoded = [
            (message.log_time, MessageToDict(proto, preserving_proto_field_name=True))
            for _, _, message, proto in reader.iter_decoded_messages(topics="ann/t/state/M")
        ]
    sent = [r for r in lines_of(tmp_path / "run.jsonl") if r["kind"] == "message" and r["agent"] == "ann"]
    assert [moment for moment, _ in decoded] == [r["time"] for r in sent]
    first, line = decoded[0][1], sent[0]["message"]
    assert first["mood"] == "MOOD_BAD" and first["raw"] == line["raw"] and first["class_"] == "ω"
    assert [place.get("x") for place in first["places"]] == ["NaN", "Infinity"]
    assert "y" not in first["places"][0] and first["places"][1]["y"] == 0.0


@pytest.mark.parametrize("suffix", ["mcap", "jsonl.gz"])
def test_one_seed_gives_one_file(suffix: str, generated: Generated, tmp_path: Path) -> None:
    run(generated, tmp_path / f"a.{suffix}")
    run(generated, tmp_path / f"b.{suffix}")
    assert (tmp_path / f"a.{suffix}").read_bytes() == (tmp_path / f"b.{suffix}").read_bytes()


def test_a_compressed_trace_has_the_same_lines(
    generated: Generated, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(trace_gzip, "BLOCK", 5000)
    run(generated, tmp_path / "a.jsonl")
    run(generated, tmp_path / "a.jsonl.gz")
    plain, packed = (tmp_path / "a.jsonl").read_bytes(), (tmp_path / "a.jsonl.gz").read_bytes()
    assert gzip.decompress(packed) == plain
    assert len(packed) < len(plain) / 3
    assert packed.count(trace_gzip.MAGIC + b"\x08") > 3  # each part can be read by itself


def test_a_compressed_trace_has_the_same_bytes_whenever_it_is_flushed(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(trace_gzip, "BLOCK", 3000)
    texts = [json.dumps(HEADER)]
    texts += [f'{{"kind":"note","time":{number},"text":"{"ab" * (number % 50)}"}}' for number in range(300)]
    often, never = tmp_path / "often.jsonl.gz", tmp_path / "never.jsonl.gz"
    for path in (often, never):
        file = format_for(path, path)
        for number, text in enumerate(texts, 1):
            file.put([text])
            if path == often and number % 3:
                file.flush()
                assert texts_of(path) == texts[:number]
                assert gzip.decompress(path.read_bytes()).decode().splitlines() == texts[:number]
        file.finish()
    assert often.read_bytes() == never.read_bytes()


@pytest.mark.parametrize("suffix", ["jsonl", "jsonl.gz", "mcap", "foreign.gz"])
def test_a_reader_begins_near_a_moment_or_goes_back_from_it(
    suffix: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(trace_gzip, "BLOCK", 500)
    monkeypatch.setattr(trace_blocks, "BLOCK", 500)
    agents = [{"name": name, "role": "R", "model": "1", "source": ""} for name in ("ann", 'b"ob')]
    texts = [json.dumps({**HEADER, "agents": agents})]
    for number in range(1, 1000):
        kind, agent, further = "note", "ann", ""
        if number % 100 in (0, 3):  # both have a checkpoint at each 100 ns, bob 3 ns later
            kind, agent = "checkpoint", "ann" if number % 100 == 0 else 'b\\"ob'
            further = '"model":"1","state":[],'
        elif number == 50:
            kind, further = "swap", '"what":"done",'
        texts.append(f'{{"kind":"{kind}","time":{number},"agent":"{agent}",{further}"step":{number}}}')
    path = tmp_path / f"x.{suffix}"
    if suffix == "foreign.gz":
        path.write_bytes(gzip.compress("".join(f"{text}\n" for text in texts).encode()))
    else:
        file = format_for(path, path)
        file.put(texts)
        file.finish()
    reader = TraceReader(path)
    has_blocks = bool(reader.blocks())
    assert has_blocks == (suffix not in ("mcap", "foreign.gz"))
    for moment, names, oldest in (
        (999, (), 900),
        (902, (), 800),
        (902, ("ann",), 900),
        (3, (), 0),
        (99, (), 0),
    ):
        found = list(reader.since(moment, names))
        assert [line.text for line in found] == [texts[line.number - 1] for line in found]
        assert found[0].record["kind"] == "header" and found[-1].number == 1000
        if has_blocks and oldest:
            assert [line.record["kind"] for line in found[:2]] == ["header", "swap"]
            begin = found[2].record["time"]
            assert oldest - 10 < begin <= oldest
            assert [line.record["time"] for line in found[2:]] == list(range(begin, 1000))
        else:
            assert len(found) == 1000
    for number in (0, 1, 777, 5000):
        back = [line.number for line in reader.before(number)]
        assert back == (list(range(min(number - 1, 1000), 0, -1)) if has_blocks else [])
    found = list(reader.before(900, ['"step":777}', '"step":555}', '"step":950}']))
    assert [line.record["time"] for line in found] == ([777, 555] if has_blocks else [])


def test_a_compressed_trace_that_is_cut_is_read_as_far_as_it_goes(
    generated: Generated, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(trace_gzip, "BLOCK", 5000)
    path = tmp_path / "a.jsonl.gz"
    run(generated, path)
    whole, texts = path.read_bytes(), texts_of(path)
    for size in range(0, len(whole) - 1, 97):
        path.write_bytes(whole[:size])
        reader = TraceReader(path)
        try:
            found = [line.text for line in reader]
        except TraceError as problem:
            assert size < 20, problem
            continue
        assert found == texts[: len(found)]
        assert reader.problem is not None
        assert size < len(whole) * 3 / 4 or len(found) > len(texts) / 3
    path.write_bytes(whole[:2000] + b"damage" + whole[2006:])
    reader = TraceReader(path)
    try:
        assert len(list(reader)) < len(texts)
        assert "breaks off" in (reader.problem or "")
    except TraceError as problem:  # the damage has given a line before it was found
        assert "a line of a trace is wanted" in str(problem)


def test_in_real_time_the_log_time_is_that_of_the_world(generated: Generated, tmp_path: Path) -> None:
    from mcap.reader import make_reader

    before = time.time_ns()
    run(generated, tmp_path / "run.mcap", clock="real", until=SECOND // 10)
    after = time.time_ns()
    with (tmp_path / "run.mcap").open("rb") as file:
        times = [message.log_time for _, _, message in make_reader(file).iter_messages()]
    # The clock on the wall is read a moment before or after the run's, and may be set meanwhile.
    assert before - SECOND <= min(times) and max(times) <= after + SECOND


def test_a_message_of_another_version_is_json(generated: Generated, tmp_path: Path) -> None:
    """The descriptors are those of the beginning: what has other members now must not become nonsense."""
    from mcap.reader import make_reader

    schema = generated.messages.SCHEMA
    header = dict(HEADER)
    header["messages"] = {
        "descriptors": schema.descriptors,
        "channels": {"t.state.P": schema.classes[generated.messages.Place]},
    }
    line = {"kind": "message", "time": 1, "agent": "a", "sequence": 1, "channel": "t.state.P"}
    contents = [{"x": 1.0, "y": 2.0}, {"y": 1.0, "x": 2.0}, {"x": 1.0}, {"x": "far", "y": None}]
    texts = [json.dumps(header), *(json.dumps({**line, "message": item, "to": []}) for item in contents)]
    file = format_for(tmp_path / "x.mcap", tmp_path / "x.mcap")
    file.put(texts)
    file.finish()
    assert texts_of(tmp_path / "x.mcap") == texts
    with (tmp_path / "x.mcap").open("rb") as opened:
        read = list(make_reader(opened).iter_messages(topics="a/t/state/P"))
    assert [channel.message_encoding for _, channel, _ in read] == ["protobuf", "json", "json", "json"]
    assert [json.loads(message.data) for _, _, message in read[1:]] == contents[1:]


def test_without_the_package_it_is_said_what_to_install(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(sys.modules, "mcap", None)
    with pytest.raises(TraceError, match=r"pip install 'aseme-dsl\[trace\]'"):
        Trace(tmp_path / "run.mcap")
    assert not list(tmp_path.iterdir())


def test_a_cut_mcap_file_is_read_as_far_as_it_goes(
    generated: Generated, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(trace_mcap, "CHUNK_BYTES", 50_000)
    run(generated, tmp_path / "run.mcap", until=20 * SECOND)
    lines = texts_of(tmp_path / "run.mcap")
    data = (tmp_path / "run.mcap").read_bytes()
    cut = tmp_path / "cut.mcap"
    seen = set()
    for share in (0.05, 0.3, 0.6, 0.9):
        cut.write_bytes(data[: int(len(data) * share)])
        reader = TraceReader(cut)
        read = [line.text for line in reader]
        assert read == lines[: len(read)] and reader.problem is not None
        seen.add(len(read))
    assert len(seen) > 2
    cut.write_bytes(data[: len(data) // 2] + b"garbage" + data[len(data) // 2 :])
    reader = TraceReader(cut)
    assert [line.text for line in reader] == lines[: len(list(TraceReader(cut)))]


words = st.text(max_size=5)
values = st.recursive(
    st.none() | st.booleans() | st.integers() | st.floats(allow_nan=False, allow_infinity=False) | words,
    lambda inner: st.lists(inner, max_size=3) | st.dictionaries(words, inner, max_size=3),
    max_leaves=5,
)
records = st.fixed_dictionaries(
    {"kind": st.sampled_from(["note", "unknown", "ω", "a b"]), "time": st.integers(0, 2**62)},
    optional={"agent": words, "text": values},
) | st.fixed_dictionaries(
    {
        "kind": st.sampled_from(["message", "radio_received"]),
        "time": st.integers(0, 2**62),
        "agent": words,
        "sender": words,
        "sequence": st.integers(1, 9),
        "to": st.lists(words, max_size=2),
        "channel": st.just("t.state.M"),
        "message": st.dictionaries(words, values, max_size=3),
    }
)


@settings(max_examples=100, deadline=None)
@given(lines=st.lists(records, max_size=20), compact=st.booleans())
def test_from_lines_to_mcap_and_back_is_the_same(
    lines: list[dict[str, Any]], compact: bool, tmp_path_factory: pytest.TempPathFactory
) -> None:
    path = tmp_path_factory.mktemp("t") / ("x.mcap" if len(lines) % 2 else "x.jsonl.gz")
    separators = (",", ":") if compact else (", ", " : ")
    texts = [json.dumps(line, separators=separators) for line in [HEADER, *lines]]
    file = format_for(path, path)
    file.put(texts)
    file.finish()
    assert texts_of(path) == texts
