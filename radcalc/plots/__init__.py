"""Pictures of answers: plain data, and modules that draw them.

`data` defines the kinds of picture.  `curves`, `spectra`, `directions` and `places` make them from
the results of calculators and distributions; they know no terminal and no file.  `characters` draws
a picture in characters, `figure` as SVG or PNG; they know nothing of light.
"""
