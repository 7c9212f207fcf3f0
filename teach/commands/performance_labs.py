# SPDX-License-Identifier: MIT
"""Labs beside a floor (tests/bench/floor.cpp) and beside three.js: a first picture, one more, many in a batch."""
import json

from course import ROOT
from performance_report import bench_file, check_same, interleaved, output_of, run_process, time_of

LABS = {"lab 1": "lab01_texture_quad", "lab 5": "lab05_normal_map", "lab 9": "lab09_bump"}
LAB, FLOOR = LABS["lab 5"], "floor"
ASSETS = ROOT / "assets"
# Of llvmpipe, as gl::Shaders sets it, for where both sides are to have the same.
QUICK_TO_DRAW, QUICK_TO_COMPILE = {"GALLIVM_PERF": "no_aos_sampling"}, {"GALLIVM_PERF": "no_aos_sampling,nopt"}
MORE, BATCH = 20, 36  # pictures


def measure_snapshots(setting, report):
    report.begin("A snapshot beside its floor", """
        The floor (`tests/bench/floor.cpp`) is lab 5's picture written by hand in one program without the framework: OSMesa,
        libspng, the same files. From the start of the process to its end, 512x512 with 4 samples a pixel, nothing warmed up but
        the disk's cache. A lab that draws one picture asks llvmpipe for shaders that are quick to compile (`gl::Shaders`), the
        floor leaves the driver as it is; *quick too* is a floor that asks for the same.""", "lab", "floor")
    ours, theirs = setting.work / "ours.png", setting.work / "floor.png"
    runs = interleaved(setting.rounds, lambda: run_process(LAB, "--snapshot", ours), lambda: run_process(FLOOR, ASSETS, theirs))
    check_same(ours, theirs)
    report.add("lab 5, time", "ms", [(own[0], other[0]) for own, other in runs], at_most=1.25)
    report.add("lab 5, memory", "MiB", [(own[1], other[1]) for own, other in runs], at_most=1.3)
    report.add("lab 5, the floor's shaders quick too", "ms",
               interleaved(setting.rounds, lambda: time_of(LAB, "--snapshot", ours),
                           lambda: time_of(FLOOR, ASSETS, theirs, variables=QUICK_TO_COMPILE)), at_most=1.25)
    for name, lab in LABS.items():
        stats = output_of(lab, "--snapshot", setting.work / "stats.png", "--stats", "-")
        report.stages[name] = json.loads(stats)["milliseconds"]


def one_more(setting, lab):
    """Milliseconds of a picture more in a process that is under way: the difference of a batch of many and of one, shared."""

    def batch(count):
        file = setting.write_json(f"warm_{count}.json", [{"name": str(i)} for i in range(count)])
        return time_of(lab, "--batch", file, "--out", setting.work / "warm", variables=QUICK_TO_DRAW)

    return (batch(MORE + 1) - batch(1)) / MORE


def measure_one_more(setting, report):
    report.begin("One more picture", f"""
        The same picture once more from a process that has drawn it already (a lab's `--batch`, which compresses it beside the
        next one's drawing; the floor in a loop): the time of {MORE + 1} and of one, and the difference shared. Both have
        optimised shaders.""", "lab", "floor")
    picture = setting.work / "floor.png"
    report.add("lab 5, one more", "ms", interleaved(
        setting.rounds, lambda: one_more(setting, LAB),
        lambda: (time_of(FLOOR, ASSETS, picture, MORE + 1) - time_of(FLOOR, ASSETS, picture, 1)) / MORE), at_most=1.15)
    check_same(setting.work / f"warm/{MORE}.png", picture)


def add_batch(setting, report, what, lab, entries, target):
    """A batch beside a process for each of its entries."""
    file = setting.write_json("list.json", entries)

    def alone(entry):
        settings = [word for name, value in entry["set"].items() for word in (f"--{name}", value)]
        return time_of(lab, *settings, "--view", entry["view"], "--snapshot", setting.work / f"alone_{entry['name']}.png")

    report.add(what, "ms", interleaved(setting.long_rounds, lambda: time_of(lab, "--batch", file, "--out", setting.work / "batch"),
                                       lambda: sum(map(alone, entries))), at_least=target)
    for entry in entries:
        check_same(setting.work / f"alone_{entry['name']}.png", setting.work / f"batch/{entry['name']}.png")


def measure_batches(setting, report):
    report.begin("A batch beside a process each", """
        36 snapshots of 512x512 by one process (`--batch`), which optimises its shaders where each draws much, and by 36, which do
        not, one after the other.""", "one process", "36 processes")
    for name, lab in LABS.items():
        turned = [{"name": str(i), "view": "color", "set": {"yaw": 10 * i}} for i in range(BATCH)]
        add_batch(setting, report, f"{name}, a turning camera", lab, turned, 5)
    # All methods and views: each is a program of its own that the driver compiles.
    parameters = json.loads(output_of(LAB, "--list-parameters", "--json"))
    methods = [choice["name"] for parameter in parameters if parameter["name"] == "method" for choice in parameter["choices"]]
    views = ("color", "texcoord", "depth", "mask")
    every = [{"name": str(i), "view": views[i // len(methods) % len(views)], "set": {"method": methods[i % len(methods)], "yaw": i}}
             for i in range(BATCH)]
    add_batch(setting, report, "lab 5, all methods, four views", LAB, every, 0)


def measure_peers(setting, report):
    """Our page and our program beside three.js' page of the same ball, in the same rounds."""
    report.begin("Beside three.js", """
        Lab 9's ball by three.js (`tests/bench/peers`): the same cube map, normal map, mesh and filters, in headless Chromium,
        which draws by SwiftShader. Pages: the first picture from navigation on, in a browser that has drawn both, is at rest, and
        keeps no files; one of many pictures of 512x512 with 4 samples a pixel and with one; what is loaded, as brotli compresses
        it. *Something to see*: until our page shows its still, beside three.js' first picture. Our page comes with its handout, all labs and the judge, which the browser compiles and lays out while it waits for
        the picture, and with its pictures as lossless WebP; three.js' page loads the tree's PNG files. Our program draws by
        llvmpipe: one of many pictures with 4 samples; and one from the start of the process to its end, with the driver's cache
        of shaders, beside three.js' first one from the start of Chromium.""",
                 "ours", "three.js")
    lab = LABS["lab 9"]

    def snapshot():
        return time_of(lab, "--snapshot", setting.work / "peers.png", variables=setting.kept_shaders)

    snapshot()  # fills the cache
    pages, more, cold = [], [], []
    for _ in range(setting.rounds):
        pages.append(json.loads(output_of("node", bench_file("peers/measure.mjs"), 1, "--json"))[0])
        more.append((one_more(setting, lab), pages[-1]["theirs"]["antialiased_ms"]))
        cold.append((snapshot(), pages[-1]["theirs"]["cold_ms"]))
    report.add("page, something to see", "ms", [(page["ours"]["still_ms"], page["theirs"]["first_picture_ms"]) for page in pages], at_most=0.6)
    for what, name, unit, most, why in (
            ("page, first picture", "first_picture_ms", "ms", 1.7, """
                by the worker's clock, milliseconds after navigation: it runs at 100, its WebGL context is there at 290, the lab is
                open at 340, seven pictures are unpacked at 410. Mipmaps, uploads (33 MB: as floats SwiftShader reads colours
                quicker in every frame) and shaders take until 560, the drawing until 650. three.js draws on the page's own thread;
                our worker keeps the page alive when a shader never ends. Half floats are uploaded sooner, but a frame takes 1.25
                times as long; each face uploaded while the next one's mipmaps are made gains nothing."""),
            ("page, antialiased", "antialiased_ms", "ms", 1, ""), ("page, one sample", "plain_ms", "ms", 1, ""),
            ("page, loaded", "bytes", "bytes", 1.1, "20 kB of ours are the still, and the handout's pictures come meanwhile.")):
        report.add(what, unit, [(page["ours"][name], page["theirs"][name]) for page in pages], at_most=most, why=why)
    report.add("program, one more", "ms", more, at_most=0.6)
    report.add("program, first picture", "ms", cold, at_most=0.07, why="""
        of 150 ms by --stats, driver and context take 18, reading seven pictures 30, their mipmaps and upload 22, compressing the
        picture 8. The first picture takes 65: one more takes 20, the rest loads the machine code that the driver kept.""")
