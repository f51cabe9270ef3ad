"""Pictures of answers: plain data (`data`), and modules that draw them.

The modules that make pictures know no terminal and no file; `characters` and `figure`, which draw
them, know nothing of light.
"""
