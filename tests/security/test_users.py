"""The helper itself: a child is another user, who cannot read what is ours alone."""

from __future__ import annotations

from pathlib import Path

from tests.security.conftest import AsOther
from tests.security.users import NOBODY

READ = """
try:
    open(sys.argv[1]).read()
except PermissionError:
    print("refused", os.getuid(), os.getgroups())
"""


def test_the_other_user_is_another(as_other: AsOther, tmp_path: Path) -> None:
    secret = tmp_path / "secret"
    secret.write_text("x")
    secret.chmod(0o600)
    done = as_other(READ, str(secret))
    assert done.stdout.strip() == f"refused {NOBODY} []", done.stderr
