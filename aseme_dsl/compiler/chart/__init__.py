"""Chart: the statecharts of roles and protocols."""
