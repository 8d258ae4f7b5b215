"""The page in a browser that shows the drawings."""

from __future__ import annotations

import http.client
import json
import queue
import re
import signal
import socket
import subprocess
import threading
import time
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from typing import Any
from urllib.parse import urlsplit

import pytest

from aseme_dsl.cli.lsp import project
from aseme_dsl.cli.view import Watched
from aseme_dsl.editor import viewer
from aseme_dsl.editor.answers.diagram import Diagrams
from aseme_dsl.editor.files.program import Program
from aseme_dsl.editor.files.workspace import Workspace
from aseme_dsl.editor.viewer import Viewer, page_state
from tests.cli.support import GOOD, command, save

SECONDS = 60.0
"""How long something may take, in s: an answer to whether it comes at all."""


class Browser:
    """Asks what the page asks."""

    def __init__(self, url: str, tab: str = "") -> None:
        found = urlsplit(url)
        self.tab = tab
        self.url = url
        assert found.hostname == "127.0.0.1" and found.port is not None
        self.host, self.path, self.version = f"127.0.0.1:{found.port}", found.path, 0

    def ask(
        self, method: str, name: str, body: str = "", **headers: str
    ) -> tuple[int, Mapping[str, str], str]:
        connection = http.client.HTTPConnection(self.host, timeout=SECONDS)
        try:
            path = name if name.startswith("/") else self.path + name
            connection.request(method, path, body.encode() or None, headers)
            answer = connection.getresponse()
            return answer.status, dict(answer.getheaders()), answer.read().decode()
        finally:
            connection.close()

    def next(self) -> Any:
        """What is shown, as soon as it is something else than before."""
        last = time.monotonic() + SECONDS
        status, headers, text = self.ask("GET", f"state?after={self.version}&tab={self.tab}")
        while status == 204 and time.monotonic() < last:  # nothing yet
            status, headers, text = self.ask("GET", f"state?after={self.version}&tab={self.tab}")
        assert status == 200
        self.version = int(headers["X-Version"])
        return json.loads(text)

    def until(self, wanted: Any) -> Any:
        """What is shown once it is as wanted."""
        last = time.monotonic() + SECONDS
        while time.monotonic() < last:
            state = self.next()
            if wanted(state):
                return state
        raise AssertionError(f"only {state['title']}: {state['note']}")

    def act(self, **said: Any) -> int:
        return self.ask("POST", "act", json.dumps({**said, "tab": self.tab} if self.tab else said))[0]


@pytest.fixture
def said() -> queue.SimpleQueue[Mapping[str, Any]]:
    return queue.SimpleQueue()


@pytest.fixture
def shown(said: queue.SimpleQueue[Mapping[str, Any]]) -> Iterator[Viewer]:
    made = Viewer(said.put)
    yield made
    made.close()


class TestPage:
    def test_it_gets_what_is_shown_and_what_comes_after(self, shown: Viewer) -> None:
        browser = Browser(shown.url)
        shown.show(page_state(title="one"))
        assert browser.next()["title"] == "one"
        later = threading.Timer(0.2, lambda: shown.show(page_state(title="two")))
        later.start()
        assert browser.next()["title"] == "two"
        later.join()

    def test_the_same_is_no_news(self, shown: Viewer, monkeypatch: pytest.MonkeyPatch) -> None:
        monkeypatch.setattr(viewer, "PATIENCE", 0.05)
        browser = Browser(shown.url)
        shown.show(page_state(title="one"))
        browser.next()
        shown.show(page_state(title="one"))
        assert browser.ask("GET", f"state?after={browser.version}")[0] == 204

    def test_what_people_do_is_told(self, shown: Viewer, said: queue.SimpleQueue[Mapping[str, Any]]) -> None:
        assert Browser(shown.url).act(act="click", id="n0") == 204
        assert said.get(timeout=SECONDS) == {"act": "click", "id": "n0"}

    def test_its_script_is_the_only_one_that_runs(self, shown: Viewer) -> None:
        status, headers, text = Browser(shown.url).ask("GET", "")
        nonce = re.findall(r"'nonce-([^']+)'", headers["Content-Security-Policy"])
        assert status == 200
        assert headers["Content-Security-Policy"].startswith("default-src 'none';")
        assert re.findall(r"<script[^>]*>", text) == [f'<script nonce="{nonce[0]}">']

    @pytest.mark.parametrize("length", ["9" * 5000, "9" * 30, "-1", "x", "100001"])
    def test_what_is_said_to_be_endless_is_not_waited_for(
        self, shown: Viewer, capfd: pytest.CaptureFixture[str], length: str
    ) -> None:
        where = urlsplit(shown.url)
        with socket.create_connection(("127.0.0.1", where.port or 0)) as raw:
            head = (
                f"POST {where.path}act HTTP/1.1\r\nHost: {where.netloc}\r\nContent-Length: {length}\r\n\r\n"
            )
            raw.sendall(head.encode())
            assert raw.makefile("rb").readline().startswith(b"HTTP/1.1 404")
        assert "Traceback" not in capfd.readouterr().err

    def test_nobody_else_is_answered(self, shown: Viewer, said: queue.SimpleQueue[Mapping[str, Any]]) -> None:
        browser = Browser(shown.url)
        assert browser.ask("GET", "/")[0] == 404
        assert browser.ask("GET", "/other/state?after=0")[0] == 404
        assert browser.ask("GET", "", Host="elsewhere.example")[0] == 404
        assert browser.ask("POST", "/act", "{}")[0] == 404
        assert browser.ask("POST", "act", "{}", Host="elsewhere.example")[0] == 404
        assert browser.ask("POST", "act", "[]")[0] == 400
        assert browser.ask("POST", "act", "{" * 5000)[0] == 400
        assert browser.ask("POST", "act", " " * 20_000)[0] == 404
        assert said.empty()


@contextmanager
def viewing(file: Path, *arguments: str) -> Iterator[Browser]:
    """`asemec view` of a file, ended as with Ctrl-C."""
    process = subprocess.Popen(
        command("view", file, *arguments), stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True
    )
    try:
        assert process.stdout is not None
        line = process.stdout.readline()
        found = re.search(r"http://\S+/", line)
        assert found is not None, line
        yield Browser(found[0])
        process.send_signal(signal.SIGINT)
        assert process.wait(timeout=SECONDS) == 0
        assert process.stdout.read() == ""
    finally:
        process.kill()
        process.communicate()


def test_a_file_is_followed(tmp_path: Path) -> None:
    file = tmp_path / "team.aseme"
    file.write_text(GOOD)
    with viewing(file) as browser:
        state = browser.next()
        assert state["name"] == state["model"] == "iac.robot"
        assert state["models"] == ["srm.robot", "iac.robot"]
        assert state["svg"].rstrip().endswith("</svg>") and state["note"] == ""

        browser.act(act="click", id="t4")
        state = browser.next()
        assert state["here"] == "t4"
        assert state["text"].endswith("enter Walk  : [eyes.state.Seen.ball]")
        browser.act(act="enter", id="n0.2")
        state = browser.until(lambda state: state["part"])
        assert state["name"] == "iac.robot.0.2"
        browser.act(act="choose", model="srm.robot")
        assert browser.until(lambda state: state["model"] == "srm.robot")["title"].startswith("Role robot")
        browser.act(act="choose", model="iac.robot")
        good = browser.until(lambda state: state["model"] == "iac.robot")

        save(file, GOOD.replace("(Walk | Stand)+", "(Walk | | Stand)+"))
        state = browser.until(lambda state: state["note"])
        assert "before the mistakes" in state["note"] and state["svg"] == good["svg"]
        assert "error[E1" in state["text"]
        save(file, GOOD.replace("Stand", "Sit"))
        state = browser.until(lambda state: not state["note"])
        assert ">Sit<" in state["svg"] and state["text"] == ""


def test_each_tab_has_a_selection_of_its_own(tmp_path: Path) -> None:
    file = tmp_path / "team.aseme"
    file.write_text(GOOD)
    with viewing(file) as first:
        one, two = Browser(first.url, "one"), Browser(first.url, "two")
        assert [one.next()["model"], two.next()["model"]] == ["iac.robot", "iac.robot"]
        one.act(act="choose", model="srm.robot")
        assert one.until(lambda state: state["model"] == "srm.robot")["here"] is None
        two.act(act="click", id="t4")
        state = two.next()
        assert (state["model"], state["here"]) == ("iac.robot", "t4")
        save(file, GOOD.replace("Stand", "Sit"))
        assert ">Sit<" in two.until(lambda state: "Sit" in state["svg"])["svg"]
        assert one.next()["model"] == "srm.robot"
        third = Browser(first.url, "three").next()
        assert (third["model"], third["here"]) == ("iac.robot", None)


def test_no_more_tabs_are_remembered_than_some(shown: Viewer) -> None:
    shown.show(page_state(title="all"))
    for number in range(3 * viewer.MOST_TABS):
        shown.show(page_state(title=str(number)), str(number))
    assert len(shown.tabs()) == viewer.MOST_TABS + 1
    assert Browser(shown.url, "0").next()["title"] == "all"


def test_a_file_that_changes_while_it_is_compiled_is_compiled_again(tmp_path: Path) -> None:
    file = tmp_path / "team.aseme"
    file.write_text(GOOD)

    class Slow(Workspace):
        def program(self, root: str) -> Program:
            found = super().program(root)
            if "Stand" in file.read_text():
                save(file, GOOD.replace("Stand", "Sit"))
            return found

    watched = Watched(file, Slow(project()), Diagrams(), None)
    end = time.monotonic() + SECONDS
    assert watched.wait(lambda: time.monotonic() > end), "the change is not seen"
    assert ">Sit<" in watched.state()["svg"]


def test_nothing_to_draw(tmp_path: Path) -> None:
    file = tmp_path / "team.aseme"
    file.write_text("system Nothing }\n")
    with viewing(file, "iac.nobody") as browser:
        state = browser.next()
        assert state["title"].startswith("Nothing to draw")
        assert "error[E1" in state["text"]
