"""Settings: the pyproject.toml (E010, E015, E016) and comments to asemec (W010–W014)."""

from __future__ import annotations

from enum import Enum

from aseme_dsl.diagnostics.codes import CODES
from aseme_dsl.diagnostics.problem import Problem
from aseme_dsl.diagnostics.wording import did_you_mean

# ---- E010: the pyproject.toml ------------------------------------------------------------------


class Fitting(Enum):
    """What a setting takes; the value is what it is called."""

    ACCOUNT = 'a name in quotes in which ROBOT stands for the agent\'s, such as "warehouse-ROBOT"'
    ADDRESSES = 'a table of addresses, such as { robot1 = "192.168.1.11", robot2 = "192.168.1.12:7448" }'
    ADDRESSES_WITH_PORTS = 'a table of addresses with ports, such as { robot1 = "192.168.1.11:5601" }'
    BACKENDS = 'a table of backends by role, such as { dispatcher = "jade_like" }'
    COUNT = "a whole number from 1 on"
    DURATION = 'a duration in quotes, such as "60s"'
    ENDPOINTS = 'a list of endpoints, such as ["tls/192.168.1.1:7447"]'
    FLAG = "true or false"
    FUNCTION = 'a Python function, such as "module:name"'
    HOST = 'the name or address of a host in quotes, such as "xmpp.example.org"'
    INTERFACE = 'the name or address of a network interface in quotes, such as "wlan0"'
    MEMORY = 'an amount of memory in quotes, such as "512MB"'
    NAMES = 'a list of names, such as ["monas"]'
    NETWORK = 'words for a network in quotes, such as "delay=0..300ms,loss=10%"'
    NUMBER = "a whole number"
    PATH = 'a path in quotes, such as "out"'
    PATHS = 'a list of paths, such as ["team.aseme"]'
    PORT = "a port, such as 5222"


class InvalidToml(Problem):
    """`reason`: what the TOML parser says."""

    code = "E010"
    path: str
    reason: str

    @property
    def message(self) -> str:
        return f"{self.path} is not valid TOML: {self.reason}"


class TooManyPartsOfKey(Problem):
    code = "E010"
    path: str
    line: int
    most: int

    @property
    def message(self) -> str:
        return f"{self.path}:{self.line}: a key has more than {self.most} parts"


class TomlTooDeep(Problem):
    code = "E010"
    path: str

    @property
    def message(self) -> str:
        return f"{self.path} has too many lists or tables in each other"


class NotTable(Problem):
    """`table`: the name of what should be one."""

    code = "E010"
    table: str

    @property
    def message(self) -> str:
        return f"`{self.table}` must be a table"


class KeyNotTable(Problem):
    """`table`: how the table is called."""

    code = "E010"
    key: str
    table: str

    @property
    def message(self) -> str:
        return f"`{self.key}` must be a table: [{self.table}]"


class NoKey(Problem):
    """`tables`: those that have it; `close`: the one of `others` that is spelt alike."""

    code = "E010"
    key: str
    table: str
    tables: tuple[str, ...]
    close: str | None
    others: tuple[str, ...]

    @property
    def message(self) -> str:
        return f"[{self.table}] has no key `{self.key}`"

    @property
    def hint(self) -> str:
        if self.tables:
            return f"it belongs into {' or '.join(f'[{self.table}.{table}]' for table in self.tables)}"
        return did_you_mean(self.close) if self.close else f"the table knows {', '.join(self.others)}"


class KeyMissing(Problem):
    code = "E010"
    key: str
    table: str

    @property
    def message(self) -> str:
        return f"[{self.table}] needs a `{self.key}`, too"


class NotFitting(Problem):
    """`wanted`: what the setting takes, or all its values."""

    code = "E010"
    key: str
    wanted: Fitting | tuple[str, ...]

    @property
    def message(self) -> str:
        if isinstance(self.wanted, Fitting):
            return f"`{self.key}` must be {self.wanted.value}"
        return f"`{self.key}` must be one of {', '.join(self.wanted)}, in quotes"


class NoSuchDiagnostic(Problem):
    """`close`: the code that is spelt alike."""

    code = "E010"
    key: str
    close: str | None

    @property
    def message(self) -> str:
        return f"there is no diagnostic `{self.key}`"

    @property
    def hint(self) -> str:
        if self.close:
            return did_you_mean(self.close)
        return "it is a code, such as W300, or how the codes of several begin, such as W3"


class ErrorTurnedDown(Problem):
    code = "E010"
    key: str
    hint = "nothing can be generated from a file that has one"

    @property
    def message(self) -> str:
        return f"`{self.key}`: an error cannot be turned down or off"


class NoRoleForBackend(Problem):
    """`close`: the one of `others` that is spelt alike."""

    code = "E010"
    role: str
    close: str | None
    others: tuple[str, ...]

    @property
    def message(self) -> str:
        return f"[tool.asemec.roles] names a role `{self.role}`, which the system does not have"

    @property
    def hint(self) -> str:
        if self.close:
            return did_you_mean(self.close)
        return f"the roles are {', '.join(self.others) or 'none'}"


class HostsNotRead(Problem):
    """`reason`: what is wrong with the file `path`, which `hosts` names."""

    code = "E010"
    path: str
    reason: str
    hint = 'it has a line for each agent, such as `robot1 = "192.168.1.11"`'

    @property
    def message(self) -> str:
        return f"the file {self.path} of `hosts` {self.reason}"


# ---- E015, E016: the network -------------------------------------------------------------------


class Unprotected(Problem):
    """With these settings, any process of the network could connect to a run."""

    code = "E015"


class NoCertificates(Unprotected):
    """`key` leads beyond this machine."""

    key: str
    hint = "add [tool.asemec.deploy.tls] with a certificate for each robot"

    @property
    def message(self) -> str:
        return f"`{self.key}` leads beyond this machine, and there are no certificates"


class EndpointWithoutCertificates(Unprotected):
    message = "an endpoint of `connect` is not protected by certificates"
    hint = "write `tls/…`"


class NoEffectWithoutHosts(Problem):
    code = "E016"
    key: str
    hint = "name the address of a robot in `hosts`"

    @property
    def message(self) -> str:
        return f"`{self.key}` has no effect without `hosts`"


# ---- E038: certificates ------------------------------------------------------------------------


class CertificateUnusable(Problem):
    """`reason`: what is wrong with a certificate or a key, or with the place of its file."""

    code = "E038"
    reason: str

    @property
    def message(self) -> str:
        return self.reason


class NoCertificateFiles(Problem):
    code = "E038"
    message = "there is no [tool.asemec.deploy.tls], which names the files of the certificates"
    hint = "add it with `authority`, `certificate` and `key`"


# ---- E039, E040: bundles -----------------------------------------------------------------------


class Incomplete(Problem):
    """`reason`: what of an unpacked bundle is missing, altered, or does not fit the machine."""

    code = "E039"
    reason: str
    hint = "deploy the bundle again with `asemec deploy`"

    @property
    def message(self) -> str:
        return self.reason


class SimulatedHere(Problem):
    """`names`: activities of an agent without code in the folder `activities`."""

    code = "W201"
    names: tuple[str, ...]
    activities: str
    hint = "`asemec deploy` makes a bundle with the code of all activities"

    @property
    def message(self) -> str:
        return f"no code in {self.activities} for {', '.join(self.names)}: the agent simulates them"


class NotDeployed(Problem):
    """`reason`: what prevents a bundle, or says the host it was copied to."""

    code = "E040"
    reason: str

    @property
    def message(self) -> str:
        return self.reason


class HostUnknown(Problem):
    """`known`: the agents and hosts that `hosts` names."""

    code = "E040"
    host: str
    known: tuple[str, ...]

    @property
    def message(self) -> str:
        return f"`hosts` names neither an agent nor an address `{self.host}`"

    @property
    def hint(self) -> str:
        return f"it names {', '.join(self.known) or 'no agent'}"


# ---- W010 to W014: comments to asemec ----------------------------------------------------------


class NoReason(Problem):
    code = "W010"
    message = "this does not say why"
    hint = "write after the bracket why it is right here"


class NothingToAllow(Problem):
    """`allowed`: a code that nothing here has."""

    code = "W011"
    allowed: str
    hint = "take it away"

    @property
    def message(self) -> str:
        return f"there is no `{self.allowed}` here to allow"


class NoSuchCode(Problem):
    """`close`: the code that is spelt alike."""

    code = "W012"
    allowed: str
    close: str | None

    @property
    def message(self) -> str:
        return f"there is no code `{self.allowed}`"

    @property
    def hint(self) -> str:
        if self.close is None:
            return "a code is such as W300"
        return f"did you mean `{self.close}` ({CODES[self.close].title})?"


class ErrorAllowed(Problem):
    code = "W013"
    allowed: str

    @property
    def message(self) -> str:
        return f"`{self.allowed}` is an error: nothing can be generated until it is fixed"


class CommentAllowed(Problem):
    """What is wrong with comments to asemec."""

    code = "W013"
    allowed: str
    hint = "the project's policy in pyproject.toml can"

    @property
    def message(self) -> str:
        return f"a comment cannot allow what is wrong with comments (`{self.allowed}`)"


class LateAllowFile(Problem):
    code = "W014"
    message = "`allow-file` after the beginning of the file"
    hint = "it stands above the first declaration; further down, write `allow`"


class CommentNotUnderstood(Problem):
    """`close`: the verb that is spelt like its first word."""

    code = "W014"
    close: str | None
    message = "this comment to asemec is not understood"

    @property
    def hint(self) -> str:
        if self.close is not None:
            return did_you_mean(self.close)
        return "it is written `// asemec: allow(CODE) reason` or `// asemec: allow-file(CODE) reason`"
