"""Files by their contents: what a file is, the command that it means, and its columns."""
