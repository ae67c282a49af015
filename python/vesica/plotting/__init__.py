"""The pictures of a finished run; see `tools/plot-run`."""
