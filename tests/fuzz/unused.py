"""Sentences with a number or a word put in: each typed amount changes the answer, or is refused."""

import random
import re
from collections import Counter

from conftest import run
from fuzz.sentences import PROBLEMS, amount, placed, target_of

SHORT, LONG = 60, 20_000
NUMBER = re.compile(r"(?<![\w.:/])\d+(?:\.\d+)?(?![\w.:/]*[:/])")
ADDED = str.split("""
    f/2.8 f/4 iso_100 iso_800 1/125_s 16_h 45_days 2_h 3_m 0.5_m 2_m2 5_cm 3_mm_pupil 16:9
    100_inch 65_in 30_deg 24_deg_beam 0.2_sr 532_nm 2_nm 555_nm_light 1_nm_linewidth 5000_K
    3000_K_led 0.7 80% 12 ND_0.9 2_stops height_2_m radius_3_m width_4_m 2_m_wide reflectance_0.5
    gain_1.1 at_450 2.5_m_x_4_m 5_mm_diameter nd8 K=12 100_W 40_lm/W 500_lx 20_cd 7_s 3_years
    index_1.5 na_0.2 luminaires_4 utilance_0.6 gn_40_m divergence_1_mrad half-angle_20_deg
    distance_3_m for_2_h over_2_m2 per_day on_white 2x3_m 2_in 3_ft 1_mile efficacy_90_lm/W
    time_3_s mean_3 exponent_2 isotropic hemisphere incidence_20_deg ev_9 ev100_9 apex-angle_9_deg
""")
WORDS = str.split("""
    half peak surface waist core reflected minus each three double equivalent visible lamps twice
    bandwidth linewidth shift line air water glass please the in a s m d h per of and x to lux
    footcandles nits lm watts meter seconds total average maximum not without before after
""")
MORE = (  # of cameras, screens, lasers and rooms, which the problems lack
    "f/4 1/125 s iso 100 to lux", "1000 cd/m2 f/4 1/125 s to lx.s", "EV 12 to lx",
    "iso 400 500 lx 1/60 s to f-number", "2000 lm 100 inch 16:9 to nits", "ND 0.9 in %",
    "f/2.8 50 W/m2 to W/m2", "10 mW 3 mm beam to W/cm2", "5 mW 1 mrad divergence at 50 m W/m2",
    "500 lx from a 5 m x 3 m panel at 4 m to cd/m2", "100 cd/m2 radius 3 m at 5 m to lx",
    "600 ppfd for 16 h to dli", "DLI 40 over 12 h to ppfd", "1 nm bandwidth at 532 nm to GHz",
    "2700 K blackbody to W/m2", "5 mW 532 nm lm", "500 lx D65 ppfd", "3200 K to 5600 K mired",
    "800 lx through ND 0.6 to lx", "8000 lx at 1 m how far for 500 lx", "136 fc at 16 m at 20 m fc",
    "area 54 m2 500 lx 3600 lm utilance 0.6 luminaires", "2 eV nm", "100 fL nits", "1 kW watts",
    "100 cd/m2 3 mm pupil td", "half angle 20 deg to sr", "24 W/m 100 lm/W 5 m lumens",
)  # fmt: skip


def sentence(draw: random.Random) -> str:
    """Return a sentence of a known kind, with its phrases in random order."""
    if draw.random() < 0.4:
        return draw.choice(MORE)
    problem = draw.choice(PROBLEMS)
    phrases = [placed(draw, part, amount(draw, part)[0]) for part in problem.parts]
    phrases += draw.sample(problem.words, min(1, len(problem.words)))
    if draw.random() < 0.9:
        phrases.append(target_of(draw, problem)[0])
    draw.shuffle(phrases)
    return draw.choice((" ", " ", ", ")).join(phrases)


def with_more(draw: random.Random, text: str) -> str:
    """Return a sentence with an amount or a word put in at a random place between its words."""
    words = text.split()
    more = draw.choice(ADDED if draw.random() < 0.7 else WORDS).replace("_", " ")
    words.insert(draw.randint(0, len(words)), more)
    return " ".join(words)


def answered(text: str) -> str:
    """Return an answer, with what it does not use; "" for a refusal."""
    done = run(*text.split())
    assert done.returncode in (0, 2), (text, done.stderr)
    unused = re.findall(r".* is not used", done.stderr)
    return "\n".join([done.stdout, *unused]) if done.returncode == 0 else ""


def changed(text: str, start: int, end: int) -> str:
    """Return a text with another number at a place."""
    number = text[start:end]
    digits = len(number.partition(".")[2])
    return f"{text[:start]}{float(number) * 1.13 + 0.6 * 10**-digits:.{digits}f}{text[end:]}"


def idle(text: str) -> list[str]:
    """Return the sentences with another number that have the same answer."""
    first = answered(text)
    if not first or first.startswith("0\t"):  # outside the beam
        return []
    others = [changed(text, *match.span()) for match in NUMBER.finditer(text)]
    return [other for other in others if answered(other) == first]


def sweep(count: int, seed: int) -> str:
    """Check random sentences: a number that can change without the answer is a failure."""
    draw = random.Random(seed)
    seen: Counter[str] = Counter()
    for _ in range(count):
        text = sentence(draw)
        if draw.random() < 0.8:
            text = with_more(draw, text)
        same = idle(text)
        assert not same, (text, same)
        seen["answered" if answered(text) else "refused"] += 1
    return ", ".join([f"{n} {what}" for what, n in sorted(seen.items())])


if __name__ == "__main__":
    from fuzz.command import main

    main(sweep, LONG)
