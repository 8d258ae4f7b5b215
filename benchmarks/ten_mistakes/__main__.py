"""What six tools say to the same ten mistakes: `python benchmarks/ten_mistakes [--peers DIR] [--write FILE]`.

The same behaviour stands beside this file once for each tool; `mistakes.toml` has the mistakes. The peers are
installed into DIR (Python packages and, where npm is there, XState with TypeScript), at the versions below.
"""

from __future__ import annotations

import argparse
import re
import shutil
import subprocess
import sys
import tempfile
import tomllib
from collections.abc import Sequence
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
PYTHON_PEERS = {
    "sismic": ("1.6.14", "with_sismic.yaml"),
    "python-statemachine": ("3.2.2", "with_python_statemachine.py"),
    "transitions": ("0.9.3", "with_transitions.py"),
    "xstate-statemachine": ("0.11.0", "with_xstate_statemachine.py"),
}
XSTATE, TYPESCRIPT = "5.33.3", "5.9.3"
NAMES = {"sismic": "Sismic", "xstate": "XState (TypeScript)"}


def main(arguments: Sequence[str] | None = None) -> None:
    """Run every tool on every mistake and print the table."""
    parser = argparse.ArgumentParser(prog="ten_mistakes", description=__doc__)
    parser.add_argument("--peers", type=Path, default=ROOT / "build" / "peers", metavar="DIR")
    parser.add_argument("--write", type=Path, metavar="FILE", help="write the page to FILE")
    options = parser.parse_args(arguments)
    set_up(options.peers)
    page = report(options.peers)
    if options.write:
        options.write.write_text(page, "utf-8")
    else:
        print(page)


def set_up(peers: Path) -> None:
    """Install the peers where they are not there yet."""
    if not (peers / "bin" / "python").exists():
        subprocess.run([sys.executable, "-m", "venv", str(peers)], check=True)
    wanted = [f"{name}=={version}" for name, (version, _) in PYTHON_PEERS.items()]
    subprocess.run([str(peers / "bin" / "python"), "-m", "pip", "install", "-q", *wanted], check=True)
    if shutil.which("npm") and not (peers / "js" / "node_modules").exists():
        (peers / "js").mkdir(exist_ok=True)
        packages = [f"xstate@{XSTATE}", f"typescript@{TYPESCRIPT}"]
        subprocess.run(["npm", "install", "--no-save", "--silent", *packages], cwd=peers / "js", check=True)


def report(peers: Path) -> str:
    """The page: a section for each mistake, and how often each tool named the place."""
    mistakes = tomllib.loads((HERE / "mistakes.toml").read_text("utf-8"))["mistake"]
    tools = ["aseme", *PYTHON_PEERS, *(["xstate"] if (peers / "js").exists() else [])]
    for tool in tools:
        calm = answer(tool, text_of(tool), peers)
        assert "nothing; no difference" in calm or calm == "", f"{tool} without a mistake: {calm}"
    lines: list[str] = []
    kinds: dict[str, list[str]] = {tool: [] for tool in tools}
    for number, mistake in enumerate(mistakes, 1):
        lines.append(f"## {number}. {mistake['name'][0].upper()}{mistake['name'][1:]}\n")
        said = answer("aseme", mutated("aseme", mistake), peers).strip()
        kinds["aseme"].append(kind(said))
        lines.append(f"```text\n{said}\n```\n")
        lines.append("| | what is said |\n| --- | --- |")
        for tool in tools[1:]:
            if tool not in mistake:
                said = "(there is no place for it)"
            else:
                said = answer(tool, mutated(tool, mistake), peers)
            kinds[tool].append(kind(said))
            lines.append(f"| {NAMES.get(tool, tool)} | {cell(said)} |")
        lines.append(f"| KSE, the original | {mistake['original']} |\n")
    return "\n".join([HEAD, *table(kinds), "", *lines])


def kind(said: str) -> str:
    """When and how something was said."""
    if re.search(r"^kicker.aseme:\d+:\d+: |^behaviour.ts\(\d|when loaded: .*\bline \d", said):
        return "with its place"
    if said.startswith("when loaded"):
        return "when loaded"
    return "in the match" if said.startswith("at event") else "not at all"


def table(kinds: dict[str, list[str]]) -> list[str]:
    """How many of the mistakes each tool names, and when."""
    columns = ["with its place", "when loaded", "in the match", "not at all"]
    titles = [
        "before it runs, with the place",
        "before it runs",
        "in the match, if it comes there",
        "not at all",
    ]
    lines = ["| | " + " | ".join(titles) + " |", "| --- " * 5 + "|"]
    for tool, found in kinds.items():
        counts = " | ".join(str(found.count(column) or "") for column in columns)
        lines.append(f"| {'**asemec**' if tool == 'aseme' else NAMES.get(tool, tool)} | {counts} |")
    return lines


HEAD = f"""# Ten mistakes, seven tools

The same small behaviour was written for each tool as its documentation shows it: a robot looks for a ball,
then kicks it or walks towards it. Then each file got the same mistake. This page has what each tool reported:
when the text was loaded, or else in a match of six events in which every branch is taken. It is written by
`python benchmarks/ten_mistakes --write docs/explanation/ten-mistakes.md`; the texts are in
`benchmarks/ten_mistakes/`.

Versions: {", ".join(f"{NAMES.get(name, name)} {item[0]}" for name, item in PYTHON_PEERS.items())}, XState
{XSTATE} with TypeScript {TYPESCRIPT} (`--strict`). What KSE did is known from its source and from runs of its
own code; it cannot be installed any more.
"""


def text_of(tool: str) -> str:
    """A tool's text of the behaviour."""
    name = {"aseme": "kicker.aseme", "xstate": "with_xstate.ts"}.get(tool) or PYTHON_PEERS[tool][1]
    return (HERE / name).read_text("utf-8")


def mutated(tool: str, mistake: dict[str, list[str]]) -> str:
    """The text with the mistake in it."""
    text = text_of(tool)
    edits = mistake[tool]
    for old, new in zip(edits[::2], edits[1::2], strict=True):
        assert text.count(old) == 1, f"{tool}: {old!r} stands {text.count(old)} times"
        text = text.replace(old, new)
    return text


def answer(tool: str, text: str, peers: Path) -> str:
    """What a tool says to a text, or what happens in the match."""
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        if tool == "aseme":
            (folder / "kicker.aseme").write_text(text, "utf-8")
            return run([sys.executable, "-m", "aseme_dsl", "check", "kicker.aseme"], folder, ROOT)
        if tool == "xstate":
            return xstate(folder, text, peers / "js")
        file = folder / PYTHON_PEERS[tool][1]
        file.write_text(text, "utf-8")
        return run([str(peers / "bin" / "python"), str(HERE / "drive.py"), tool, str(file)], folder, HERE)


def xstate(folder: Path, text: str, packages: Path) -> str:
    """What TypeScript says; where that is nothing, what happens in the match."""
    (folder / "behaviour.ts").write_text(text, "utf-8")
    (folder / "node_modules").symlink_to(packages.resolve() / "node_modules")
    compiler = packages.resolve() / "node_modules" / ".bin" / "tsc"
    flags = ["--strict", "--target", "es2022", "--module", "commonjs", "--skipLibCheck"]
    said = run([str(compiler), *flags, "behaviour.ts"], folder)
    return said or run(["node", str(HERE / "drive.mjs"), "."], folder)


def run(command: list[str], folder: Path, path: Path | None = None) -> str:
    """The output of a command; of a failure on standard error the last line."""
    environment = {"PATH": "/usr/local/bin:/usr/bin:/bin", "NO_COLOR": "1"}
    if path is not None:
        environment["PYTHONPATH"] = str(path)
    done = subprocess.run(command, cwd=folder, env=environment, capture_output=True, text=True, timeout=60)
    last = done.stderr.strip().splitlines()[-1:] if not done.stdout.strip() else []
    said = "\n".join([done.stdout.strip(), *last]).strip()
    return (
        ""
        if said == "no problems found in 1 file"
        else said.replace(str(folder), "").replace("/behaviour.ts", "behaviour.ts")
    )


def cell(text: str) -> str:
    """A text in a cell of a Markdown table, cut where it is very long."""
    line = " ".join(text.split()).replace("|", "\\|")
    return line if len(line) <= 240 else line[:240] + " …"


if __name__ == "__main__":
    main()
