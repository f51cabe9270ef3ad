"""Standard input, line by line, through a plan."""
