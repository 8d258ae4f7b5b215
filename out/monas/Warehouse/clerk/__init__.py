"""clerk of Warehouse. Generated from a.aseme by asemec; edit that file, not this one."""

# ruff: noqa: E501, N999, RUF100
from .plan import PLAN
from .step import ClerkStep

__all__ = ["PLAN", "ClerkStep"]
