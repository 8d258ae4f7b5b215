"""Look: boxes and lines as data, and the one style of all drawings."""
