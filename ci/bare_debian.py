#!/usr/bin/env python3
"""Run both commands of the README on a bare Debian 12: `python3 ci/bare_debian.py [--root FOLDER] [TEST]`.

Makes a root with nothing but Python and its venv package (debootstrap, in a temporary folder), clones what is
committed into it, and runs `dev.py play` and `dev.py test` there. What pip is configured for on this machine
is handed on. It needs root and debootstrap; without them it says so and ends with 0. If a command fails, or
is not done in time, it ends with 1. Whatever runs in there ends with it.

A FOLDER is kept, and used again the next time: then only what has been committed since is fetched. So tests
can be tried one by one: `python3 ci/bare_debian.py --root /var/tmp/bare --only test tests/cli -x`.
"""

from __future__ import annotations

import argparse
import os
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from urllib.parse import unquote, urlsplit

ROOT = Path(__file__).resolve().parent.parent
SUITE = "bookworm"
PACKAGES = "ca-certificates,python3,python3-venv"
PLACE = "root/aseme-dsl"
"""Where the clone is, seen from the root."""

README = ("play", "test")
"""What the README tells people to run, behind `python3 dev.py`."""

MINUTES = 60.0
"""How long each may take."""

HANDED_ON = ("etc/pip.conf", "etc/resolv.conf", "etc/hosts", "etc/ssl/certs/ca-certificates.crt")
PROXIES = {"http_proxy", "https_proxy", "no_proxy"}

# The mounts are seen by what is started here alone, and end with it. The shell has its own numbering of
# processes, and is the first: when it is gone, so is everything that was started in there.
UNSHARE = ("unshare", "--mount", "--propagation", "private", "--pid", "--fork", "--kill-child")
INSIDE = """set -e
mount -t proc proc "$1/proc"
mount --rbind /dev "$1/dev"
root=$1; shift
while [ "$1" != -- ]; do mkdir -p "$root$1"; mount --bind "$1" "$root$1"; shift; done
shift
chroot "$root" "$@"
"""


def lacks() -> str | None:
    """Say what this machine lacks, if it does."""
    if not hasattr(os, "geteuid") or os.geteuid() != 0:
        return "it must be started as root"
    for program in ("debootstrap", "unshare", "chroot", "git"):
        if shutil.which(program) is None:
            return f"there is no {program}"
    if subprocess.run([*UNSHARE, "true"], capture_output=True).returncode != 0:
        return f"this machine lets nobody mount ({' '.join(UNSHARE)})"
    return None


def mirror() -> list[str]:
    """Return the archive that apt uses here for the same release; empty for the default of debootstrap."""
    asked = ["apt-get", "indextargets", "--format", "$(REPO_URI) $(RELEASE)", "Created-By: Packages"]
    try:
        lines = subprocess.run(asked, capture_output=True, text=True).stdout.split("\n")
    except OSError:
        return []
    return [line.split()[0] for line in lines if line.endswith(f" {SUITE}")][:1]


def pip_settings() -> dict[str, str]:
    """Return what pip is configured for here, as variables of the environment."""
    asked = [sys.executable, "-m", "pip", "config", "list"]
    found = {}
    for line in subprocess.run(asked, capture_output=True, text=True).stdout.splitlines():
        name, _, value = line.partition("=")
        section, _, key = name.rpartition(".")
        if section == "global":
            found["PIP_" + key.upper().replace("-", "_")] = value.strip("'").replace("\\n", " ")
    return found | {name: value for name, value in os.environ.items() if name.startswith("PIP_")}


def folders(settings: dict[str, str]) -> list[str]:
    """Return the folders of this machine that the settings name, or have files in; an index has its files
    beside it."""
    found = set()
    for name, value in settings.items():
        for word in value.split():
            path = Path(unquote(urlsplit(word).path) if word.startswith("file://") else word)
            if path.is_absolute() and path.is_dir():
                found.add(str(path.parent if name.endswith("INDEX_URL") else path))
            elif path.is_absolute() and path.is_file() and name.endswith("CONSTRAINT"):
                found.add(str(path.parent))
    return sorted(found - {"/"})


def make_root(root: Path) -> None:
    """Make the bare root, unless there is one already."""
    if not (root / "usr/bin/python3").exists():
        command = ["debootstrap", "--variant=minbase", f"--include={PACKAGES}", SUITE, str(root), *mirror()]
        subprocess.run(command, check=True)
    for name in HANDED_ON:
        if (Path("/") / name).exists():
            shutil.copyfile(Path("/") / name, root / name)


def make_clone(clone: Path) -> None:
    """Clone what is committed here; a clone that is there gets what is new, and keeps its environment."""
    git = ["git", "-c", "safe.directory=*"]
    if (clone / ".git").exists():
        subprocess.run([*git, "-C", str(clone), "fetch", "--quiet", str(ROOT), "HEAD"], check=True)
        subprocess.run([*git, "-C", str(clone), "reset", "--quiet", "--hard", "FETCH_HEAD"], check=True)
        subprocess.run([*git, "-C", str(clone), "clean", "--quiet", "-d", "--force"], check=True)
    else:
        shutil.rmtree(clone, ignore_errors=True)
        subprocess.run([*git, "clone", "--quiet", "--no-local", str(ROOT), str(clone)], check=True)


def run_inside(root: Path, arguments: list[str], minutes: float) -> str | None:
    """Run `python3 dev.py ARGUMENTS` in the clone; return what went wrong, None if nothing did."""
    settings = pip_settings()
    passed = settings | {name: value for name, value in os.environ.items() if name.lower() in PROXIES}
    passed |= {"PATH": "/usr/sbin:/usr/bin:/sbin:/bin", "HOME": "/root", "CI": "true"}
    command = [*UNSHARE, "sh", "-c", INSIDE, "sh", str(root)]
    command += [*folders(settings), "--", "sh", "-c", 'cd "$0" && exec "$@"', f"/{PLACE}"]
    command += ["/usr/bin/python3", "dev.py", *arguments]
    try:
        code = subprocess.run(command, env=passed, stdin=subprocess.DEVNULL, timeout=60 * minutes).returncode
    except subprocess.TimeoutExpired:
        return f"was not done in {minutes:g} minutes"
    return None if code == 0 else f"ended with {code}"


def main(arguments: list[str]) -> int:
    """Do it; return the exit code."""
    parser = argparse.ArgumentParser(
        prog="ci/bare_debian.py", description="Both commands of the README on Debian."
    )
    parser.add_argument("--root", type=Path, help="where the root is made, or one is already (it is kept)")
    parser.add_argument("--keep", action="store_true", help="leave the temporary root where it is")
    parser.add_argument("--only", choices=README, help="run this one only")
    parser.add_argument("--minutes", type=float, default=MINUTES, help=f"for each command ({MINUTES:g})")
    parser.add_argument("tests", nargs=argparse.REMAINDER, help="what pytest is given, instead of all tests")
    options = parser.parse_args(arguments)
    if (reason := lacks()) is not None:
        print(f"LEFT OUT: both commands of the README on a bare Debian 12: {reason}", flush=True)
        return 0
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(143))  # so that what is below is removed then, too
    root = options.root or Path(tempfile.mkdtemp(prefix="aseme-debian-"))
    try:
        make_root(root)
        make_clone(root / PLACE)
        for name in README if options.only is None else [options.only]:
            command = [name, *(options.tests if name == "test" else ())]
            print(f"== bare Debian: python3 dev.py {' '.join(command)}", flush=True)
            begun = time.monotonic()
            wrong = run_inside(root, command, options.minutes)
            if wrong is not None:
                print(f"bare Debian: dev.py {' '.join(command)} {wrong}", file=sys.stderr)
                return 1
            print(
                f"== bare Debian: dev.py {name} ended with 0 after {time.monotonic() - begun:.0f} s",
                flush=True,
            )
    finally:
        if options.root is None and not options.keep:
            shutil.rmtree(root, ignore_errors=True)
        else:
            print(f"The root is in {root}", flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
