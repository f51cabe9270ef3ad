"""What is measured, and what it is called."""
