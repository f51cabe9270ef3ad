"""Titles of columns have the same meaning in every command that reads a table."""

from itertools import product

import pytest
from conftest import run

import radcalc

# Not units of radcalc, or not of light; no command may take their numbers for lux.
NOT_LUX = ["ftcd", "Fc", "lum/ft²", "mV", "counts", "ADU", "V", "zork", "uA", "raw"]
FORMS = ["({})", "[{}]", "E ({})", "Light [{}]"]
LOG = "time,{}\n2024-06-01T12:00Z,1\n2024-06-01T13:00Z,2\n"


@pytest.mark.parametrize("title", [form.format(unit) for form, unit in product(FORMS, NOT_LUX)])
def test_numbers_in_an_unknown_unit_are_never_taken_for_light(title):
    calls = [
        (("dose", "-", "--unit", "lx"), LOG.format(title)),
        (("dose", "-"), LOG.format(title)),
        (("convert", "-", "lx", "fc", "-d", ",", "--column", "2"), f"id,{title}\n1,2\n"),
        (("spectrum", "-"), f"wavelength (nm),{title}\n400,1\n500,2\n600,1\n"),
    ]
    for words, text in calls:
        done = run(*words, input=text)
        assert (done.returncode, "try: " in done.stderr) == (2, True), (words, done.stdout)


@pytest.mark.parametrize("title", ["ftcd", "(Fc)", "lum/ft²"])
def test_another_spelling_of_the_typed_unit_is_read(title):
    done = run("dose", "-", "--unit", "fc", "-g", "exposure:lx.h", input=LOG.format(title))
    assert float(done.stdout) == pytest.approx(1.5 / 0.09290304)  # lx per fc: 1 ft = 0.3048 m
    assert "--unit fc" in run("dose", "-", input=LOG.format(title)).stderr


def test_the_users_unit_wins_over_a_known_title_and_is_said():
    done = run("dose", "-", "--unit", "klx", "-g", "exposure:lx.h", input=LOG.format("E [lx]"))
    assert float(done.stdout) == 1500
    assert "the values are in klx, as given; the title 'E [lx]' is in lx" in done.stderr


@pytest.mark.parametrize("unit", ["", "lx", "fc"])
def test_each_line_of_a_log_may_have_its_unit(unit):
    rows = "".join(
        f"2024-06-01T{12 + k}:00Z,{value},9,{name}\n"
        for k, (value, name) in enumerate([("2", "lux"), ("1", "Fc"), ("0.002", "klx")])
    )
    words = ["dose", "-", "-g", "exposure:lx.h", *(["--unit", unit] if unit else [])]
    done = run(*words, "--column", "value", input="time,value,raw,unit\n" + rows)
    assert float(done.stdout) == pytest.approx(2 + 1 / 0.09290304)  # 2, 10.76 and 2 lx
    bad = run(
        *words, "--column", "value", input=f"time,value,raw,unit\n{rows}".replace("klx", "mV")
    )
    assert "line 4: the unit 'mV' is not one of" in bad.stderr


def test_a_column_of_units_is_checked_and_replaced_in_a_stream():
    words = ["convert", "-", "lx", "fc", "-d", ",", "--column", "E", "--invalid", "warn"]
    done = run(*words, input="E,unit\n10,lux\n2,fc\n20,lx\n")
    assert done.stdout == "E,unit\n0.9290304,fc\n2,fc\n1.8580608,fc\n"
    assert "line 3: the unit is 'fc', not lx" in done.stderr


@pytest.mark.parametrize(
    ("title", "meaning"),
    [
        *((t, "photons") for t in ("SPFD", "SPPFD", "PPFD", "ph/s/nm", "fotony", "фотоны",
                                    "fotonů", "Photonen", "кванты", "QNTM")),
        *((t, "") for t in ("YPFD", "YPF", "refl", "Rfl", "R [%]", "%", "Transm", "odrazivost",
                            "коэффициент отражения", "пропускание", "Scope", "raw", "counts")),
        *((t, "watts") for t in ("E", "SPD", "relative power (%)", "LED 3", "Intensity [a.u.]")),
    ],
)  # fmt: skip
def test_a_title_over_a_spectrum_means_photons_watts_or_no_light(title, meaning):
    done = run("spectrum", "-", "-g", "x", input=f"nm,{title}\n400,1\n500,2\n600,3\n700,1\n")
    assert done.returncode == (0 if meaning else 2)
    assert f"relative {meaning} per wavelength" in done.stderr or not meaning


@pytest.mark.parametrize("delimiter", [";", "\t", " "])
@pytest.mark.parametrize(("values", "is_read"), [
    (["950", "1.050", "990"], False), (["950", "1.050", "0.5"], True),
    (["1.050", "1.051", "2.000"], True), (["950", "1050", "990"], True),
    (["950.5", "1.050", "9"], True), (["0", "1.050", "12.345"], False),
])  # fmt: skip
def test_a_point_that_may_separate_thousands_is_refused(delimiter, values, is_read):
    rows = [f"{400 + 100 * k}{delimiter}{value}\n" for k, value in enumerate(values)]
    spectrum = run("spectrum", "nm:-", input="".join(rows))
    log = run("dose", "-", "--time-unit", "s", "--unit", "lx", input="".join(rows))
    for done in (spectrum, log):
        assert (done.returncode == 0) is is_read, done.stderr
        assert (
            is_read
            or f"line {values.index(next(v for v in values if '.' in v)) + 1}: '" in done.stderr
        )


# A LI-1800 of LI-COR, whose program writes (QNTM) behind a remark; photobiologyInOut has examples.
LI1800 = '"FILE:X"\n"REM: {}"\n"LIMS: 400- 600NM"\n"INT:100NM"\n"MIN:  400NM  1.0E+00"\n'
PROGRAMS = [  # the preambles of programs that also write counts, and their titles, if any
    "Data from x.txt Node\nIntegration Time (sec): 1.0E-1\nXAxis mode: Wavelengths\n",  # OceanView
    "Saved at time: 1 ms\nIntegration time: 10000\nWavelengths\tIntensities\n",  # Ocean Optics
    "ENLIGHTEN Version,2.2.7\nTechnique,Scope\nIntegration Time,60\n\nWavelength,Processed\n",
    '" File: x"\n" SCOPE-> Wave:500nm Pix:1 Val:1 Time:100ms"\n',  # StellarNet
    "Int.time[ms]-->,100\nWavelength[nm],x\n",  # AvaSoft
]


def test_the_remark_of_a_li1800_tells_photons_from_reflectances():
    rows = " 400  1.0\n 500  1.0\n 600  1.0\n"
    done = run("spectrum", "-", "-g", "illuminance:lx", input=LI1800.format("TUBE (QNTM)") + rows)
    assert done.returncode == 0
    flat = run(
        "spectrum", "-", "-g", "illuminance:lx", input=f"nm;umol/m2/s/nm\n{rows}".replace("  ", ";")
    )
    assert done.stdout == flat.stdout
    unknown = run("spectrum", "-", input=LI1800.format("TUBE 36W/865") + rows)
    assert (unknown.returncode, "--unit W/m2/nm" in unknown.stderr) == (2, True)
    watts = ("spectrum", "-", "-g", "x", "--unit", "W/m2/nm")
    assert run(*watts, input=LI1800.format("TUBE 36W/865") + rows).returncode == 0
    for remark in ("REFL GREEN", "LEAF 3 TRANS", "reflectance"):
        bad = run("spectrum", "-", input=LI1800.format(remark) + rows)
        assert (bad.returncode, "is not light" in bad.stderr) == (2, True)


@pytest.mark.parametrize("preamble", PROGRAMS)
def test_values_of_a_detector_need_a_statement_or_a_unit(preamble):
    mark = "\t" if "," not in preamble else ","
    rows = "".join(f"{400 + 100 * k}{mark}{1.5 + k}\n" for k in range(4))
    bad = run("spectrum", "-", "-g", "x", input=preamble + rows)
    assert bad.returncode == 2
    assert "--unit W/m2/nm" in bad.stderr
    for unit, said in [("relative", "relative watts"), ("photons", "relative photons"),
                       ("uW/cm2/nm", "in uW/cm2/nm, as given")]:  # fmt: skip
        done = run("spectrum", "-", "-g", "x", "--unit", unit, input=preamble + rows)
        assert (done.returncode, said in done.stderr) == (0, True), done.stderr
    stated = preamble.replace("x", "x irradiance", 1) if "x" in preamble else preamble
    if stated != preamble and "SCOPE" not in preamble:
        assert run("spectrum", "-", "-g", "x", input=stated + rows).returncode == 0


def test_the_unit_given_for_a_spectrum_wins_over_its_title_and_is_said(tmp_path):
    path = tmp_path / "lamp.csv"
    path.write_text("nm,a (W/m2/nm),b (W/m2/nm)\n400,1,5\n500,1,5\n", encoding="utf-8")
    assert radcalc.spectrum(path, column="b").irradiance.magnitude == 500
    of_unit = radcalc.spectrum(path, column="b", unit="mW/m2/nm")
    assert of_unit.irradiance.magnitude == 0.5
    done = run("spectrum", str(path), "--column", "b", "--unit", "mW/m2/nm", "-g", "irradiance")
    assert float(done.stdout) == 0.5
    assert "the unit given differs from that of the title 'b (W/m2/nm)'" in done.stderr
    assert run("spectrum", str(path), "--unit", "lx").returncode == 2
    assert run("spectrum", "D65", "--unit", "W/m2/nm").returncode == 2


def spectrum_of(text, *words):
    """Return x, the illuminance or nothing, and the messages."""
    done = run("spectrum", "-", "-g", "x", *words, input=text)
    return done.stdout.strip(), done.stderr


TWO = "nm,E (W/m2/nm)\n400,1\n500,3\n700,2\n"


@pytest.mark.parametrize(
    "text",
    [
        "E (W/m2/nm),wavelength (nm)\n1,400\n3,500\n2,700\n",
        "#,Wavelength [nm],E [W/m2/nm]\n0,400,1\n1,500,3\n2,700,2\n",
        # Wasatch's ENLIGHTEN: pairs, then pixels before the wavelengths
        "Technique,Irradiance\nIntegration Time,60\n\nPixel,Wavelength,Processed\n"
        "0,400,1\n1,500,3\n2,700,2\n",
        # AvaSoft: units below the titles, counts before the light
        "Integration time [ms]: 48,06\nWave ;Sample ;Dark ;Absolute Irradiance\n"
        "[nm] ;[counts] ;[counts] ;[uWatt/cm2/nm]\n\n"
        " 400,0; 18,6; 7,3; 1,0\n 500,0; 15,6; -0,2; 3,0\n 700,0; 1,5; 0,1; 2,0\n",
        # StellarNet's SpectraWiz: a line of the settings, and a count at the end
        '" File: a"\n" RAD->  Wave:500nm  Pix:3  Val: 1  Time:100ms  Avg:1"\n'
        " 400.00  1.0E+000\n 500.00  3.0E+000\n 700.00  2.0E+000\n: 5\n",
        "Units (W/m^2nm)\nnm,value\n400,1\n500,3\n700,2\n",
        'nm;"E; on the bench [W/m2/nm]"\n400;"1,0"\n500;"3,0"\n700;"2,0"\n',
        "nm,E (W/m2/nm),uncertainty\n400,1,0.1\n500,3,0.1\n700,2,0.1\n",
    ],
)
def test_a_spectrum_is_found_among_other_columns_and_lines(text):
    assert spectrum_of(text)[0] == spectrum_of(TWO)[0]


def test_the_photons_of_a_li180_are_those_of_each_nanometre():
    """Both exports of one light are in the examples of photobiologyInOut, and agree."""
    rows = "".join(f"{nm}\t{nm * 1e-3 / 0.11962656564:.9f}\n" for nm in range(400, 701))
    done = run(
        "spectrum", "-", "-g", "irradiance", input=f"Wavelength(nm)\tPFD(umol m-2 s-1)\n{rows}"
    )
    assert float(done.stdout) == pytest.approx(300, rel=1e-8)  # 1 W/m2/nm, as h c N_A / lambda


@pytest.mark.parametrize(
    "titles", ["Sample [counts],Dark [counts]", "red,blue", "E (W/m2/nm),PFD (umol/m2/s/nm)"]
)
def test_no_column_is_guessed_among_several_of_light_or_none(titles):
    text = f"nm,{titles}\n400,1,2\n500,3,4\n"
    assert spectrum_of(text)[0] == ""
    assert "--column" in spectrum_of(text)[1]


def dose_of(text, *words):
    """Return the exposure in lx h, and the messages."""
    done = run("dose", "-", "-g", "exposure:lx.h", *words, input=text)
    return done.stdout.strip(), done.stderr


# Actiware: a table of intervals, a legend of the columns, and the table of epochs, with decimal
# commas in quotes; pyActigraphy has examples.  A trailing comma may be missing at the end.
ACTIWARE = """"Epoch Length:","30","minutes"
"White Light Threshold:","1000.00","lux"

"Interval Type","Start Date","Start Time","End Date","End Time","Total Light"
"","","","","","(lux-minutes)"

"REST","19.09.2019","21:00:00","20.09.2019","06:30:00","304,60"

"Line:","Line number"
"White Light:","White Light"

"Line","Date","Time","Activity","White Light","Sleep",

1,19.09.2019,14:00:00,0,"184,5","NaN",
2,19.09.2019,14:30:00,5,"200,25","NaN",
3,19.09.2019,15:00:00,7,"1,5","NaN"
"""


def test_the_largest_of_several_tables_in_a_log_is_read():
    exposure, said = dose_of(
        ACTIWARE, "--column", "White Light", "--unit", "lx", "--samples", "means"
    )
    assert float(exposure) == (184.5 + 200.25 + 1.5) / 2
    assert "the largest of several tables is read, with the titles in line 12" in said
    assert "Line, Activity, White Light" in dose_of(ACTIWARE)[1]  # not the dates of intervals


@pytest.mark.parametrize(
    ("text", "words", "exposure"),
    [
        # pandas: an index without a title
        (",Year,Month,Day,Hour,E [lx]\n0,2017,1,31,23,10\n1,2017,2,1,0,20\n2,2017,2,1,1,30\n",
         (), 40),
        # PCE 174 and Extech HD450: the unit in a column (philpagel/PCE174-communication)
        ("date,weekday,time,value,rawvalue,unit,range\n2019-03-10,7,17:00:00,10,10,lux,400\n"
         "2019-03-10,7,18:00:00,20,20,lux,400\n", ("--column", "value"), 15),
        # a unit in the preamble
        ("Meter,HD450\nUnit:,Lux\n\nNo.,Date,Time,Value\n1,2019-03-10,17:00:00,10\n"
         "2,2019-03-10,18:00:00,20\n", ("--column", "Value"), 15),
        # HOBOware: serial numbers in the titles
        ('"Plot Title: pond"\n"#","Date Time, GMT+01:00","Intensity, Lux (LGR S/N: 1)"\n'
         "1,2019-06-01 12:00:00,10\n2,2019-06-01 13:00:00,20\n", (), 15),
        ('time,E [lx]\n2024-06-01 12:00Z,"1,5"\n2024-06-01 13:00Z,"2,25"\n', (), 1.875),
    ],
)  # fmt: skip
def test_logs_of_programs_are_read(text, words, exposure):
    printed, said = dose_of(text, *words)
    assert float(printed) == exposure, said


def test_a_line_of_titles_in_a_table_does_not_hide_the_rows_before_it():
    rows = "".join(f"2024-06-01 {10 + k}:00Z,1\n" for k in range(3))
    exposure, said = dose_of(f"time,E [lx]\n{rows}time,E [lx]\n{rows.replace('1:', '2:')}")
    assert exposure == ""
    assert "line 5" in said


LAMP = "gamma,I (cd)\n0,300\n45,200\n90,0\n"


@pytest.mark.parametrize(
    "text",
    [
        f"Lab 7\nLamp: X\n\n{LAMP}",
        "Report\ngamma;I\ndeg;cd\n0;300,0\n45;200,5\n90;0\n".replace("200,5", "200,0"),
        LAMP.replace(",", "\t").replace("0\t300", '0\t"300,0"'),
    ],
)
def test_a_table_of_a_luminaire_has_lines_above_it(text, tmp_path):
    path, plain = tmp_path / "a.csv", tmp_path / "b.csv"
    path.write_text(text, encoding="utf-8")
    plain.write_text(LAMP, encoding="utf-8")
    flux = [run("point-source", "--distribution", str(p), "-g", "flux:lm") for p in (path, plain)]
    assert flux[0].stdout == flux[1].stdout != "", flux[0].stderr


def test_rows_of_a_luminaire_are_not_taken_for_lines_above_the_table(tmp_path):
    path = tmp_path / "a.csv"
    path.write_text("gamma,I (cd)\nx,1\ny,1\n0,300\n90,0\n", encoding="utf-8")
    done = run("point-source", "--distribution", str(path), "-g", "flux:lm")
    assert "line 2: 'x,1' is between the titles and the numbers" in done.stderr


def test_a_scene_has_lines_above_its_titles_and_units_below_them(tmp_path):
    path = tmp_path / "a.csv"
    for text in ("Project A\n\nx,y,z,flux\nm,m,m,lm\n0,0,2,800\n", "x,y,z,flux\n0m,0m,2m,800lm\n"):
        path.write_text(text, encoding="utf-8")
        done = run("scene", str(path), "--at", "0,0,0", "-g", "irradiance:lx")
        assert float(done.stdout) == pytest.approx(800 / (4 * 3.141592653589793 * 4))


@pytest.mark.parametrize(
    ("unit", "exposure"), [("", 1.5), ("klx", 1500), ("lux", 1.5), ("W/m2", None)]
)
@pytest.mark.parametrize("head", ["Unit: lux\n\n", "Unit: lux\n\ntime;value\n"])
def test_a_unit_above_a_log_gives_way_to_the_users(unit, exposure, head):
    text = f"{head}2024-06-01 12:00Z;1\n2024-06-01 13:00Z;2\n"
    printed, said = dose_of(text, *(["--unit", unit] if unit else []))
    assert printed == ("" if exposure is None else f"{exposure:g}")
    assert "the preamble" in said or unit == "lux"
    counts = dose_of(text.replace("value", "value (counts)"))
    assert counts[0] == ("" if "value" in head else "1.5")


@pytest.mark.parametrize("unit", ["lx", "W/m2"])
@pytest.mark.parametrize("title", ["PPFD", "SPFD", "PFD"])
def test_photons_in_a_log_are_not_in_another_unit(title, unit):
    assert dose_of(LOG.format(title), "--unit", unit)[0] == ""
    rows = f"2024-06-01 12:00Z,1,{unit}\n2024-06-01 13:00Z,2,{unit}\n"
    assert dose_of(f"time,PPFD,unit\n{rows}")[0] == ""


NSRDB = (  # metadata in two lines, and a column for each part of the time
    "Source,Location ID,GHI Units\nNSRDB,157537,{}\nYear,Month,Day,Hour,Minute,DNI,GHI,,\n"
    "2017,1,1,9,0,7,100,,\n2017,1,1,9,30,8,200,,\n2017,1,1,10,0,8,300,,\n"
)
SOLAR = "time,{}\n2017-01-01T09:00Z,100\n2017-01-01T09:30Z,200\n2017-01-01T10:00Z,300\n"


@pytest.mark.parametrize(
    ("text", "factor"),
    [
        (NSRDB.format("w/m2"), 1),
        (NSRDB.format("kW/m2"), 1000),  # the unit of the file wins over the usual one
        *((SOLAR.format(title), 1) for title in ("GHI", "ghi", "GHI_Wm2", "GHI (Wm-2)")),
        (SOLAR.format("GHI [kW/m2]"), 1000),
        (SOLAR.format("GHI\nUTC,W/m2"), 1),
    ],
)
def test_irradiances_of_the_sun_are_in_watts(text, factor):
    """The trapezoids of 100, 200 and 300 W/m2 over two half hours are 200 Wh/m2."""
    done = run("dose", "-", "--column", "GHI", "-g", "exposure:W.h/m2", input=text)
    assert float(done.stdout) == pytest.approx(200 * factor), done.stderr


@pytest.mark.parametrize(
    ("name", "unit", "larger"),
    [
        ("GHI", "W/m2", "kW/m2"),
        ("DNI", "W/m2", "kW/m2"),
        ("dni", "W/m2", "kW/m2"),
        ("PPFD", "umol/m2/s", "mmol/m2/s"),
    ],
)
def test_a_name_with_a_usual_unit_is_not_the_title_of_another(name, unit, larger):
    text = f"id,{name}\n1,500\n"
    words = ["convert", "-", "lx", "fc", "-d", ",", "--column", name]
    assert "irradiance, not illuminance" in run(*words, input=text).stderr
    words[2:4] = [unit, larger]
    done = run(*words, input=text)
    assert done.stdout == f"id,{name} [{larger}]\n1,0.5\n"
    words[2:4] = [larger, unit]
    assert run(*words, input=done.stdout).stdout == f"id,{name} [{unit}]\n1,500\n"


def test_no_column_is_chosen_while_another_has_watts():
    text = "time,E_Wm2,DNI (W/m2)\n2024-06-01T12:00Z,500,700\n2024-06-01T13:00Z,600,700\n"
    assert "there are 2 columns of values" in run("dose", "-", input=text).stderr


FIRST, SECOND = "400,1\n500,2\n600,3\n", "410,10\n510,30\n610,20\n"


@pytest.mark.parametrize(
    ("text", "refusal"),
    [
        (f"nm,E\n{FIRST}\nnm,E\n{SECOND}", "line 6: 'nm,E' begins a second table, after 3 rows"),
        (f"Sensor A\n{FIRST}Sensor B\n{SECOND}", "line 5: 'Sensor B' begins a second table"),
        (f"nm,E\n{FIRST}\n{SECOND}", "2 tables begin in the lines 2, 6"),
        (
            f"nm,E\n# scan 1\n{FIRST}# scan 2\n{FIRST}# scan 3\n{FIRST}",
            "3 tables begin in the lines",
        ),
    ],
)
def test_several_tables_in_a_file_of_a_spectrum_are_not_mixed(text, refusal):
    done = run("spectrum", "-", "-g", "peak-wavelength:nm", input=text)
    assert (done.returncode, done.stdout) == (2, "")
    assert refusal in done.stderr


def test_parts_of_a_spectrum_one_below_the_other_are_one():
    text = "nm,E\n500,2\n600,3\n\n300,1\n400,4\n"
    assert run("spectrum", "-", "-g", "peak-wavelength:nm", input=text).stdout == "400\n"


def test_the_table_of_wavelengths_is_read_below_that_of_results():
    text = f"Peak,Value\n1,530\n2,610\n\nWavelength [nm],Irradiance\n{SECOND}"
    done = run("spectrum", "-", "-g", "peak-wavelength:nm", input=text)
    assert done.stdout == "510\n"
    assert "the table of wavelengths is read, not that of line 2" in done.stderr


@pytest.mark.parametrize(("column", "peak"), [("A", "600"), ("B", "510")])
def test_each_column_has_the_wavelengths_before_it(column, peak):
    rows = zip(FIRST.split(), SECOND.split(), strict=True)
    text = "nm,A,nm,B\n" + "".join(f"{a},{b}\n" for a, b in rows)
    done = run("spectrum", "-", "-g", "peak-wavelength:nm", "--column", column, input=text)
    assert done.stdout == f"{peak}\n"
