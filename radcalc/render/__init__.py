"""Results to text, one module per output format."""
