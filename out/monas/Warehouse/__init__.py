"""The system Warehouse: what every robot of it carries.

Generated from a.aseme by asemec; edit that file, not this one. Importing this registers the plans.
"""

# ruff: noqa: E501, N999, RUF100
from aseme_dsl.runtime.chart.chart import Chart

from .clerk.step import ClerkStep
from .packer.step import PackerStep

SYSTEM = "Warehouse"
SOURCE = "a.aseme"
MODEL = "81f9aa9b3c3106ae"
"""The hash of all models: robots with the same one run the same behaviour."""

TEAM: tuple[tuple[str, str], ...] = (
    ("clerk", "clerk"),
    ("packer", "packer"),
)
"""The agents of the team with their roles."""

CHARTS: dict[str, type[Chart]] = {
    "clerk": ClerkStep,
    "packer": PackerStep,
}
"""The class that runs each role."""
