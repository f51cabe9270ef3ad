"""The position of the sun from a place and a time, as inputs."""

import re
from datetime import datetime

from radcalc import errors
from radcalc.errors import option, quote
from radcalc.inputs import Inputs
from radcalc.inputs.reading import read
from radcalc.units.table import resolve

SIGNED, PLAIN = r"[+-]?\d+(?:\.\d*)?°?", r"\d+(?:\.\d*)?°? ?"
PLACE = re.compile(rf"({SIGNED}|{PLAIN}[NS]), ?({SIGNED}|{PLAIN}[EW])", re.IGNORECASE | re.ASCII)
WHEN = "2026-06-21T12:00+02:00"
FIRST_YEAR, LAST_YEAR = 1700, 2200  # the clock of the Earth's rotation is off by seconds, at most
POSITION = "sun-elevation", "sun-azimuth"


def located(given: Inputs) -> Inputs:
    """Return inputs with the position of the sun for their place and time, if they have any."""
    if "place" not in given and "when" not in given:
        return given
    for name in ("place", "when"):
        if name not in given:
            what, example = ("time", WHEN) if name == "when" else (name, "50.1N,14.4E")
            raise errors.MissingInput(
                f"the {what} of the sun is missing", errors.add(name, example)
            )
        for other in POSITION:
            if other in given:
                raise errors.Exclusive((name, other), "both place the sun")
    latitude, longitude = _coordinates(given["place"].text)
    elevation, azimuth = _position(latitude, longitude, _time(given["when"].text))
    if elevation < 0:
        when = option("when", quote(given["when"].text))
        problem = f"the sun is below the horizon ({elevation:.4g} deg) at {when}"
        raise errors.ConditionError(problem, "a time between sunrise and sunset")
    unit = resolve("deg")
    position = {
        name: read(name, (value, unit, f"{value:.6g}deg"))
        for name, value in zip(POSITION, (elevation, azimuth), strict=True)
    }
    others = {key: item for key, item in given.items() if key not in ("place", "when")}
    return {**others, **position}


def _coordinates(text: str) -> tuple[float, float]:
    """Return latitude and longitude [deg], positive to the north and to the east."""
    match = PLACE.fullmatch(text.strip().replace(errors.MINUS, "-"))
    if not match:
        problem = f"'{quote(text)}' is not a latitude and a longitude in degrees"
        places = "{place=50.1N,14.4E}, {place=33.9S,151.2E} or {place=-33.9,151.2}"
        raise errors.ConditionError(problem, errors.mention(places))
    south, west = match[1][-1] in "Ss", match[2][-1] in "Ww"
    latitude, longitude = [float(part.upper().rstrip("NSEW °")) for part in match.groups()]
    latitude, longitude = -latitude if south else latitude, -longitude if west else longitude
    if abs(latitude) > 90 or abs(longitude) > 180:
        problem = f"{option('place', quote(text))} is out of range"
        raise errors.ConditionError(problem, "latitudes up to 90 deg, longitudes up to 180 deg")
    return latitude, longitude


def _time(text: str) -> datetime:
    try:
        time = datetime.fromisoformat(text.strip())
    except ValueError:
        hint = errors.mention(f"{{when={WHEN}}}")
        raise errors.ConditionError(
            f"'{quote(text)}' is not a date and a time of ISO 8601", hint
        ) from None
    if time.tzinfo is None:
        problem = f"{option('when', quote(text))} has no offset from UTC"
        raise errors.ConditionError(problem, errors.mention(f"{{when={WHEN}}}, or Z for UTC"))
    if not FIRST_YEAR <= time.year <= LAST_YEAR:
        problem = f"{option('when', quote(text))} is out of range"
        raise errors.ConditionError(problem, f"years from {FIRST_YEAR} to {LAST_YEAR}")
    return time


def _position(latitude: float, longitude: float, time: datetime) -> tuple[float, float]:
    """Return the elevation of the sun with refraction, and its azimuth from north [deg]."""
    try:
        from pandas import DatetimeIndex
        from pvlib import solarposition
    except ImportError:
        problem = f"{option('place')} needs the package pvlib, which is missing"
        raise errors.ConditionError(problem, "pip install 'radcalc[solar]'") from None
    found = solarposition.get_solarposition(DatetimeIndex([time]), latitude, longitude).iloc[0]
    return float(found["apparent_elevation"]), float(found["azimuth"])
