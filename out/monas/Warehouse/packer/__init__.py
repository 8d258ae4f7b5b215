"""packer of Warehouse. Generated from a.aseme by asemec; edit that file, not this one."""

# ruff: noqa: E501, N999, RUF100
from .plan import PLAN
from .step import PackerStep

__all__ = ["PLAN", "PackerStep"]
