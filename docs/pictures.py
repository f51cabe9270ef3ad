"""Make the pictures of the README and docs/: python docs/pictures.py [FOLDER].

The pictures show real runs of the `radcalc` on the PATH, in a terminal, in the project's folder.
"""

import fcntl
import io
import os
import pty
import re
import shlex
import struct
import subprocess
import sys
import termios
from pathlib import Path

from rich.console import Console
from rich.text import Text

HERE = Path(__file__).parent
WIDTH, HEIGHT = 80, 50
SESSIONS = {
    "session": (
        "radcalc 800 lm cd",
        "radcalc 800 lm lx --isotropic --distance 2m",
        "radcalc 500 lx ppfd --spectrum LED-B3",
        "radcalc point-source --flux 500lm --beam-angle 30deg --distance 1m,2m,5m \\\n"
        "    -g irradiance:lx,beam-diameter:m --format table",
    ),
    "homework": (
        "radcalc 500 lx cd/m2 --reflectance 0.8 --check 400 --steps",
        "radcalc solid-angle cone --half-angle 30deg --check 0.842sr -q",
        "radcalc 100 cd at 2 m to lx --check 0,025klx -q",
    ),
    "spectra": (
        "radcalc spectrum D65 LED-B3 HPS \\\n    -g cct,cri,luminous-efficacy:lm/W,lux-per-ppfd -q",
        "radcalc spectrum LED-B3 --plot -g peak-wavelength:nm -q",
    ),
}
FETCHED = re.compile(r"\s*@font-face \{.*?\}", re.DOTALL)  # a picture must not fetch fonts
FONTS = "ui-monospace, Menlo, Consolas, DejaVu Sans Mono"
DOWNLIGHT = "radcalc point-source --distribution examples/downlight.ies --plot {}"


def run(command: str) -> str:
    """Return the output of a command in a terminal."""
    ours, theirs = pty.openpty()
    fcntl.ioctl(theirs, termios.TIOCSWINSZ, struct.pack("HHHH", HEIGHT, WIDTH, 0, 0))
    left_out = ("NO_COLOR", "FORCE_COLOR", "COLUMNS")
    env = {name: value for name, value in os.environ.items() if name not in left_out}
    words = shlex.split(command.replace("\\\n", ""))
    env |= {"TERM": "xterm-256color", "LC_ALL": "C.UTF-8"}
    with subprocess.Popen(
        words, cwd=HERE.parent, stdin=theirs, stdout=theirs, stderr=theirs, env=env
    ):
        os.close(theirs)
        written = b""
        try:
            while data := os.read(ours, 1 << 16):
                written += data
        except OSError:  # the end of a terminal is an error on Linux
            pass
    os.close(ours)
    return written.decode().replace("\r\n", "\n")


def session(name: str, path: Path) -> None:
    """Draw a terminal with the commands of a session and their output."""
    console = Console(record=True, width=WIDTH, file=io.StringIO(), force_terminal=True)
    for command in SESSIONS[name]:
        console.print(Text.assemble(("$ ", "green"), command))
        console.print(Text.from_ansi(run(command)))
    picture = console.export_svg(title="radcalc", unique_id=name)
    path.write_text(FETCHED.sub("", picture).replace("Fira Code", FONTS), encoding="utf-8")


def main(folder: Path = HERE) -> None:
    """Write all pictures."""
    for name in SESSIONS:
        session(name, folder / f"{name}.svg")
    path = folder / "downlight.svg"
    path.unlink(missing_ok=True)
    run(DOWNLIGHT.format(shlex.quote(str(path.resolve()))))


if __name__ == "__main__":
    main(*map(Path, sys.argv[1:]))
