"""Calculators with extreme inputs: results that a float cannot hold are refused, not 0.

The oracle is that a product of positive numbers is positive: no result of positive inputs is 0,
infinite or subnormal.
"""

import contextlib
import io
import math
import random
import sys
from unittest import mock

from radcalc import cli, terminal

SHORT, LONG = 125, 20_000

CALLS = (
    "point-source --flux {}lm --distance {}m",
    "point-source --intensity {}W/sr --height {}m --time {}s",
    "point-source --flux {}W --half-angle {}rad --distance {}m",
    "point-source --irradiance {}W/m2 --distance {}m --wavelength 555nm",
    "point-source --photon-flux {}photon/s --distance {}m --wavelength 555nm --exponent 3",
    "lambertian --luminance {}cd/m2 --area {}m2 --distance {}m",
    "lambertian --irradiance {}W/m2 --area {}m2 --distance {}m --wavelength 600nm",
    "lambertian disc --radiance {}W/m2/sr --radius {}m --distance {}m",
    "lambertian sphere --luminance {}cd/m2 --radius {}m --distance {}m",
    "lambertian rectangle --luminance {}cd/m2 --width {}m --length {}m --height {}m",
    "lambertian --incident-illuminance {}lx --reflectance 0.5 --area {}m2",
    "etendue --area {}m2 --receiver-area {}m2 --distance {}m --radiance {}W/m2/sr",
    "etendue --area {}m2 --half-angle {}rad --radiance {}W/m2/sr",
    "etendue --area {}m2 --f-number {}",
    "solid-angle cone --half-angle {}rad",
    "solid-angle patch --area {}m2 --distance {}m",
    "solid-angle disc --radius {}m --height {}m",
    "solid-angle sphere --radius {}m --distance {}m",
    "solid-angle rectangle --width {}m --length {}m --height {}m",
    "solid-angle pyramid --horizontal {}rad --vertical {}rad",
    "calorimeter --mass {}g --specific-heat {}J/kg/K --temperature-rise {}K --time {}s",
    "calorimeter --flux {}W --time {}s --receiver-area {}m2",
    "ev --luminance {}cd/m2 --iso {}",
    "ev --f-number {} --time {}s",
    "photon {}nm",
    "photon {}Hz",
    "screen --flux {}lm --width {}m --height {}m",
    "sensor --radiance {}W/m2/sr --f-number {} --pixel-area {}m2 --time {}s",
    "sensor --flux {}W --time {}s --responsivity 1A/W",
    "laser --flux {}W --diameter {}m --divergence 1mrad --distance {}m",
    "laser --flux {}W --diameter {}m --divergence 1mrad --limit {}W/m2",
    "room --width {}m --length {}m --height {}m --illuminance {}lx --flux {}lm --utilance 0.6",
    "uberlight 1m,2m,{}m --intensity {}cd --falloff 1 --falloff-distance {}m",
    "uberlight 1m,2m,{}m --illuminance {}lx --falloff {} --falloff-distance {}m --maximum 3",
    "convert {} W/m2 W/cm2",
    "convert {} lm lx --isotropic --distance {}m",
    "convert {} umol/s W --wavelength {}nm",
)
# Light below the horizon, a vertical picture, a distant picture, a beam that is safe at its exit.
MAY_BE_0 = ("luminous-effic", "ev", "incidence", "magnification", "hazard-distance")


def call(words: list[str]) -> tuple[int, str]:
    """Run a command in this process; return its status and output."""
    out = io.StringIO()
    with (
        mock.patch.object(terminal, "write", lambda text, **_: out.write(text)),
        contextlib.redirect_stderr(io.StringIO()),
    ):
        return cli.run(words), out.getvalue()


def sweep(count: int, seed: int) -> str:
    """Draw a call and the sizes of its inputs, from 1e-99 to 1e99 or of everyday sizes."""
    draw = random.Random(seed)
    answered = 0
    for _ in range(count):
        size = draw.choice((3, 30, 99))
        line = draw.choice(CALLS)
        sizes = [f"{10 ** draw.uniform(-size, size):.3g}" for _ in range(line.count("{}"))]
        words = line.format(*sizes).split()
        status, written = call([*words, "--precision", "17"])
        assert status in (terminal.ANSWERED, terminal.FAILED), (words, status)
        answered += status == terminal.ANSWERED
        for row in written.splitlines():
            *name, value, _ = row.split("\t")
            if name and any(part in name[0] for part in MAY_BE_0):
                continue
            assert sys.float_info.min <= abs(float(value)) < math.inf, (words, row)
    return f"{answered} of {count} calls answered, with positive numbers"


if __name__ == "__main__":
    from fuzz.command import main

    main(sweep, LONG)
