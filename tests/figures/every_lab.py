#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What all labs have in common: every_lab.py TEST PROGRAM, where TEST is one of the functions test_… below. Each is asked of each lab."""
import collections
import itertools
import json
import os
import pathlib
import re
import shutil
import sys
import tempfile

sys.dont_write_bytecode = True
import labs

PROGRAM = sys.argv[2]
NAME = pathlib.Path(PROGRAM).name
ROOT = pathlib.Path(__file__).resolve().parents[2]
PARAMETERS = labs.parameters(PROGRAM)
NUMBERS = [parameter for parameter in PARAMETERS if parameter["type"] in ("number", "integer")]


def expect(holds, *why):
    if not holds:
        raise AssertionError(" ".join(map(str, why)))


def flag(parameter):
    return "--" + parameter["name"].replace("_", "-")


def choices(parameter):
    return ["on", "off"] if parameter["type"] == "toggle" else [choice["name"] for choice in parameter["choices"]]


def initial(parameter):
    value = parameter["default"]
    return ("on" if value else "off") if isinstance(value, bool) else str(value)


def number(value):
    """As the labs print it: 5 for 5.0."""
    return str(float(value)).removesuffix(".0")


def ran(*arguments, env=None, cwd=None):
    said = labs.run(PROGRAM, *arguments, env=env, cwd=cwd)
    expect(said.returncode == 0 and said.stderr == "", said.stderr)
    return said.stdout


def snapshot(path, *arguments, env=None, cwd=None):
    expect(ran("--size", "160x120", "--snapshot", path, *arguments, env=env, cwd=cwd) == "")
    return path.read_bytes()


def draw(shots, folder, env=None):
    expect(labs.draw(PROGRAM, shots, folder, env=env) == "", "a batch says something")


def shot(name, settings=None, view="color", size="128x128"):
    return {"name": name, "set": settings or {}, "view": view, "size": size}


# ---- What a lab says of itself: the contract with people, scripts and the grader.


def test_parameters_follow_the_contract(_):
    expect(PARAMETERS)
    expect(len({p["name"] for p in PARAMETERS}) == len(PARAMETERS), "one is named twice")
    for p in PARAMETERS:
        has_range, has_choices = p["type"] in ("number", "integer"), p["type"] in ("choice", "file")
        expect(p["help"] and initial(p) and (has_range or has_choices or p["type"] == "toggle"), p)
        expect(has_range == (p["min"] is not None and p["min"] < p["max"]), p)
        expect(has_choices == bool(p["choices"]), p)
        expect(has_range or choices(p).count(initial(p)) == 1, p)
    expect(any(p["name"] == "method" for p in PARAMETERS), "every technique has several ways")


def test_views_begin_with_color(_):
    views = labs.views(PROGRAM)
    expect(len(views) >= 2 and views[0] == "color" and len(set(views)) == len(views), views)
    expect(set(views) <= {"color", "normal", "tangent", "texcoord", "direction", "lod", "depth", "mask", "error"}, views)


def test_help_explains_every_option(_):
    said = ran("--help")
    expect(all(len(line) <= 80 for line in (said + ran("--list-parameters")).splitlines()), "a terminal has 80 columns")
    for p in PARAMETERS:
        for part in [flag(p) + " "] + [choice["name"] + ": " for choice in p["choices"]]:
            expect(part in said, part)
    for option in ("--snapshot --view --batch --out --stats --mesh --frames --config --save-config --context --assets --size "
                   "--list-parameters --list-views").split():
        expect(option in said, option)
    said = ran("--list-parameters")
    for p in PARAMETERS:
        expect(f"{flag(p)} ({p['type']}" in said, flag(p))


def test_shaders_are_printed_with_the_origin_of_each_constant_and_uniform(_):
    said = ran("--print-shader", "--size", "64x64")
    expect(f"// ---- shaders/{NAME[3:]}/" in said and "#line " not in said, said)
    flags, counts = {flag(p) for p in PARAMETERS}, collections.Counter()
    for line in said.splitlines():
        _, _, origin = line.rpartition("  // ") if "  // " in line else ("", "", "")
        of = re.split("[ :]", origin)[0]
        if line.startswith("#define ") and of.startswith("--"):
            expect(of in flags | {"--view"}, line)
            counts["constants"] += 1
        if line.startswith("uniform "):
            of_the_lab = origin == "set in the lab's draw()"
            expect(of_the_lab or of in flags, line)
            counts["of the lab" if of_the_lab else "of parameters"] += 1
    expect(counts["constants"] > 1 and counts["of parameters"] > 0, counts)


def objects():
    """What the default look shows: the eight materials of lab 3's ship, lab 7's five spheres and what surrounds them, the ball of labs 8
    and 9 and what it mirrors; else one object."""
    return {"lab03": 8, "lab07": 6, "lab08": 2, "lab09": 2}.get(NAME[:5], 1)


def test_only_what_the_scene_needs_is_there(_):
    for view in labs.data_views(PROGRAM):
        stats = json.loads(ran("--stats", "-", "--size", "128x128", "--view", view))
        expect(not stats["warnings"], view, stats["warnings"])
    stats = json.loads(ran("--stats", "-", "--size", "128x128"))
    expect("lab" + stats["lab"] == NAME and stats["renderer"] and stats["version"], stats)
    # A warning names what is uploaded, bound or declared and not read, and what is read and not there.
    expect(not stats["warnings"], stats["warnings"])
    expect(stats["vertices"] >= 3 and stats["triangles"] >= 1 and 1 <= stats["draw_calls"] <= objects(), stats)
    positions = [attribute["name"] for attribute in stats["attributes"]].count("position")
    expect(1 <= positions <= stats["draw_calls"] and stats["textures"] and stats["peak_bytes"] > 1e6, stats)
    expect(all(attribute["bytes"] > 0 for attribute in stats["attributes"]), stats)
    expect(stats["index_bytes"] > 0 and stats["index_bytes"] <= 4 * 3 * stats["triangles"], stats)
    for texture in stats["textures"]:
        expect(min(texture["width"], texture["height"], texture["bytes"]) > 0 and texture["format"], texture)
    times = stats["milliseconds"]
    expect(min(times.values()) >= 0 and all(times[stage] > 0 for stage in
           ("start", "loader", "context", "decode", "compile", "first_draw", "total", "draw")), times)
    whole = sum(time for stage, time in times.items() if stage not in ("total", "draw"))  # all time is somebody's
    expect(abs(whole - times["total"]) < 1e-6, times)


# ---- Bad input gives one clear line, the right exit code, and no file.


def expect_error(said, code, parts):
    expect(said.returncode == code and said.stdout == "" and re.fullmatch(rf"{NAME}: .*\n", said.stderr), said.returncode, said.stdout, said.stderr)
    for part in parts:
        expect(part in said.stderr, part, "is not said:", said.stderr)


def test_range_and_unit_of_each_number_are_named(folder):
    def expect_refused(p, value, *parts):
        expect_error(labs.run(PROGRAM, "--snapshot", folder / "a.png", flag(p), value), 2, [flag(p), *parts])
        expect(not any(folder.iterdir()))

    for p in PARAMETERS:
        if p in NUMBERS:
            unit = " " + p["unit"] if p["unit"] else ""
            for value in (number(2 * p["max"] + 1), "abc", "nan", "1e999"):
                expect_refused(p, value, f"from {number(p['min'])} to {number(p['max'])}{unit}", f"'{value}'")
        elif p["type"] == "choice":
            expect_refused(p, choices(p)[0] + "x", choices(p)[-1], f"did you mean '{choices(p)[0]}'?")
        elif p["type"] == "toggle":
            expect_refused(p, "maybe", "on or off", "'maybe'")


def test_a_full_device_is_named_and_stays(folder):
    # By a link, so that a program that puts a file in the device's place only loses the link.
    full = folder / "full"
    full.symlink_to("/dev/full")
    for option in ("--stats", "--save-config"):
        expect_error(labs.run(PROGRAM, option, full), 3, ["full", "No space"])
        expect(full.is_char_device(), option)


def test_a_mistake_in_a_shader_is_named_with_file_and_line(folder):
    shutil.copytree(ROOT / "shaders", folder / "shaders")
    (folder / "assets").symlink_to(ROOT / "assets")
    own = {ending: sorted((folder / "shaders" / NAME[3:]).glob("*" + ending)) for ending in (".frag", ".vert", ".glsl")}
    # A step that a student writes, where the lab has one in a file of its own, and what all labs share.
    included = own[".glsl"][:1] + [folder / "shaders/lib/picture.glsl"]
    for file, mistake, message in [(own[".frag"][0], "void broken( {", "syntax error"),
                                   (own[".vert"][0], "vec3 broken() { return vec2(1.0); }", "vec3"),
                                   *((file, "float broken() { return nothing; }", "nothing") for file in included)]:
        good = file.read_text(encoding="utf-8")
        file.write_text(good + mistake + "\n", encoding="utf-8")
        said = labs.run(PROGRAM, "--size", "32x32", "--snapshot", folder / "a.png", env={"TEXEL_ROOT": str(folder)})
        file.write_text(good, encoding="utf-8")
        place = f"{NAME}: {file.relative_to(folder)}:{good.count(chr(10)) + 1}:"
        expect(said.returncode == 3 and said.stdout == "" and said.stderr.startswith(place) and message in said.stderr, place, said.stderr)
        expect(not (folder / "a.png").exists())


# ---- Every value and every view draws something.


def covered(picture):
    """Share of the pixels that are not the colour of the empty picture (app/canvas.cpp, 0.035 0.042 0.055 in linear light)."""
    return 1 - picture.pixels().count((53, 58, 66)) / (picture.width * picture.height)


def test_every_value_of_every_choice_shows_something(folder):
    shots = [shot("default.png")] + [shot(f"{p['name']}={value}.png", {p["name"]: value}) for p in PARAMETERS if p not in NUMBERS
                                     for value in choices(p) if value != initial(p)]
    draw(shots, folder)
    for one in shots:
        picture = labs.Picture(folder / one["name"])
        colours = len(set(picture.pixels()))
        # The least is the alligator of lab 5, long and flat: 6 %. A 1x1 texture on a square leaves two colours, the square and the
        # ground, where the driver has one sample a pixel.
        expect(covered(picture) > 0.05 and colours >= (2 if "1x1" in one["name"] else 3), one["name"], covered(picture), colours)
        # 128x128 pixels of texture or light: measured 1200 and more in the first nine labs.
        expect(one["name"] != "default.png" or colours > 500, colours)


def test_every_view_shows_finite_values(folder):
    methods = [value for p in PARAMETERS if p["name"] == "method" for value in choices(p) if value != initial(p)]
    views = labs.data_views(PROGRAM)
    # The methods that fail somewhere are there to show it: they are drawn, no more.
    draw([shot(f"{view}.pfm", view=view) for view in views] +
         [shot(f"{view} by {method}.pfm", {"method": method}, view, "64x64") for view in views for method in methods], folder)
    mask = [pixel[0] for pixel in labs.Picture(folder / "mask.pfm").pixels()]
    expect(set(mask) == {0, 1} and sum(mask) > len(mask) / 10, set(mask))
    for view in views:
        picture = labs.Picture(folder / f"{view}.pfm")
        expect(picture.non_finite() == 0, view)
        # Lab 7 is about what surrounds the objects: its views show that too.
        surrounded = NAME == "lab07_environment"
        expect(surrounded or not any(any(pixel) for pixel, inside in zip(picture.pixels(), mask) if not inside), view, "is not 0 beside the object")
        if view in ("normal", "tangent", "direction"):
            lengths = [sum(x * x for x in pixel) ** 0.5 for pixel, inside in zip(picture.pixels(), mask) if inside or surrounded]
            # normalize() in float32: measured 2e-7 off.
            expect(all(abs(length - 1) < 1e-6 for length in lengths), view)


HARD_LOOKS = {  # that no single parameter at its end would give
    "lab01_texture_quad": [{"tilt": "89", "texture_scale": "100"}, {"texture": "hard_1x1"}],
    "lab05_normal_map": [{"model": "torus"}, {"model": "sphere", "pitch": "89"}],
    "lab06_cube_map": [{"mapping": "sphere-2d"}, {"mapping": "sphere-2d", "turn": "180", "tilt": "90"},
                       {"mapping": "sphere-2d", "turn": "180", "yaw": "10"}, {"mapping": "sphere-2d", "rings": "2", "segments": "3"}],
    "lab07_environment": [{"near": "1e-5", "far": "1000"}, {"near": "2", "far": "20"}],
    "lab08_reflection": [{"rings": "2", "segments": "3"}, {"stretch": "4", "tilt": "30"}, {"distance": "0.5", "surface": "refraction"}],
    "lab09_bump": [{"tilt": "90", "bump_strength": "100"}, {"tilt": "-90", "bump_strength": "0"},
                   {"turn": "180", "bump_strength": "100", "repeats": "64"}],
}


def expect_finite(shots, folder):
    draw(shots, folder)
    for one in shots:
        expect(not one["name"].endswith(".pfm") or labs.Picture(folder / one["name"]).non_finite() == 0, one)


def test_no_end_of_a_range_makes_the_default_method_draw_a_nan(folder):
    looks = HARD_LOOKS.get(NAME, []) + [{p["name"]: number(p[end])} for p in NUMBERS for end in ("min", "max")]
    shots = [shot(f"{view}_{i}.pfm", look, view, "64x64") for view in labs.data_views(PROGRAM) for i, look in enumerate(looks)]
    expect(len(shots) >= 30, "a lab of one choice and one number, and the camera, has as many")
    expect_finite(shots, folder)


def test_extreme_settings_are_drawn_at_every_size(folder):
    # Seen along the surface, a square is a line; the footprint of a pixel then has no end.
    looks = [{"yaw": yaw, "pitch": pitch} for yaw in ("89.9", "90", "90.001") for pitch in ("0", "45")]
    if NAME == "lab01_texture_quad":
        looks = [{**look, "method": "anisotropic", "texture_scale": "100", "tilt": "30"} for look in looks]
    # All numbers at once at their ends; what a lab calls too little or too much is its error to tell.
    looks += [{p["name"]: number(p[end]) for p in NUMBERS if p["name"] not in ("near", "far", "segments")} for end in ("min", "max")]
    shots = []
    for i, look in enumerate(looks):  # in colour at the sizes at which triangles once were lines, and in every data view at odd ones
        shots += [shot(f"{i}_{size}.png", look, size=size) for size in ("512x512", "960x720", "37x53")]
        shots += [shot(f"{i}_{view}_{size}.pfm", look, view, size) for view in labs.data_views(PROGRAM) for size in ("128x128", "37x53")]
    expect_finite(shots, folder)


# ---- A picture depends on its parameters alone: not on the run, the working directory, the number of threads or how it was asked for.


def test_every_run_on_every_renderer_draws_the_same(folder):
    first = snapshot(folder / "first.png")
    for env, cwd in (({"LP_NUM_THREADS": "0"}, "/"),
                     # A locale with decimal commas, where the machine has one, and a home that cannot be written.
                     ({"LP_NUM_THREADS": "4", "TEXEL_THREADS": "1", "LC_ALL": "de_DE.UTF-8", "HOME": "/dev/null"}, None),
                     ({"LP_NATIVE_VECTOR_WIDTH": "128"}, None)):  # as on a processor with shorter vectors
        expect(snapshot(folder / "other.png", env=env, cwd=cwd) == first, env)
    said = labs.run(PROGRAM, "--size", "160x120", "--snapshot", folder / "osmesa.png", "--context", "osmesa")
    if said.returncode == 0:  # Mesa has none since 25.1
        expect((folder / "osmesa.png").read_bytes() == first, "osmesa")
    else:
        expect("libOSMesa" in said.stderr, said.stderr)
    snapshot(folder / "egl.png", "--context", "egl")
    pairs = zip(labs.Picture(folder / "first.png").samples, labs.Picture(folder / "egl.png").samples, strict=True)
    # Both are the same rasteriser; measured 0 in all labs.
    expect(max(abs(a - b) for a, b in pairs) <= 1)


def test_shaders_that_are_quick_to_compile_or_to_draw_give_the_same(folder):
    shots = [shot(f"{value}.png", {"method": value}, size="64x48") for p in PARAMETERS if p["name"] == "method" for value in choices(p)]
    shots += [shot(f"{view}.pfm", view=view, size="64x48") for view in labs.data_views(PROGRAM)]
    draw(shots, folder)
    plain = {one["name"]: (folder / one["name"]).read_bytes() for one in shots}
    draw(shots, folder, env={"GALLIVM_PERF": "no_aos_sampling"})
    for one in shots:
        expect((folder / one["name"]).read_bytes() == plain[one["name"]], one)


def other_values():
    """Values that are not the defaults, one of each type that the lab has."""
    settings, types = {}, set()
    for p in PARAMETERS:
        if p["type"] in types or p["name"] == "model":
            continue
        types.add(p["type"])
        # Of numbers sixteenths: the same as text, in TOML and in JSON.
        settings[p["name"]] = (number(2 * (5 * p["min"] + 3 * p["max"]) // 1 / 16) if p["type"] == "number" else
                               number(p["max"]) if p["type"] == "integer" else next(value for value in choices(p) if value != initial(p)))
    return settings


def test_flags_config_and_batch_draw_the_same(folder):
    settings = other_values()
    by_flags, by_default = snapshot(folder / "flags.png", *labs.flags(settings)), snapshot(folder / "default.png")
    expect(by_flags != by_default)
    # The file's text says of "--method nearest --tilt 80": "method=nearest tilt=80".
    expect(labs.texts(by_flags)["Parameters"] == " ".join(f"{name}={value}" for name, value in settings.items()), labs.texts(by_flags))
    look, again = folder / "look.toml", folder / "again.toml"
    ran("--save-config", look, *labs.flags(settings))
    expect(snapshot(folder / "other.png", "--config", look) == by_flags, "config")
    defaults = {p["name"]: initial(p) for p in PARAMETERS if p["name"] in settings}
    expect(snapshot(folder / "other.png", "--config", look, *labs.flags(defaults)) == by_default, "a flag goes before the file")
    ran("--config", look, "--save-config", again)
    expect(look.read_bytes() == again.read_bytes(), "what was read is written again as it was")
    # Each picture of a batch starts from the defaults.
    draw([shot("b1.png", settings, size="160x120"), shot("b2.png", size="160x120")], folder)
    expect((folder / "b1.png").read_bytes() == by_flags and (folder / "b2.png").read_bytes() == by_default, "batch")


def test_an_error_is_that_of_its_own_truth_whatever_was_drawn_before(folder):
    """A small object, seen from many sides: what another look has in few pixels only must not pass for its own."""
    known = {"model": "sphere", "cube_map": "smooth", "distance": "100"}  # have an exact answer
    far = {p["name"]: known[p["name"]] for p in PARAMETERS if p["name"] in known}
    turned = [{p["name"]: "35"} for p in PARAMETERS if p["unit"] == "degrees" and p["max"] >= 35]
    looks = [far, *({**far, **one} for one in turned), far]
    shots = [shot(f"{i}.pfm", look, view="error") for i, look in enumerate(looks)]
    draw(shots, folder)
    for one in shots[1:-1]:
        alone = folder / "alone.pfm"
        ran("--snapshot", alone, "--size", one["size"], "--view", "error", *labs.flags(one["set"]))
        expect(alone.read_bytes() == (folder / one["name"]).read_bytes(), one)
    expect((folder / shots[0]["name"]).read_bytes() == (folder / shots[-1]["name"]).read_bytes())


def test_a_picture_of_errors_holds_what_measure_says(folder):
    known = {"model": "sphere", "cube_map": "smooth"}  # have an exact answer
    look = ["--size", "96x64", *labs.flags({p["name"]: known[p["name"]] for p in PARAMETERS if p["name"] in known})]
    ran("--view", "error", "--snapshot", folder / "a.png", *look)
    expect(labs.texts((folder / "a.png").read_bytes())["Error"] == ran("--measure", "-", *look))


def test_a_snapshot_holds_how_it_was_made(folder):
    # A number that is not the default, in the parameters' own words.
    settings = {"field_of_view": "50"} if any(p["name"] == "field_of_view" for p in PARAMETERS) else {}
    expect(ran("--size", "96x64", "--snapshot", folder / "a.png", *labs.flags(settings)) == "")
    picture, texts = labs.Picture(folder / "a.png"), labs.texts((folder / "a.png").read_bytes())
    expect((picture.width, picture.height, picture.channels) == (96, 64, 3))
    expect(list(texts)[-1] == "Renderer" and texts.pop("Renderer"), texts)
    expect(texts == {"Lab": NAME[3:], **({"Parameters": "field_of_view=50"} if settings else {}), "View": "color", "Size": "96x64"}, texts)


if __name__ == "__main__":
    os.chdir(ROOT)
    with tempfile.TemporaryDirectory() as place:
        globals()[sys.argv[1]](pathlib.Path(place))
