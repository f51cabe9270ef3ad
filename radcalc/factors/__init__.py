"""What a condition supplies: a factor with a dimension, its assumption and its derivation."""
