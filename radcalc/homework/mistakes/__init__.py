"""The usual mistakes, one module a family."""
