"""Converting a value to another unit or quantity: plans, bridges and the factors of conditions."""
