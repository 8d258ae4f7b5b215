"""Documents: drawings of models in the pages of a documentation, made while it is built.

- `request`: the drawing that a page asks for, from its options
- `figures`: from a source to pictures or problems
- `html`: a picture as HTML
- `fences`: fenced blocks in a Markdown page
- `sphinx`: the directive of Sphinx
- `mkdocs`: the plugin of MkDocs
"""
