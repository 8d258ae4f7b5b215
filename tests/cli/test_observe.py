"""`asemec observe`: what a log shows of the properties, clauses and protocols of a model."""

from __future__ import annotations

import gzip
import json
import os
import random
import shutil
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import pytest

from tests.cli.support import Here
from tests.support.traces import texts_of

KITCHEN = """\
system Kitchen

message Dish { string name }
message Meal { string name  int minutes }

aip ordering {
  participant waiter { process = Order . Await . Pay }
  participant cook [1..2] { process = Read . Cook }
  control waiter {
    enter Order : / send request Dish { name = "pie" } to cook
    enter Await : agree Dish from cook
    enter Pay   : inform Meal from cook or lost cook
  }
  control cook {
    enter Read : request Dish from waiter
    enter Cook : / send agree Dish { name = "pie" } to waiter
    leave Cook : / send inform Meal { name = "pie", minutes = 20 } to waiter
  }
  clause Cook@cook before Pay@waiter
  clause Pay@waiter before Cook@cook
}

srm service { plays ordering.waiter  liveness { service = waiter }  activities { Order takes 1s } }
srm kitchen {
  plays ordering.cook
  var dishes : int = 0
  liveness { kitchen = cook~ }
  activities { Read takes 1s  Cook takes 20s }
  control kitchen { enter cook : / dishes = dishes + 1 }
}
team Kitchen { ann : service  bob, cat : kitchen }

property "cooked once" { never two of kitchen in Cook }
property "it is paid" { every ann in Order leads to ann in Pay within 30s }
property "few" { never bob has [dishes > 3] }
property "announced" { sent request Dish before sent inform Meal }
property "no meal" { never sent inform Meal by cat }
"""


def line(moment: float, sender: str, to: Any, performative: str, message: str | None, **more: Any) -> str:
    """A line of a log of another program."""
    said = {"time": moment, "sender": sender, "receiver": to, "performative": performative}
    given = {} if message is None else {"message": message}
    return json.dumps({**said, **given, "content": {}, "protocol": "ordering", "conversation": "c", **more})


GOOD = [
    line(0, "ann", ["bob", "cat"], "request", "Dish"),
    line(1, "bob", "ann", "agree", "Dish"),
    line(1.5, "cat", "ann", "agree", "Dish"),
    line(20, "bob", "ann", "inform", "Meal"),
    line(21, "cat", "ann", "inform", "Meal"),
]


@pytest.fixture
def kitchen(folder: Path) -> Path:
    (folder / "kitchen.aseme").write_text(KITCHEN)
    return folder


@pytest.fixture
def run(kitchen: Path, here: Here) -> list[str]:
    """The lines of a run."""
    done = here("run", "kitchen.aseme", "-o", "out", "--for", "60s", "-q", "--allow", "waiting")
    assert done.code == 1 and "broken" in done.out, done.out + done.err
    return texts_of(kitchen / "out" / "trace.jsonl.gz")


def put(lines: Sequence[str], name: str = "log.jsonl") -> str:
    Path(name).write_text("".join(f"{item}\n" for item in lines))
    return name


def observed(here: Here, *words: str) -> Any:
    """What it says as JSON, with the exit code."""
    done = here("observe", *words, "--json")
    return {**done.json, "code": done.code}


def verdicts(found: Any) -> list[tuple[str, str]]:
    return [(item["of"], item["verdict"]) for item in found["statements"]]


# ---- traces --------------------------------------------------------------------------------------


SHOP = """\
system Shop
message Lot { int price }
aip sale {
  participant seller { var high : int = 0  process = Call . Sell }
  participant bidder { process = Bid }
  control seller {
    enter Call : / send cfp Lot { price = 1 } to bidder
    enter Sell : propose Lot offer from bidder / high = offer.price
  }
  control bidder { enter Bid : cfp Lot from seller  leave Bid : / send propose Lot { price = 2 } to seller }
}
srm house { plays sale.seller  liveness { house = seller } }
srm guest { plays sale.bidder  liveness { guest = bidder } }
team Room { ann : house  bob : guest }
property "sold" { never (ann in Sell and ann has [high == 0]) }
"""


def test_a_variable_of_a_participant_is_called_as_it_is_written(here: Here, folder: Path) -> None:
    (folder / "shop.aseme").write_text(SHOP)
    here("run", "shop.aseme", "-o", "out", "--for", "5s", "-q")
    (found,) = [item for item in observed(here, "out")["statements"] if item["verdict"] == "undecided"]
    assert found["reason"].startswith("it asks for the variable high, which"), found


def test_a_trace_is_watched_as_the_run_was(run: list[str], here: Here) -> None:
    done = here("observe", "out")
    assert done.code == 1
    assert done.out.splitlines()[:2] == [
        f"out/trace.jsonl.gz: {len(run) - 1} events",
        'broken     at 1 s: property "cooked once" (kitchen.aseme:33:26)',
    ]
    assert "bob       is in Cook" in done.out
    again = here("replay", "out", "--json").json["traces"][0]["watched"]
    found = observed(here, "out")
    undecided = [item for item in found["statements"] if item["verdict"] == "undecided"]
    assert [item["of"] for item in undecided] == ['property "few"']
    assert undecided[0]["reason"] == (
        "it asks for the variable dishes, which a log does not have; `asemec replay` decides it"
    )
    pairs = zip(again, found["statements"], strict=True)
    for one, other in pairs:
        if other["verdict"] != "undecided":
            assert (one["of"], one["verdict"], one["time_ns"]) == (
                other["of"],
                other["verdict"],
                other["time_ns"],
            )


def test_it_makes_no_step_again(run: list[str], here: Here) -> None:
    """A trace without what makes a replay possible is observed all the same."""
    lines = [item for item in run if '"kind":"checkpoint"' not in item]
    lines = [item.replace('"agent_messages":', '"other":') for item in lines]
    found, before = observed(here, put(lines)), observed(here, "out")
    assert verdicts(found) == verdicts(before) and found["protocols"] == before["protocols"]


@pytest.mark.parametrize("suffix", ["jsonl", "jsonl.gz", "mcap"])
def test_all_formats_say_the_same(suffix: str, run: list[str], here: Here) -> None:
    if suffix == "mcap":
        pytest.importorskip("mcap")
    assert here("trace", "out", "-o", f"again.{suffix}").code == 0
    assert verdicts(observed(here, f"again.{suffix}")) == verdicts(observed(here, "out"))


def left(lines: Sequence[str], *kinds: str) -> list[str]:
    """A trace with these kinds of lines only."""
    wanted = [f'"kind":"{kind}"' for kind in ("header", "finish", *kinds)]
    return [item for item in lines if any(kind in item for kind in wanted)]


def test_what_a_trace_does_not_have_is_undecided(run: list[str], here: Here) -> None:
    found = observed(here, put(left(run, "agent_message")))
    assert verdicts(found) == [
        ('property "cooked once"', "undecided"),
        ('property "it is paid"', "undecided"),
        ('property "few"', "undecided"),
        ('property "announced"', "kept"),
        ('property "no meal"', "broken"),
        ("clause of ordering", "undecided"),
        ("clause of ordering", "undecided"),
    ]
    assert found["statements"][0]["reason"] == "the log has no steps of bob"
    assert found["protocols"][0]["verdict"] == "kept"


@pytest.mark.parametrize(
    "lines",
    [
        lambda lines: left(lines, "step"),
        lambda lines: left(lines, "step", "agent_message"),
        lambda lines: left(lines, "step", "agent_message", "message", "activity"),
        lambda lines: lines[:1] + [item for item in lines[1:] if '"step":2,' not in item],
        lambda lines: lines[:1] + lines[len(lines) // 3 :],
        lambda lines: [item for item in lines if '"kind":"conversation"' not in item],
        lambda lines: [item for item in lines if '"agent":"bob"' not in item or '"header"' in item],
        lambda lines: [*lines[:3], '{"kind":"gap","time":0,"lines":7,"reason":"late"}', *lines[3:]],
    ],
)
def test_a_trace_with_missing_lines_passes_nothing(lines: Any, run: list[str], here: Here) -> None:
    """No statement about states is kept that speaks of what is missing."""
    found = observed(here, put(lines(run)), "--strict")
    assert found["code"] == 1
    about = [item for item in found["statements"] if "clause" in item["of"]]
    assert {item["verdict"] for item in about} <= {"undecided", "broken"}, found["statements"]


# ---- planted -------------------------------------------------------------------------------------


def of_messages(lines: Sequence[str]) -> list[int]:
    return [number for number, item in enumerate(lines) if '"kind":"agent_message"' in item]


def test_a_message_too_many_is_found(run: list[str], here: Here) -> None:
    place = of_messages(run)[1]
    found = observed(here, put([*run[: place + 1], *run[place:]]))
    (one,) = found["deviations"]
    assert (one["agent"], one["participant"], one["message"], one["to"]) == (
        "bob",
        "cook",
        "agree Dish",
        ["ann"],
    )
    assert one["allowed"] == ["inform Meal to waiter"]
    assert one["story"] == [
        "0 s  ann  sends request Dish { name = pie } to bob, cat",
        "1 s  bob  sends agree Dish { name = pie } to ann",
        "1 s  bob  sends agree Dish { name = pie } to ann",
    ]
    assert found["protocols"][0]["broken"] == 1 and found["code"] == 1


def test_a_message_that_is_missing_is_found(run: list[str], here: Here) -> None:
    first, agree, *_ = of_messages(run)
    without = [*run[:agree], *run[agree + 1 :]]
    (one,) = observed(here, put(without))["deviations"]
    assert (one["message"], one["allowed"]) == ("inform Meal", ["agree Dish to waiter"])
    without = [*run[:first], *run[first + 1 :]]
    (one,) = observed(here, put(without))["deviations"]
    assert (one["message"], one["awaited"]) == ("agree Dish", ["request Dish from waiter"])


def test_messages_in_another_order_are_found(run: list[str], here: Here) -> None:
    bobs = [number for number in of_messages(run) if '"agent":"bob"' in run[number]]
    lines = list(run)
    lines[bobs[0]], lines[bobs[1]] = lines[bobs[1]], lines[bobs[0]]
    (one,) = observed(here, put(lines))["deviations"]
    assert one["message"] == "inform Meal"


# ---- logs of other programs ----------------------------------------------------------------------


def test_a_log_of_messages_is_checked(kitchen: Path, here: Here) -> None:
    done = here("observe", put(GOOD), "--model", "kitchen.aseme")
    assert done.code == 1
    assert done.out.splitlines()[-1] == "kept       protocol ordering: 1 conversation, 5 messages"
    assert 'undecided  property "cooked once" (kitchen.aseme:' in done.out
    assert (
        'kept       property "announced"' in done.out and 'broken     at 21 s: property "no meal"' in done.out
    )


@pytest.mark.parametrize(
    ("lines", "said"),
    [
        ([*GOOD, GOOD[-1]], "cat (cook) sends inform Meal to ann: the protocol does not allow it there"),
        ([GOOD[0], *GOOD[3:]], "bob (cook) sends inform Meal to ann: the protocol does not allow it there"),
        ([GOOD[0], line(1, "bob", "cat", "agree", "Dish")], "bob (cook) sends agree Dish to cat: it is not"),
        ([GOOD[0], line(1, "bob", "ann", "refuse", "Dish")], "ordering has no such message"),
        (
            [GOOD[0], line(1, "bob", "ann", "agree", "Dish", participant="baker")],
            "ordering has no participant `baker`",
        ),
        ([GOOD[0], line(1, "ann", "bob", "agree", "Dish")], "cook sends that, not waiter"),
        ([line(0, "ann", ["bob", "cat", "dan"], "request", "Dish")], "the protocol has at most 2 cook"),
        ([GOOD[0], line(1, "dan", "ann", "agree", "Dish")], "dan sends agree Dish to ann"),
    ],
)
def test_the_first_message_that_is_not_allowed(
    lines: list[str], said: str, kitchen: Path, here: Here
) -> None:
    done = here("observe", put(lines), "--model", "kitchen.aseme")
    assert done.code == 1 and said in done.out, done.out


@pytest.mark.parametrize(
    "lines",
    [
        [GOOD[0], GOOD[2], GOOD[1], *GOOD[3:]],
        [*GOOD[:2], GOOD[3], GOOD[2], GOOD[4]],  # the answers of two cross
        [line(0, "ann", "bob", "request", "Dish"), line(0, "ann", "cat", "request", "Dish"), *GOOD[1:]],
        [line(0, "ann", "bob", "request", "Dish", id="7"), line(1, "ann", "cat", "request", "Dish", id="7")],
        [*GOOD[:3], line(20, "bob", "ann", "inform", None, content={"minutes": 3})],
        [*GOOD[:3], line(2, "ann", "bob", "not_understood", "Dish")],
        [item.replace('"request"', '"REQUEST"') for item in GOOD],
        [line(0, "ann", "bob", "request", "Dish", participant="waiter"), *GOOD[1:2]],
    ],
)
def test_what_some_order_of_arrivals_explains(lines: list[str], kitchen: Path, here: Here) -> None:
    found = observed(here, put(lines), "--model", "kitchen.aseme")
    assert found["deviations"] == [] and found["protocols"][0]["verdict"] == "kept", found


def test_an_answer_before_the_arrival(kitchen: Path, here: Here) -> None:
    lines = [line(0, "ann", "bob", "request", "Dish", received=5), line(1, "bob", "ann", "agree", "Dish")]
    (one,) = observed(here, put(lines), "--model", "kitchen.aseme")["deviations"]
    assert one["agent"] == "bob"
    lines[0] = line(0, "ann", "bob", "request", "Dish", received=0.5)
    assert observed(here, put(lines), "--model", "kitchen.aseme")["deviations"] == []


def test_a_log_that_begins_in_the_middle(kitchen: Path, here: Here) -> None:
    done = here("observe", put(GOOD[1:]), "--model", "kitchen.aseme")
    assert "undecided  protocol ordering: 1 conversation, 4 messages, 1 begun before the log" in done.out
    found = observed(here, put(GOOD[1:]), "--model", "kitchen.aseme", "--from-start")
    assert [item["message"] for item in found["deviations"]] == ["agree Dish"]
    twice = [GOOD[3], GOOD[3]]
    assert len(observed(here, put(twice), "--model", "kitchen.aseme")["deviations"]) == 1


def test_protocols_and_agents_that_the_model_does_not_have(kitchen: Path, here: Here) -> None:
    lines = [line(0, "eve", "mallory", "request", "Dish"), line(1, "x", "y", "cfp", "Z", protocol="other")]
    found = observed(here, put(lines), "--model", "kitchen.aseme")
    assert found["notes"] == ["the model has no protocol other (1 messages of it)"]
    assert found["protocols"][0]["verdict"] == "kept"
    only = put([line(1, "x", "y", "cfp", "Z", protocol="other")])
    assert here("observe", only, "--model", "kitchen.aseme", "--strict").code == 1


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("[1]", "log.jsonl:2: a message is a JSON object"),
        ("{", "log.jsonl:2: this is not JSON"),
        ("[" * 5000 + "\n", "log.jsonl:2: this is not JSON"),
        (GOOD[0].replace('"time": 0', '"time": "noon"'), "log.jsonl:2: `time` is not a date: 'noon'"),
        (GOOD[0].replace('"time": 0', '"time": 1e300'), "log.jsonl:2: "),
        (GOOD[0].replace('"time": 0', '"time": NaN'), "log.jsonl:2: "),
        (GOOD[0].replace('"sender": "ann"', '"sender": 3'), "log.jsonl:2: `sender` is not a text"),
        (GOOD[0].replace('"request"', '"shout"'), "log.jsonl:2: 'shout' is not a performative of FIPA"),
        (GOOD[0].replace('"conversation": "c"', '"x": 1'), "log.jsonl:2: a message has no `conversation`"),
    ],
)
def test_a_line_that_is_no_message(text: str, said: str, kitchen: Path, here: Here) -> None:
    done = here("observe", put([GOOD[0], text, GOOD[1]]), "--model", "kitchen.aseme")
    assert done.code == 1 and said in done.err, done.err + done.out


def test_torn_packed_and_disordered_logs(kitchen: Path, here: Here) -> None:
    Path("log.jsonl").write_text("\n".join(GOOD)[:-9])
    done = here("observe", "log.jsonl", "--model", "kitchen.aseme")
    assert "log.jsonl:5: the log breaks off here" in done.err and "4 events" in done.out
    packed = gzip.compress("".join(f"{item}\n" for item in GOOD).encode())
    Path("log.jsonl.gz").write_bytes(packed)
    assert "5 events" in here("observe", "log.jsonl.gz", "--model", "kitchen.aseme").out
    Path("log.jsonl.gz").write_bytes(packed[:-20])
    done = here("observe", "log.jsonl.gz", "--model", "kitchen.aseme")
    assert done.code == 1 and "breaks off here" in done.err
    done = here("observe", put([GOOD[0], *GOOD[2:], GOOD[1]]), "--model", "kitchen.aseme")
    assert "note: log.jsonl:5: the times go backwards here" in done.out


# ---- wrong use, the model, pictures --------------------------------------------------------------


def test_wrong_use(run: list[str], here: Here) -> None:
    done = here("observe", put(GOOD))
    assert done.code == 2 and "log.jsonl has no model in it: name it with --model FILE." in done.err
    assert here("observe", "out", "--for", "3s").code == 2
    done = here("observe", "out", "log.jsonl")
    assert done.code == 1 and "are logs of different kinds" in done.err
    assert here("observe", "nothing.jsonl").code == 1


def test_another_model(run: list[str], here: Here) -> None:
    """What is said of states counts where the roles are the same."""
    text = KITCHEN.replace("never two of kitchen", "never three of kitchen")
    Path("later.aseme").write_text(text)
    found = observed(here, "out", "--model", "later.aseme")
    assert verdicts(found)[0] == ('property "cooked once"', "kept"), found["statements"][0]
    Path("later.aseme").write_text(text.replace("kitchen = cook~", "kitchen = cook"))
    found = observed(here, "out", "--model", "later.aseme")
    assert found["statements"][0]["reason"] == ("bob ran another version of kitchen than that in the model")
    Path("other.aseme").write_text("system Other\nsrm one { liveness { one = Walk } }\n")
    done = here("observe", "out", "--model", "other.aseme")
    assert (done.code, "the model has no role service, which ann plays" in done.out) == (0, True), done.out


def test_a_story_has_the_lines_of_the_model_that_has_run(run: list[str], here: Here) -> None:
    later = KITCHEN.replace('send request Dish { name = "pie" }', 'send request Dish { name = "cake" }')
    Path("later.aseme").write_text(
        later + 'property "slow" { every ann in Order leads to ann in Pay within 2s }\n'
    )
    story = here("observe", "out", "--model", "later.aseme").out.partition('property "slow"')[2]
    assert 'send request Dish { name = "pie" }' in story
    assert "cake" not in story


def test_where_an_agent_of_another_version_is_nobody_knows(run: list[str], here: Here) -> None:
    Path("later.aseme").write_text(KITCHEN.replace("kitchen = cook~", "kitchen = cook"))
    done = here("observe", "out", "--model", "later.aseme")
    story = done.out.partition('property "no meal"')[2]
    assert "ran another version of kitchen than that in the model" in story
    assert "is in no state" not in done.out


def test_a_file_that_was_not_run_has_no_log_of_another_one(run: list[str], here: Here) -> None:
    Path("other.aseme").write_text("system Other\nsrm one { liveness { one = Walk } }\n")
    for command in ("observe", "replay", "sniff"):
        done = here(command, "other.aseme")
        assert done.code == 1
        assert "out has the last run of" in done.err and "not one of other.aseme" in done.err


def test_what_is_no_mcap_and_what_cannot_be_followed(run: list[str], here: Here) -> None:
    Path("bad.mcap").write_text("hello")
    done = here("observe", "bad.mcap")
    assert (done.code, "bad.mcap is not an MCAP file" in done.err) == (1, True), done.err
    for name, code in (("bad.mcap", "E035"), ("absent.jsonl", "E001")):
        done = here("observe", name, "--json")
        assert (done.code, [item["code"] for item in done.json["diagnostics"]]) == (1, [code]), done.out
    done = here("observe", "bad.mcap", "--live")
    assert (done.code, "--live cannot follow bad.mcap: an MCAP file" in done.err) == (2, True), done.err


def test_stories_are_drawn(run: list[str], here: Here) -> None:
    place = of_messages(run)[1]
    name = put([*run[: place + 1], *run[place:]])
    assert here("observe", name, "--stories", "drawn").code == 1
    names = sorted(path.name for path in Path("drawn").iterdir())
    assert names[-2:] == ["property-cooked-once.svg", "property-no-meal.svg"]
    drawn = Path("drawn/ordering-ordering-ann-1.svg").read_text()
    assert "agree Dish" in drawn and "the protocol does not allow it there" in drawn
    odd = [item.replace('"name":"pie"', '"name":"{pie}"') for item in [*run[: place + 1], *run[place:]]]
    assert here("observe", put(odd), "--stories", "odd").code == 1
    assert "{pie}" in Path("odd/ordering-ordering-ann-1.svg").read_text()


def test_the_traces_of_several_processes(run: list[str], here: Here) -> None:
    """Each has the lines of its agent; the receivers' clocks are late or early."""
    header = json.loads(run[0])
    for late in (0, 3_000_000, -3_000_000):
        for name in ("ann", "bob", "cat"):
            agents = [item for item in header["agents"] if item["name"] == name]
            lines = [json.dumps({**header, "agents": agents, "elsewhere": ["x"]})]
            for text in run[1:]:
                record = json.loads(text)
                if record.get("agent") == name:
                    shift = late if name == "ann" and record["time"] > 5_000_000 else 0
                    lines.append(json.dumps({**record, "time": record["time"] + shift}))
                elif record["kind"] == "agent_message" and name in record["to"]:
                    said = {key: item for key, item in record.items() if key not in ("to", "sequence")}
                    identity = [record["agent"], record["sequence"]]
                    lines.append(json.dumps({**said, "kind": "received", "agent": name, "input": identity}))
            put([*lines, run[-1]], f"trace.{name}.jsonl")
        found = observed(here, "trace.ann.jsonl", "trace.bob.jsonl", "trace.cat.jsonl")
        assert (found["deviations"], found["protocols"][0]["conversations"]) == ([], 1), found["deviations"]
        assert found["protocols"][0]["messages"] == len(of_messages(run))


# ---- live ----------------------------------------------------------------------------------------


def test_a_run_is_followed(run: list[str], here: Here) -> None:
    put(run[:-1], "live.jsonl.part")
    done = here("observe", "live.jsonl", "--live", "--for", "300ms")
    assert done.code == 1 and 'broken     at 1 s: property "cooked once"' in done.out
    put(run, "live.jsonl.part")
    done = here("observe", "live.jsonl", "--live")  # it ends with the run
    assert done.out.count('property "no meal"') == 2, done.out
    assert here("observe", "later.jsonl", "--live", "--for", "200ms").code == 1
    shutil.copy("out/trace.jsonl.gz", "packed.jsonl.gz")
    found = observed(here, "packed.jsonl.gz", "--live")
    assert verdicts(found) == verdicts(observed(here, "out"))


def test_lines_that_are_skipped_are_said(run: list[str], here: Here) -> None:
    put([*run[:5], "half a li", *run[5:]], "live.jsonl")
    done = here("observe", "live.jsonl", "--live")
    assert "a line is not a record of a trace; the first is line 6" in done.err, done.err


# ---- the same as the run -------------------------------------------------------------------------

_STATES = ["ann in Order", "ann in Await", "ann in Pay", "bob in Read", "some kitchen in Cook", "cat in Cook"]
_MOMENTS = [
    *("sent request Dish", "sent agree Dish by bob", "received inform Meal", "received agree Dish by ann"),
    *('sent request Dish d [d.name == "pie"]', "received request Dish by cat"),
]


def statements(chance: random.Random, number: int) -> str:
    """Some properties that a log decides."""
    found = []
    for place in range(number):
        one, other = chance.choice(_STATES), chance.choice(_STATES)
        first, second = chance.choice(_STATES + _MOMENTS), chance.choice(_STATES + _MOMENTS)
        within = chance.choice(["", " within 1s", " within 20s", " within 300ms"])
        text = chance.choice(
            [
                f"always {one} or {other}",
                f"never {one} and {other}",
                f"never {first}",
                f"{first} before {second}",
                f"{one} until {second}",
                f"every {first} leads to {second}{within}",
                f"eventually {first}{within}",
                f"at most {chance.randrange(3)} of kitchen in {chance.choice(['Read', 'Cook'])}",
                f"no {first} before {chance.choice(['1s', '10s'])}",
                f"no {first} within 5s after {second}",
                "never fault",
            ]
        )
        found.append(f'property "{place}" {{ {text} }}\n')
    return "".join(found)


@pytest.mark.parametrize("seed", range(int(os.environ.get("OBSERVED_RUNS", "2"))))
def test_verdicts_are_those_of_the_run(seed: int, folder: Path, here: Here) -> None:
    chance = random.Random(f"observe {seed}")
    text = KITCHEN[: KITCHEN.index("property")] + statements(chance, 40)
    (folder / "kitchen.aseme").write_text(text)
    how = chance.choice([(), ("--network", "delay 0..900ms"), ("--network", "delay 0..9s loss 20% reorder")])
    done = here(
        "run", "kitchen.aseme", "-o", "out", "--for", "40s", "-q", "--json", "--seed", str(seed), *how
    )
    watched = done.json["result"]["watched"]
    assert len(watched) == 42, done.err
    found = observed(here, "out")
    assert [(item["of"], item["verdict"], item["time_ns"]) for item in found["statements"]] == [
        (item["of"], item["verdict"], item["time_ns"]) for item in watched
    ]
    assert found["deviations"] == []


# ---- agents that the model does not know ---------------------------------------------------------


def test_messages_of_an_agent_with_another_version_count(run: list[str], here: Here) -> None:
    """Only its steps are not known: what it has sent can be read."""
    Path("later.aseme").write_text(KITCHEN.replace("kitchen = cook~", "kitchen = cook"))
    found = dict(verdicts(observed(here, "out", "--model", "later.aseme")))
    assert found['property "no meal"'] == "broken"
    assert found['property "announced"'] == "kept"
    assert found['property "cooked once"'] == found["clause of ordering"] == "undecided"


def test_a_role_that_the_model_does_not_have(run: list[str], here: Here) -> None:
    text = KITCHEN.partition("srm kitchen {")[0]
    text += 'property "it is announced" { some service in Order before some service in Await }'
    Path("later.aseme").write_text(text)
    done = here("observe", "out", "--model", "later.aseme")
    assert done.code == 0, done.out + done.err
    assert "note: the model has no role kitchen, which bob plays" in done.out
    assert 'kept       property "it is announced"' in done.out
