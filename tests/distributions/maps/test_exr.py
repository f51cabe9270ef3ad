"""OpenEXR pictures, read and written; files come from the package OpenEXR."""

import io
import struct
import subprocess
import sys

import numpy as np
import OpenEXR
import pytest

from radcalc.distributions.maps import exr
from radcalc.distributions.maps.pictures import Picture, read_picture, write_picture
from radcalc.errors import ConditionError, option

RGB = ("R", "G", "B")
ACES = (0.7347, 0.2653, 0.0, 1.0, 0.0001, -0.0770, 0.32168, 0.33767)  # AP0
ACES_WEIGHTS = (
    0.3439664498,
    0.7281660966,
    -0.0721325464,
)  # its luminance, as colour-science 0.4.7 has it


def colours(height=4, width=8, kind=np.float32):
    """Pixels that are all different and exact in half floats."""
    count = 3 * height * width
    return (np.arange(1, count + 1).reshape(height, width, 3) / 4).astype(kind)


def planes(pixels, names=RGB):
    return {name: np.ascontiguousarray(pixels[..., k]) for k, name in enumerate(names)}


def made(channels, **header):
    """The bytes of a file, as the package writes them."""
    file = io.BytesIO()
    header = {"compression": OpenEXR.ZIP_COMPRESSION, "type": OpenEXR.scanlineimage, **header}
    OpenEXR.File(header, channels).write(file)
    return file.getvalue()


def read(channels, **header):
    return exr.read(made(channels, **header), "sky.exr")


def tiles(wide, high):
    found = OpenEXR.TileDescription()
    found.xSize, found.ySize = wide, high
    return {"type": OpenEXR.tiledimage, "tiles": found}


def refused(data):
    with pytest.raises(ConditionError) as caught:
        exr.read(bytes(data), "sky.exr")
    assert caught.value.hint
    return caught.value.message


def edited(data, attribute, value, at=0):
    """A file with bytes of an attribute's value replaced."""
    start = data.index(attribute.encode() + b"\0")
    start = data.index(b"\0", start + len(attribute) + 1) + 5 + at
    return data[:start] + value + data[start + len(value) :]


@pytest.mark.parametrize("kind", [np.float16, np.float32])
@pytest.mark.parametrize("compression", ["NO", "RLE", "ZIPS", "ZIP", "PIZ", "PXR24", "ZSTD"])
def test_pixels_are_those_of_the_file(kind, compression):
    pixels = colours(37, 21, kind)
    packed = getattr(OpenEXR, f"{compression}_COMPRESSION")
    found = read(planes(pixels), compression=packed)
    assert found.pixels.dtype == np.float32
    assert (found.pixels == pixels).all()
    assert found[1:4] == (RGB, (0.2126, 0.7152, 0.0722), "OpenEXR")
    by_709 = "the luminance is that of Rec. 709 primaries, as the file declares none"
    assert found[4:9] == ("", "", None, (by_709,), ())


def test_half_floats_are_widened():
    """65504 is the largest half float; a sum of two is infinite in half floats."""
    found = read(planes(np.full((2, 4, 3), 65504, np.float16)))
    assert found.pixels.sum() == 24 * 65504


def test_tiles_are_read():
    pixels = colours(70, 90)
    assert (read(planes(pixels), **tiles(16, 32)).pixels == pixels).all()


def test_a_latlong_map_is_read_and_a_cube_refused():
    found = read(planes(colours()), envmap=OpenEXR.ENVMAP_LATLONG)
    assert found.projection == "latlong"
    assert "poles" in found.assumptions[0]
    data = made(planes(colours(24, 4)), envmap=OpenEXR.ENVMAP_CUBE)
    assert refused(data) == "sky.exr is an environment map that is a cube, which is not read"
    assert "environment map of an unknown kind" in refused(edited(data, "envmap", b"\7"))


@pytest.mark.parametrize(
    ("chromaticities", "weights"),
    [
        (ACES, ACES_WEIGHTS),
        ((1.0, 0.0, 0.0, 1.0, 0.0, 0.0, 1 / 3, 1 / 3), (0, 1, 0)),  # R, G, B are X, Y, Z
    ],
)
def test_luminance_follows_the_primaries_of_the_file(chromaticities, weights):
    found = read(planes(colours()), chromaticities=chromaticities)
    assert found.weights == pytest.approx(weights, abs=1e-6)


def test_with_a_white_luminance_pixels_are_in_cd_m2():
    """The standard attribute is the luminance of R = G = B = 1."""
    found = read(planes(colours()), whiteLuminance=179.0)
    assert found.unit == "cd/m2"
    assert (found.pixels == colours() * 179).all()
    said = "pixels are multiplied by the file's whiteLuminance of 179 cd/m2"
    assert found.assumptions[0] == said


@pytest.mark.parametrize("white", [0.0, -1.0, float("nan"), float("inf")])
def test_an_impossible_white_luminance_is_ignored_with_a_note(white):
    found = read(planes(colours()), whiteLuminance=white)
    assert found.unit == ""
    assert (found.pixels == colours()).all()
    assert "does not give a unit" in found.notes[0]


def test_a_data_window_within_the_display_window_is_a_frame():
    window = {"dataWindow": ((10, 5), (17, 8)), "displayWindow": ((2, 1), (41, 20))}
    found = read(planes(colours()), **window)
    assert found.frame == (8, 4, 40, 20)
    assert (found.pixels == colours()).all()
    found = read(planes(colours()), envmap=OpenEXR.ENVMAP_LATLONG, **window)
    assert found.frame is None  # a map is its whole data window: ImfEnvmap.h


def test_a_data_window_is_cut_to_the_display_window():
    found = read(planes(colours()), displayWindow=((2, 1), (5, 2)))
    assert (found.pixels == colours()[1:3, 2:6]).all()
    assert found.frame is None
    found = read(planes(colours()), displayWindow=((-3, 2), (5, 9)))
    assert (found.pixels == colours()[2:, :6]).all()
    assert found.frame == (3, 0, 9, 8)
    data = made(planes(colours()), displayWindow=((8, 0), (15, 3)))
    assert "no pixels in its display window" in refused(data)


def chroma_file(luminance):
    """Return luminance and subsampled chroma, which the package cannot write."""
    height, width = luminance.shape
    sampled = (("BY", 2), ("RY", 2), ("Y", 1))
    channels = b"".join(
        label.encode() + b"\0" + struct.pack("<i4x2i", 2, each, each) for label, each in sampled
    )
    attributes = {
        ("channels", "chlist"): channels + b"\0",
        ("compression", "compression"): b"\0",
        ("dataWindow", "box2i"): struct.pack("<4i", 0, 0, width - 1, height - 1),
        ("displayWindow", "box2i"): struct.pack("<4i", 0, 0, width - 1, height - 1),
        ("lineOrder", "lineOrder"): b"\0",
        ("pixelAspectRatio", "float"): struct.pack("<f", 1),
        ("screenWindowCenter", "v2f"): bytes(8),
        ("screenWindowWidth", "float"): struct.pack("<f", 1),
    }
    header = b"v/1\x01\x02\0\0\0"
    for (label, kind), value in attributes.items():
        header += f"{label}\0{kind}\0".encode() + struct.pack("<i", len(value)) + value
    header += b"\0"
    rows = []
    for y, row in enumerate(luminance):
        chroma = b"" if y % 2 else bytes(2 * 4 * (width // 2))
        data = chroma + row.astype("<f4").tobytes()
        rows.append(struct.pack("<2i", y, len(data)) + data)
    starts = np.cumsum([len(header) + 8 * height, *map(len, rows[:-1])])
    return header + starts.astype("<u8").tobytes() + b"".join(rows)


def test_luminance_and_chroma_give_the_luminance():
    grey = colours()[..., 0]
    found = exr.read(chroma_file(grey), "sky.exr")
    assert found.channels == ("Y",)
    assert found.weights == (1.0,)
    assert (found.pixels[..., 0] == grey).all()
    assert found.notes == ("only the luminance is read, not the chroma",)


def test_a_grey_picture_has_one_channel():
    found = read({"Y": colours()[..., 0].copy()})
    assert found.pixels.shape == (4, 8, 1)
    assert found.notes == ()


def test_other_layers_are_ignored():
    other = planes(colours() * 2, ("diffuse.R", "diffuse.G", "diffuse.B"))
    assert (read({**planes(colours()), **other}).pixels == colours()).all()
    assert refused(made(other)) == (
        "sky.exr has neither R, G, B nor Y; it has diffuse.B, diffuse.G, diffuse.R"
    )


def test_a_single_channel_is_read_by_its_name():
    other = planes(colours() * 2, ("diffuse.R", "diffuse.G", "A"))
    file = {**planes(colours()), **other}
    for channel, pixels in (
        ("R", colours()[..., 0]),
        ("diffuse.g", 2 * colours()[..., 1]),
        ("a", 2 * colours()[..., 2]),
    ):
        found = exr.read(made(file), "sky.exr", channel)
        assert (found.pixels[..., 0] == pixels).all()
        assert len(found.channels) == len(found.weights) == found.pixels.shape[2] == 1
        assert found.channels[0].lower() == channel.lower()
    with pytest.raises(ConditionError, match="no channel 'Q'; it has A, B, G, R") as caught:
        exr.read(made(file), "sky.exr", "Q")
    assert caught.value.hint == option("channel", "A")
    with pytest.raises(ConditionError, match=r"neither R, G, B nor Y; it has R") as caught:
        read({"R": colours()[..., 0].copy()})
    assert caught.value.hint == option("channel", "R")


def test_alpha_has_a_note():
    """Colours are premultiplied: Technical Introduction to OpenEXR, alpha."""
    alpha = np.ones((4, 8), np.float32)
    assert read({**planes(colours()), "A": alpha.copy()}).notes == ()
    alpha[0] = 0.5
    found = read({**planes(colours()), "A": alpha})
    assert found.notes[0].startswith("25 % of the pixels have an alpha below 1")
    assert (found.pixels == colours()).all()


def test_of_several_parts_the_first_with_colour_is_read():
    depth = np.zeros((4, 8), np.float32)
    header = {"compression": OpenEXR.ZIPS_COMPRESSION, "type": OpenEXR.scanlineimage}
    parts = [
        OpenEXR.Part(dict(header), {"Y": depth}, "mask"),
        OpenEXR.Part(dict(header), planes(colours()), "beauty"),
        OpenEXR.Part(dict(header), planes(colours() * 2), "left"),
    ]
    file = io.BytesIO()
    OpenEXR.File(parts).write(file)
    data = file.getvalue()
    found = exr.read(data, "sky.exr")
    assert (found.pixels == colours()).all()
    assert found.notes == ("part 2 ('beauty') of 3 is read: the first with R, G, B",)
    # the library omits a part that it cannot decode, and the others move up
    broken = bytearray(data)
    start = struct.unpack_from("<Q", data, first_table(data, 3))[0]
    broken[start + 8 : start + 12] = struct.pack("<i", 1)
    assert "damaged" in refused(broken)


def first_table(data, parts):
    """Return the start of the chunk tables, after the headers and a byte of 0."""
    place = 8
    for _ in range(parts):
        while data[place]:
            place = data.index(b"\0", data.index(b"\0", place) + 1) + 1
            place += 4 + struct.unpack_from("<i", data, place)[0]
        place += 1
    return place + (parts > 1)


def test_a_text_need_not_be_utf_8():
    """The package refuses an owner's name in Latin-1, which does not concern the pixels."""
    data = made(planes(colours()), owner="J. Muller").replace(b"J. Muller", b"J. M\xfcller")
    assert (exr.read(data, "sky.exr").pixels == colours()).all()


def test_a_deep_picture_is_refused():
    samples = np.empty((2, 2), object)
    for place in np.ndindex(2, 2):
        samples[place] = np.ones(2, np.float32)
    data = made({"R": samples}, type=OpenEXR.deepscanline, compression=OpenEXR.ZIPS_COMPRESSION)
    assert "is deep" in refused(data)


def test_sizes_beyond_the_file_are_refused():
    data = made(planes(colours()))
    wide = struct.pack("<4i", 0, 0, 65535, 3)
    many = struct.pack("<4i", 0, 0, 65535, 65535)
    high = struct.pack("<4i", 0, 0, 7, 65535)
    assert "its pixels cannot be read" in refused(edited(data, "dataWindow", wide))
    assert "65536 x 65536 pixels, more than" in refused(edited(data, "dataWindow", many))
    assert "its pixels cannot be read" in refused(edited(data, "dataWindow", high))
    assert "65536 x 65536" in refused(edited(data, "displayWindow", many))
    negative = edited(data, "dataWindow", struct.pack("<i", -1), at=8)
    assert refused(negative) == "sky.exr is damaged: its header cannot be read"


def test_sizes_of_tiles_are_limited():
    data = made(planes(colours()), **tiles(16, 16))
    for size in (0, 1 << 31):
        tile = struct.pack("<I", size)
        assert "its header cannot be read" in refused(edited(data, "tiles", tile))
    tile = struct.pack("<2I", 8, 1 << 24)
    assert "tiles of 8 x 16777216 pixels, in 8 x 4 pixels" in refused(edited(data, "tiles", tile))


def test_the_memory_of_channels_is_limited():
    """The library would allocate memory for five channels of 2^23 pixels."""
    data = made(planes(np.ones((1, 1, 5), np.float32), ("R", "G", "B", "A", "Z")))
    window = struct.pack("<4i", 0, 0, (1 << 12) - 1, (1 << 11) - 1)
    assert f"160 MiB of pixels in {len(data)} bytes, more than 128" in refused(
        edited(data, "dataWindow", window)
    )


MEMORY = """
import resource, sys
from radcalc.distributions.maps.pictures import read_picture
from radcalc.errors import ConditionError
before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
try:
    read_picture(sys.argv[1])
except ConditionError as error:
    print(error.message)
after = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
assert after < 2 * before, (before, after)
"""


@pytest.mark.parametrize("compression", ["NO", "ZIP", "PIZ", "DWAB", "HTJ2K256", "ZSTD"])
def test_the_size_in_a_small_file_costs_no_memory(compression, tmp_path):
    """Four channels of 2^23 pixels, 128 MiB, or of 2^28, 4 GiB, in a few hundred bytes."""
    pytest.importorskip("resource")
    packed = getattr(OpenEXR, f"{compression}_COMPRESSION")
    data = made(planes(np.ones((1, 1, 4), np.float32), (*RGB, "A")), compression=packed)
    path = tmp_path / "sky.exr"
    for rows, problem in [(8, "its pixels cannot be read"), (256, "in only")]:
        window = struct.pack("<4i", 0, 0, (1 << 20) - 1, rows - 1)
        path.write_bytes(edited(data, "dataWindow", window))
        command = [sys.executable, "-c", MEMORY, path]
        done = subprocess.run(command, capture_output=True, text=True, check=True)
        assert problem in done.stdout


def test_pixels_are_limited_by_the_bytes_of_the_file():
    """ZIP packs 2^24 equal floats of a channel into a thousandth of their bytes."""
    data = made(
        {"Y": np.zeros((1 << 12, 1 << 12), np.float32)}, compression=OpenEXR.ZIP_COMPRESSION
    )
    assert f"4096 x 4096 pixels in only {len(data)} bytes" in refused(data)


@pytest.mark.parametrize("window", ["dataWindow", "displayWindow"])
def test_a_missing_window_is_refused(window):
    """The library takes 64 x 64 pixels."""
    data = made(planes(colours())).replace(window.encode(), window[:-1].encode() + b"x", 1)
    assert "its header cannot be read" in refused(data)


@pytest.mark.parametrize("name", ["whiteLuminance", exr.WEIGHTS])
@pytest.mark.parametrize("value", ["text", np.ones(2, np.float32)])
def test_an_attribute_of_another_type_is_refused(name, value):
    data = made(planes(colours()), **{name: value})
    assert "its header cannot be read" in refused(data)


def test_a_file_that_ends_early_is_refused():
    data = made(planes(colours(40, 8)))
    table = first_table(data, 1)
    for end in range(8, len(data), 7):
        assert "damaged" in refused(data[:end])
    assert "its pixels cannot be read" in refused(data[:-1])
    unfinished = data[:table] + bytes(24) + data[table + 24 :]
    assert "its pixels cannot be read" in refused(unfinished[:-1])
    # the library finds the chunks without their table
    assert (exr.read(unfinished, "sky.exr").pixels == colours(40, 8)).all()


def test_what_the_library_cannot_decode_is_refused_and_nothing_printed(capfd):
    data = bytearray(made(planes(colours(64, 64))))
    data[len(data) // 2 : len(data) // 2 + 50] = bytes(50)
    assert "its pixels cannot be read" in refused(data)
    assert capfd.readouterr() == ("", "")


@pytest.mark.parametrize("seed", range(60))
def test_a_damaged_file_is_a_picture_or_refused(seed):
    generator = np.random.default_rng(seed)
    data = bytearray(made(planes(colours(20, 20)), envmap=OpenEXR.ENVMAP_LATLONG))
    for _ in range(3):
        data[generator.integers(8, 500)] = generator.integers(256)
    try:
        found = exr.read(bytes(data), "sky.exr")
    except ConditionError:
        return
    assert found.pixels.size <= 1200


@pytest.mark.parametrize(
    "picture",
    [
        Picture(colours(), RGB, (0.2126, 0.7152, 0.0722), "PFM", "cd/m2", "latlong"),
        Picture(colours(), RGB, (0.25, 0.5, 0.25), "PFM", "W/m2/sr"),
        Picture(colours(), ("X", "Y", "Z"), (0.0, 1.0, 0.0), "Radiance RGBE"),
        Picture(colours()[..., :1], ("Y",), (1.0,), "PFM", "lx", "latlong"),
    ],
)
def test_what_is_written_is_read_back(picture, tmp_path):
    path = str(tmp_path / "map.exr")
    write_picture(path, picture)
    found = read_picture(path)
    assert (found.pixels == picture.pixels).all()
    assert found.weights == pytest.approx(picture.weights, abs=1e-7)
    assert (found.unit, found.projection) == (picture.unit, picture.projection)
    assert found.frame is None
    as_read = RGB if picture.channels == ("X", "Y", "Z") else picture.channels
    assert found.channels == as_read


def test_the_package_reads_what_is_written(tmp_path):
    path = str(tmp_path / "map.exr")
    write_picture(
        path, Picture(colours(), RGB, (0.2126, 0.7152, 0.0722), "PFM", "cd/m2", "latlong")
    )
    file = OpenEXR.File(path)
    assert (file.channels()["RGB"].pixels == colours()).all()
    assert file.header()["envmap"] == OpenEXR.ENVMAP_LATLONG
    assert file.header()["whiteLuminance"] == 1


def test_the_message_without_the_package_names_the_command_to_install_it(tmp_path):
    """Run a process in which OpenEXR cannot be imported."""
    path = tmp_path / "sky.exr"
    path.write_bytes(made(planes(colours())))
    program = (
        "import sys; sys.modules['OpenEXR'] = None\n"
        "from radcalc.distributions.maps.pictures import read_picture\n"
        "from radcalc.errors import ConditionError\n"
        "try: read_picture(sys.argv[1])\n"
        "except ConditionError as error: print(error)"
    )
    done = subprocess.run(
        [sys.executable, "-c", program, path], capture_output=True, text=True, check=True
    )
    assert done.stdout == (
        "OpenEXR pictures need the package OpenEXR, which is missing\n"
        "try: pip install 'radcalc[maps]'\n"
    )


@pytest.mark.parametrize("projection", ["latlong", "mirror-ball", "angular", ""])
def test_a_written_map_keeps_its_projection(tmp_path, projection):
    path = str(tmp_path / "map.exr")
    write_picture(path, Picture(colours(8, 8), RGB, (0.2, 0.7, 0.1), "", "cd/m2", projection))
    assert read_picture(path).projection == projection
