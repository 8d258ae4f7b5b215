"""How fast generated statecharts are, against code written by hand and against other libraries."""
