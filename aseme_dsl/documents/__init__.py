"""Documents: drawings of models in the pages of a documentation, made while it is built.

request   what a page asks for, from its options           fences   fenced blocks in a Markdown page
figures   from a source to pictures or problems            sphinx   the directive of Sphinx
html      a picture as HTML                                mkdocs   the plugin of MkDocs
"""
