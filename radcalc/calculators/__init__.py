"""One module a command: which symbols it takes, which laws, what it assumes."""
