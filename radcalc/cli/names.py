"""Names of the commands and of options that need no command."""

TYPE_CHECKING = False  # typing is slow to import
if TYPE_CHECKING:
    from types import ModuleType

# The groups of the help, in its order.  That of COMMANDS is the order of proposals.
GROUPS = {
    "Convert": ("convert",),
    "Lamps and files": ("point-source", "scene", "uberlight", "laser", "dose", "columns"),
    "Surfaces, sky and rooms": (
        "lambertian",
        "environment",
        "sky",
        "room",
        "screen",
        "refraction",
    ),
    "Light itself": (
        "photon",
        "spectrum",
        "mesopic",
        "solid-angle",
        "direction",
        "etendue",
        "integrate",
    ),
    "Cameras and detectors": ("ev", "sensor", "calorimeter"),
    "Homework": ("mark",),
    "Tables and help": ("units", "quantities", "typical", "examples", "manual", "help", "prompt"),
}
HELP_NAMES = SHORT_HELP, COMPLETE_HELP = "-h", "--help"
EXPLAIN = "--explain"


def own_module(name: str) -> "ModuleType | None":
    """Import the module of a command; None for a calculator that its page describes alone."""
    from importlib import import_module
    from importlib.util import find_spec

    module_name = f"radcalc.cli.{name.replace('-', '_')}"
    return import_module(module_name) if find_spec(module_name) else None
