"""`radcalc point-source`."""

from radcalc.calculators.point_source import QUANTITIES, point_source
from radcalc.cli.calculator import Asked, run
from radcalc.cli.cases import cases
from radcalc.cli.command import LIGHT, define
from radcalc.cli.options import Output


@define(
    "point-source",
    {
        "Light": (*QUANTITIES, "peak-intensity"),
        "Its directions": (
            "distribution",
            "isotropic",
            "hemisphere",
            "half-angle",
            "apex-angle",
            "solid-angle",
            "exponent",
            "beam-angle",
            "field-angle",
            "within",
            "toward",
            "aim",
            "rotate",
        ),
        "The receiver": (
            "distance",
            "height",
            "offset",
            "offset-y",
            "incidence",
            "receiver-area",
            "time",
        ),
        "Kinds of light": LIGHT,
    },
    draws=True,
)
def command(typed: dict[str, str], asked: Asked, shown: Output) -> int:
    """Give what follows for a source that is small beside its distance.

    \b
    Examples:
      radcalc point-source --flux 800lm --distance 2m
      radcalc point-source --illuminance 500lx --distance 2m
      radcalc point-source --intensity 100cd --illuminance 25lx            (the distance)
      radcalc point-source --intensity 250cd --height 6m --offset 8m
      radcalc point-source --intensity 250cd --height 6m --illuminance 3lx   (the offset)
      radcalc point-source --flux 4.5klm --half-angle 12.5deg --distance 1m,2m,5m
      radcalc point-source --flux 800lm --hemisphere --distance 2m
      radcalc point-source --intensity 1000cd --beam-angle 30deg
      radcalc point-source --beam-angle 30deg                (exponent, field angle)
      radcalc point-source --half-angle 15deg --height 2m -g beam-diameter
      radcalc point-source --luminous-flux 800lm --radiant-flux 3W  (the efficacy)
      radcalc point-source --intensity 100cd --exponent 3 --within 45deg -g flux-within:lm
      radcalc point-source --flux 500lm --intensity 900cd --distribution cone
      radcalc point-source --flux 5mW --distance 1m --receiver-area 1cm2 --wavelength 632.8nm
      radcalc point-source --distribution lamp.ies --height 3m --offset 1m
      radcalc point-source --distribution lamp.ies --plot                 (polar diagram)
      radcalc point-source --flux 800lm --distance 1m:10m:0.1m --plot fall-off.svg
      radcalc point-source --distribution lamp.ldt --flux 3klm --illuminance 50lx
      radcalc point-source --distribution table.csv --toward 0deg:90deg:5deg
      radcalc point-source --distribution '300*cos(theta)^4*(theta<90*deg) cd'
      radcalc point-source --distribution lamp.ies --aim 1,0,-2 --rotate 90deg \\
          --height 3m --offset 2m

    Any sufficient set of the quantities gives the others; what is given twice is checked, to the
    digits typed.  The irradiance is at the receiver.  Light comes along the receiver's normal,
    unless --incidence tells otherwise or -g incidence asks what it is; under a --height the
    source points straight down and the receiver lies flat.  An offset, a height or an exponent
    follows from the light; where two fit, both are shown.

    --distribution also reads the file of a luminaire (IES LM-63, EULUMDAT), a table of angles and
    intensities (CSV), or an expression in theta, the angle from the source's axis, and phi, the
    azimuth about it, with a unit behind a blank; - is standard input.  Such a source is taken as it
    is, unless a light quantity scales it.  --offset is towards C0, --offset-y towards C90.

    Several sources add up (see also radcalc scene):

    \b
      for i in 100cd 250cd; do
        radcalc point-source --intensity $i --distance 2m -q -g irradiance:lx
      done | awk '{ sum += $1 } END { print sum }'
    """
    wanted = asked.wants("incidence")
    each = cases(typed, arrays=True)
    return run(each, lambda given: point_source(given, wanted), asked, shown, "point-source")
