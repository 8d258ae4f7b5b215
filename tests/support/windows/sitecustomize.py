"""Windows, as far as it can be played elsewhere: what Python lacks there is not there for our package.

Python imports this by its name when it stands on PYTHONPATH. The standard library and other packages go on as
they are: they know Windows. Only code of `aseme_dsl` finds that a module or name does not exist.
"""

import builtins
import os
import pathlib
import select
import signal
import socket
import sys
import types

MODULES = {
    "fcntl",
    "resource",
    "pwd",
    "grp",
    "termios",
    "tty",
    "pty",
    "syslog",
    "posix",
    "readline",
    "curses",
}

NAMES = {
    os: {
        "fork", "forkpty", "getuid", "geteuid", "getgid", "getegid", "getgroups", "getpgid", "getpgrp",
        "setpgid", "setsid", "killpg", "setuid", "chown", "lchown", "fchown", "fchmod", "mkfifo", "mknod",
        "uname", "statvfs",
        "sysconf", "getloadavg", "nice", "wait", "wait3", "wait4", "WNOHANG", "WIFEXITED", "WEXITSTATUS",
        "WIFSIGNALED", "WTERMSIG", "set_blocking", "get_blocking", "openpty", "pipe2", "sync", "getpriority",
        "setpriority", "posix_spawn", "O_NOFOLLOW", "O_NONBLOCK", "O_DIRECTORY", "O_CLOEXEC", "O_NOCTTY",
        "sched_setscheduler", "sched_getaffinity", "sched_setaffinity", "sched_param", "SCHED_FIFO",
        "sched_get_priority_min", "sched_get_priority_max", "sched_yield", "memfd_create", "pidfd_open",
        "confstr", "ctermid", "chroot", "initgroups", "register_at_fork",
    },
    signal: {
        "SIGKILL", "SIGHUP", "SIGQUIT", "SIGUSR1", "SIGUSR2", "SIGCHLD", "SIGPIPE", "SIGALRM", "SIGWINCH",
        "SIGCONT", "SIGSTOP", "SIGTSTP", "pthread_sigmask", "alarm", "setitimer", "siginterrupt", "pause",
        "sigwait", "SIG_BLOCK", "SIG_SETMASK", "SIG_UNBLOCK", "pthread_kill",
    },
    socket: {"AF_UNIX", "socketpair", "SO_PEERCRED", "SCM_RIGHTS", "SO_REUSEPORT", "send_fds", "recv_fds"},
    select: {"poll", "epoll", "kqueue"},
}  # fmt: skip
OURS = "aseme_dsl"


def asked_by_us(depth: int = 2) -> bool:
    """Whether the code that asks is of our package."""
    name = sys._getframe(depth).f_globals.get("__name__", "")
    return name == OURS or name.startswith(OURS + ".")


def lacking(module: types.ModuleType, names: set[str], other: dict[str, object]) -> None:
    """Hide names of a module, and show others, to our package."""

    class Module(types.ModuleType):
        def __getattribute__(self, name: str) -> object:
            if (name in names or name in other) and asked_by_us():
                if name in other:
                    return other[name]
                raise AttributeError(f"module {self.__name__!r} has no attribute {name!r}")
            return super().__getattribute__(name)

    module.__class__ = Module


def _open(path: object, flags: int, *arguments: object, **named: object) -> int:
    if named.get("dir_fd") is not None:
        raise NotImplementedError("dir_fd unavailable on this platform")
    if isinstance(path, str | bytes | os.PathLike) and pathlib.Path(os.fsdecode(path)).is_dir():
        raise PermissionError(13, "Permission denied", os.fspath(path))
    return _real_open(path, flags, *arguments, **named)


def _rename(source: object, target: object) -> None:
    if pathlib.Path(target).exists():
        raise FileExistsError(17, "File exists", os.fspath(target))
    _real_rename(source, target)


def _kill(process: int, number: int) -> None:
    if number == 0:
        raise AssertionError("on Windows, os.kill(…, 0) interrupts the process")
    _real_kill(process, number)


def _path_rename(self: pathlib.Path, target: object) -> pathlib.Path:
    _rename(self, target)
    return type(self)(target)


def _import(name: str, given=None, *others: object, **named: object) -> object:
    if name in MODULES and given is not None and str(given.get("__name__", "")).startswith(OURS):
        raise ModuleNotFoundError(f"No module named {name!r}", name=name)
    return _real_import(name, given, *others, **named)


_real_open, _real_rename, _real_kill, _real_import = os.open, os.rename, os.kill, builtins.__import__
pathlib.Path.rename = _path_rename
builtins.__import__ = _import
os.O_BINARY = 0o100000  # which Linux takes for O_LARGEFILE
lacking(os, NAMES.pop(os), {"name": "nt", "open": _open, "rename": _rename, "kill": _kill})
lacking(sys, set(), {"platform": "win32"})
for _module, _names in NAMES.items():
    lacking(_module, _names, {})
