"""Standard input, line by line, through a plan."""

# What a value that cannot be converted does.
ABORT, FAIL, WARN, IGNORE = INVALID = "abort", "fail", "warn", "ignore"
