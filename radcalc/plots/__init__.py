"""Pictures of answers: what is to be drawn as plain data, and what draws that.

`data` has the kinds of picture.  `curves`, `spectra`, `directions` and `places` make them of what
calculators and distributions give; they know no terminal and no file.  `terminal` draws a picture
in characters, `figure` as SVG or PNG; they know nothing of light.
"""
