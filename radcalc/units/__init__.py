"""Text to units and back: the definitions, the grammar and the compiled table."""
