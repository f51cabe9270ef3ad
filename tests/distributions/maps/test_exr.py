"""OpenEXR pictures, read and written; files come from the package OpenEXR."""

import io
import struct
import subprocess
import sys

import numpy as np
import OpenEXR
import OpenImageIO
import pytest

from radcalc.distributions.maps import exr
from radcalc.distributions.maps.pictures import Picture, read_picture, write_picture
from radcalc.errors import ConditionError, Try, add

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
    assert "environment map of an unknown kind" in refused(
        made(planes(colours()), envmap="latlong")
    )


def test_whole_numbers_are_refused():
    """OpenImageIO scales them by 2^-32, OpenEXR's own interface does not."""
    data = made(planes(colours().astype(np.uint32)))
    assert refused(data) == "sky.exr has whole numbers (UINT) in R, whose scale is unknown"


def test_attributes_of_shape_have_a_note():
    found = read(planes(colours()), pixelAspectRatio=2.0, Orientation=3)
    assert found.notes == (
        "sky.exr has pixelAspectRatio=2.0, but its pixels are read as square",
        "sky.exr has Orientation=3, but its pixels are not turned",
    )
    assert read(planes(colours()), pixelAspectRatio=1.0, Orientation=1).notes == ()


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


# The linear spaces: ASWF Color Interop Forum, Color Space Encodings for Texture Assets, 1.1.0.
D60, D65 = (0.32168, 0.33767), (0.3127, 0.3290)
SPACES = {
    "lin_ap1_scene": ((0.713, 0.293), (0.165, 0.830), (0.128, 0.044), D60),
    "lin_ap0_scene": ((0.7347, 0.2653), (0.0, 1.0), (0.0001, -0.0770), D60),
    "lin_rec709_scene": ((0.640, 0.330), (0.300, 0.600), (0.150, 0.060), D65),
    "lin_p3d65_scene": ((0.680, 0.320), (0.265, 0.690), (0.150, 0.060), D65),
    "lin_rec2020_scene": ((0.708, 0.292), (0.170, 0.797), (0.131, 0.046), D65),
    "lin_adobergb_scene": ((0.640, 0.330), (0.210, 0.710), (0.150, 0.060), D65),
}
ENCODED = [
    "srgb_rec709_scene",
    "g24_rec709_scene",
    "g22_rec709_scene",
    "g18_rec709_scene",
    "srgb_ap1_scene",
    "g22_ap1_scene",
    "srgb_p3d65_scene",
    "g22_adobergb_scene",
    "srgb_rec709_display",
    "g24_rec709_display",
    "srgb_p3d65_display",
    "srgbe_p3d65_display",
    "pq_p3d65_display",
    "pq_rec2020_display",
    "hlg_rec2020_display",
    "g22_rec709_display",
    "g22_adobergb_display",
    "g26_p3d65_display",
    "g26_xyzd65_display",
    "pq_xyzd65_display",
    "sRGB",
]


def luminances(pixels, red, green, blue, white):
    """Luminance of R, G, B by the matrix of the primaries: R = G = B = 1 is the white of Y = 1."""
    columns = np.array(
        [[x / y, 1, (1 - x - y) / y] if y else [0, 0, 0] for x, y in (red, green, blue)]
    )
    x, y = white
    scales = np.linalg.solve(columns.T, [x / y, 1, (1 - x - y) / y])
    return pixels.astype(float) @ scales


def by_openimageio(path, pixels, space, **attributes):
    """Write pixels in a colour space with OpenImageIO."""
    spec = OpenImageIO.ImageSpec(*pixels.shape[1::-1], pixels.shape[2], "float")
    if space:
        spec.attribute("oiio:ColorSpace", space)
    for name, value in attributes.items():
        kind = "float[8]" if name == "chromaticities" else "string"
        spec.attribute(name, kind, value)
    file = OpenImageIO.ImageOutput.create(str(path))
    assert file.open(str(path), spec), file.geterror()
    assert file.write_image(pixels)
    assert file.close()
    return path.read_bytes()


@pytest.mark.parametrize("space", SPACES)
def test_the_luminance_is_that_of_the_colour_space(space, tmp_path):
    data = by_openimageio(tmp_path / "sky.exr", colours(), space)
    found = exr.read(data, "sky.exr")
    expected = luminances(colours(), *SPACES[space])
    assert found.pixels @ found.weights == pytest.approx(expected, rel=1e-5)
    assert found.assumptions == (f"the file's colour space is {space}",)
    flat = sum(SPACES[space], ())
    both = by_openimageio(tmp_path / "sky.exr", colours(), space, chromaticities=flat)
    assert exr.read(both, "sky.exr").weights == pytest.approx(found.weights, abs=1e-6)
    other = ACES if space != "lin_ap0_scene" else sum(SPACES["lin_rec709_scene"], ())
    contradictory = by_openimageio(tmp_path / "sky.exr", colours(), space, chromaticities=other)
    assert "contradicts itself: the chromaticities are not" in refused(contradictory)


def test_the_colour_space_decides_the_luminance_of_red(tmp_path):
    """0.5 times the luminance of red: 0.2722, 0.2627 and 0.3440 (ACES, ITU-R BT.2020)."""
    red = np.zeros((8, 16, 3), np.float32)
    red[..., 0] = 0.5
    for space, luminance in (
        ("ACEScg", 0.1361),
        ("lin_rec2020_scene", 0.1314),
        ("lin_ap0", 0.1720),
    ):
        found = exr.read(by_openimageio(tmp_path / "red.exr", red, space), "red.exr")
        assert found.pixels[0, 0] @ found.weights == pytest.approx(luminance, abs=5e-5)


@pytest.mark.parametrize("space", ENCODED)
def test_an_encoded_picture_is_refused(space, tmp_path):
    for count in (1, 3):
        data = by_openimageio(tmp_path / "sky.exr", colours()[..., :count].copy(), space)
        assert "its pixels are encoded for display" in refused(data)
    with pytest.raises(ConditionError, match="encoded for display"):
        exr.read(data, "sky.exr", "R")


@pytest.mark.parametrize(
    "space", ["ocio:lin_ciexyzd65_display", "studio:lin_ap1_scene", "lin_awg3"]
)
def test_an_unknown_colour_space_is_refused(space, tmp_path):
    data = by_openimageio(tmp_path / "sky.exr", colours(), "", colorInteropID=space)
    said = f"sky.exr is in the colour space '{space}', which OpenEXR does not know"
    assert refused(data) == said
    with pytest.raises(ConditionError, match="does not know"):
        exr.read(data, "sky.exr", "G")


@pytest.mark.parametrize("space", ["unknown", ""])
def test_without_a_colour_space_the_primaries_decide(space):
    found = read(planes(colours()), colorInteropID=space)
    assert found.weights == (0.2126, 0.7152, 0.0722)
    assert "as the file declares none" in found.assumptions[0]
    found = read(planes(colours()), colorInteropID=space, chromaticities=ACES)
    assert found.weights == pytest.approx(ACES_WEIGHTS, abs=1e-6)


def test_data_are_no_colours():
    """A renderer may write normals as R, G and B; a single channel has no colour."""
    data = made(planes(colours()), colorInteropID="data")
    assert refused(data) == "sky.exr has data, not colours: its colorInteropID is data"
    assert (exr.read(data, "sky.exr", "G").pixels[..., 0] == colours()[..., 1]).all()
    assert "data, not colours" in refused(
        made({"Y": colours()[..., 0].copy()}, colorInteropID="data")
    )
    layer = made(planes(colours(), ("n.R", "n.G", "n.B")), colorInteropID="data")
    with pytest.raises(ConditionError, match="data, not colours"):
        exr.read(layer, "sky.exr", "n")


def test_a_container_of_aces_has_its_primaries():
    """SMPTE ST 2065-4: the flag is 1, and R, G, B are of AP0."""
    for header in ({}, {"chromaticities": ACES}, {"colorInteropID": "lin_ap0_scene"}):
        found = read(planes(colours()), acesImageContainerFlag=1, **header)
        assert found.weights == pytest.approx(ACES_WEIGHTS, abs=1e-6)
    for header in (
        {"acesImageContainerFlag": 1, "colorInteropID": "lin_ap1_scene"},
        {"acesImageContainerFlag": 1, "chromaticities": sum(SPACES["lin_ap1_scene"], ())},
        {"acesImageContainerFlag": 2},
    ):
        assert "contradicts itself: acesImageContainerFlag" in refused(
            made(planes(colours()), **header)
        )


OF_XYZ, OF_AP1 = {"colorInteropID": "lin_ciexyzd65_scene"}, {"colorInteropID": "lin_ap1_scene"}


@pytest.mark.parametrize(
    ("names", "header", "contradictions"),
    [
        (("X", "Y", "Z"), {}, [OF_AP1, {"chromaticities": ACES}]),
        (("X", "Y", "Z"), OF_XYZ, [{"chromaticities": ACES}]),
        (RGB, OF_XYZ, [{"chromaticities": ACES}]),
        (RGB, {"chromaticities": exr.XYZ_PRIMARIES}, [OF_AP1]),
    ],
)
def test_of_x_y_z_the_second_is_the_luminance(names, header, contradictions):
    found = read(planes(colours(), names), **header)
    assert (found.channels, found.weights) == (names, (0.0, 1.0, 0.0))
    for other in contradictions:
        data = made(planes(colours(), names), **header, **other)
        assert refused(data).startswith("sky.exr contradicts itself: ")


def test_own_weights_contradict_another_colour_space():
    """A program may have converted the pixels and kept the attributes that it does not know."""
    own = {exr.WEIGHTS: np.array((0.25, 0.5, 0.25), np.float32)}
    assert read(planes(colours()), **own).weights == (0.25, 0.5, 0.25)
    data = made(planes(colours()), colorInteropID="lin_ap1_scene", **own)
    assert "its radcalcWeights and its colorInteropID lin_ap1_scene differ" in refused(data)


def test_the_colour_space_of_the_first_part_is_that_of_all():
    """Identifying the Color Space of OpenEXR Files: it need only be set in the first header."""
    header = {"compression": OpenEXR.ZIPS_COMPRESSION, "type": OpenEXR.scanlineimage}
    first = {**header, "colorInteropID": "lin_ap0_scene"}
    depth = np.zeros((4, 8), np.float32)
    for own, weights in (({}, ACES_WEIGHTS), ({"colorInteropID": "lin_rec709_scene"}, None)):
        file = io.BytesIO()
        parts = [
            OpenEXR.Part(dict(first), {"Z": depth}, "depth"),
            OpenEXR.Part({**header, **own}, planes(colours()), "beauty"),
        ]
        OpenEXR.File(parts).write(file)
        found = exr.read(file.getvalue(), "sky.exr")
        assert found.weights == pytest.approx(weights or (0.2126, 0.7152, 0.0722), abs=1e-4)


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


def test_a_layer_is_read_by_its_name():
    other = planes(colours() * 2, ("diffuse.R", "diffuse.G", "diffuse.B"))
    file = made({**planes(colours()), **other, "spot.Y": colours()[..., 0].copy()})
    assert (exr.read(file, "sky.exr").pixels == colours()).all()
    found = exr.read(file, "sky.exr", "Diffuse")
    assert (found.pixels == 2 * colours()).all()
    assert (found.channels, found.weights) == (RGB, (0.2126, 0.7152, 0.0722))
    assert found.assumptions[0] == "the layer Diffuse"
    assert exr.read(file, "sky.exr", "spot").channels == ("Y",)
    with pytest.raises(ConditionError) as caught:
        read({**other, "spot.Y": colours()[..., 0].copy()})
    assert caught.value.message == (
        "sky.exr has neither R, G, B nor Y; it has diffuse.B, diffuse.G, diffuse.R, spot.Y"
    )
    assert caught.value.tries == (add("channel", "diffuse"), add("channel", "spot"))


@pytest.mark.parametrize(
    "names", [(".R", ".G", ".B"), ("r", "g", "b"), (".r", ".g", ".b"), ("Red", "Green", "Blue")]
)
def test_channels_without_a_layer_are_the_picture(names):
    found = read({**planes(colours(), names), "n.R": colours()[..., 0].copy()})
    assert (found.pixels == colours()).all()
    assert found.channels == RGB


def test_vectors_are_no_luminance():
    """A motion has X and Y, a normal X, Y and Z in a layer of its own."""
    motion = planes(colours()[..., :2], ("X", "Y"))
    normal = planes(colours(), ("n.X", "n.Y", "n.Z"))
    for channels, wanted in ((motion, ""), (normal, ""), (normal, "n")):
        with pytest.raises(ConditionError, match=r"neither R, G, B nor Y|no channel 'n'"):
            exr.read(made(channels), "sky.exr", wanted)


def test_a_part_is_read_by_its_name():
    header = {"compression": OpenEXR.ZIPS_COMPRESSION, "type": OpenEXR.scanlineimage}
    parts = [
        OpenEXR.Part(dict(header), planes(colours() * k), name)
        for k, name in ((1, "left"), (2, "right"))
    ]
    file = io.BytesIO()
    OpenEXR.File(parts).write(file)
    found = exr.read(file.getvalue(), "sky.exr", "right")
    assert (found.pixels == 2 * colours()).all()
    assert found.notes == ()


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
    assert caught.value.tries == (Try(without=("channel",)),)
    for names, proposed in (("R", ()), (("Blue", "Red"), ()), (("B", "Z"), (add("channel", "Z"),))):
        with pytest.raises(ConditionError, match=r"neither R, G, B nor Y; it has") as caught:
            read(planes(colours(), names))
        assert caught.value.tries == proposed  # a colour alone is no radiance


def test_alpha_has_a_note():
    """Colours are premultiplied: Technical Introduction to OpenEXR, alpha."""
    alpha = np.ones((4, 8), np.float32)
    assert read({**planes(colours()), "A": alpha.copy()}).notes == ()
    alpha[0] = 0.5
    found = read({**planes(colours()), "A": alpha})
    assert found.notes[0].startswith("25 % of the pixels have an alpha below 1")
    layer = planes(colours(), ("n.R", "n.G", "n.B"))
    assert exr.read(made({**layer, "A": alpha}), "sky.exr", "n").notes == ()
    found = exr.read(made({**layer, "n.A": alpha}), "sky.exr", "n")
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


def with_attributes(data, attributes):
    """A file of one part with more attributes before the others; its pixels move."""
    end = first_table(data, 1)
    chunks = np.frombuffer(data, "<u8", 1, end) + len(attributes)
    return data[:8] + attributes + data[8:end] + chunks.tobytes() + data[end + 8 :]


def test_a_long_header_is_refused_before_the_library_reads_it(monkeypatch):
    """The library's time grows with the square of the number of attributes."""
    data = made(planes(colours()))
    numbers = b"".join(b"a%d\0int\0" % k + struct.pack("<2i", 4, k) for k in range(5000))
    text = b"text\0string\0" + struct.pack("<i", 1 << 20) + b"x" * (1 << 20)
    few, short = numbers[: numbers.index(b"a4000\0")], text[:12] + struct.pack("<i", 9) + b"x" * 9
    for attributes in (few, short):
        found = exr.read(with_attributes(data, attributes), "sky.exr")
        assert (found.pixels == colours()).all()
    monkeypatch.setattr(exr, "_opened", None)
    for attributes in (numbers, text):
        assert refused(with_attributes(data, attributes)) == (
            "the header of sky.exr has more than 1 MiB or 4096 attributes"
        )
    assert "its header cannot be read" in refused(data[:8] + text[:-1])


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
