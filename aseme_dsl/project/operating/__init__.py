"""Operating: the whole team as its operators see it, and a node as its machine's service manager sees it."""
