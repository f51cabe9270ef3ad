"""Sentences: calls in words, such as `20000 cd at 8 m to lx`, and the commands that they mean.

`words` divides a sentence into words and amounts, `phrases` is the table of phrases, `reader` finds
them in a sentence, and `calls` makes the call of a command from what they fill.
"""
