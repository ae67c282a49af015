"""One figure or table of the reference paper each."""
