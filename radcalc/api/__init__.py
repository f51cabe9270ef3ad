"""The Python functions: texts, quantities and arrays in, quantities and what was assumed out.

Dask's arrays too, where a function works element by element: what depends on them is then an array
of Dask's, and what is impossible among their elements raises its error as that is computed.
"""

from radcalc.api.conversion import convert, explain, factor
from radcalc.api.geometry import direction, etendue, solid_angle
from radcalc.api.homework import Verdict, check
from radcalc.api.instruments import calorimeter, ev, laser, room, screen, sensor
from radcalc.api.quantity import Quantity
from radcalc.api.result import Result
from radcalc.api.sources import lambertian, point_source, scene, uberlight
from radcalc.api.spectra import mesopic, photon, spectrum
from radcalc.api.surroundings import environment, irradiance_map, reproject, sky
