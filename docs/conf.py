"""How Sphinx builds the documentation; CI builds it with -W, so a warning is an error."""

from __future__ import annotations

import sys
from pathlib import Path

import aseme_dsl

sys.path.insert(0, str(Path(__file__).parent / "_ext"))

project = "aseme-dsl"
author = "the aseme-dsl authors"
copyright = f"2026, {author}"
version = release = aseme_dsl.__version__

extensions = [
    "myst_parser",
    "sphinx.ext.autodoc",
    "sphinx.ext.napoleon",
    "aseme_dsl.documents.sphinx",
    "diagnostic_codes",
    "file_names",
    "navigation",
    "trace_lines",
]
exclude_patterns = ["_build", "_ext", "_static"]
source_suffix = {".md": "markdown"}

myst_enable_extensions = ["colon_fence", "deflist", "fieldlist"]
myst_heading_anchors = 3

autodoc_member_order = "bysource"
autodoc_typehints = "description"

html_theme = "furo"
html_title = f"aseme-dsl {version}"
html_static_path = ["_static"]
html_css_files = ["site.css"]
