"""Files of text, and tables of columns in them."""
