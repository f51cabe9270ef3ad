"""The calculators' laws, one module per calculator."""
