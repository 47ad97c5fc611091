#!/usr/bin/env python3
# SPDX-FileCopyrightText: Penumbra authors
# SPDX-License-Identifier: BSD-3-Clause
"""What few rays per pixel, their mean over frames and the filter achieve. Prints a line for each figure, with its limit.
Exits with 1 if a limit is exceeded.

equal-time   relMSE in a time, divided by the path tracer's in the same time, after a cut
orbit        relMSE while the camera turns, divided by that of single frames after cuts, without and with the filter
flicker      deviation over still frames after a lamp has moved; change from frame to frame while it moves
ghost        light that remains of a lamp or a ball that has gone
emitters     cost and relMSE with 10,000 glowing squares and with one
first-frame  relMSE of the first frame after a cut with the filter, divided by that without it; pictures of twice the size, as
             nothing can average the noise of penumbrae that are a pixel wide
still        relMSE of 64 still frames with the filter, divided by that without it; signed error of their mean; against 512
             unfiltered frames with 8 rays per pixel
seams        relMSE at lower resolutions, divided by that at full resolution after as many samples of each pixel
"""
import argparse
import json
import math
import os
import statistics
import sys
import tempfile

import numpy as np
import penumbra
from cornell_rays import penumbra as command
from indirect_light import kept, write
from isosurface_ddgi import blocks
from PIL import Image
from ray_scenes import MANY, Cornell, Film, Report, Room, TwoLamps, glowing_room, in_white, keep_lit, metal_room, scene, tracer
from sky_light import compared, truths

EQUAL_TIME = {0.5: 1 / 8, 2: 1 / 4, 8: 1 / 2}  # seconds: limit of the ratio
ORBIT = 0.25
FLICKER, FLIP, FLIP_MORE = 0.01, 1.1, 0.005
GHOST = {"direct": {1: 0.05, 4: 0.01, 16: 0.001}, "indirect": {1: 0.2, 4: 0.05, 16: 0.01}}  # frames: share
EMITTERS = 1.3
FIRST_FRAME = {"GI": 0.10, "AO by rays": 0.15, "AO": 0.15, "glossy": 0.20, "shadow": 0.20}
STILL, STILL_MEAN, STILL_FRAMES = 1.1, 0.003, 64
SEAMS, SEAM = 1.3, 0.1  # ratio; difference of a pixel
WARM = 48    # frames that settle the probes
LONG = 128   # frames of a converged picture
SCENES = ("cornell", "isosurface", "head", "terrain", "protein")
BRIGHT = 3   # brighter pixels show the Cornell box's panel


def equal_time(args, report):
    """Films take turns, each with its own clock, so that other programs disturb all of them alike."""
    for name in args.scenes or SCENES[:4]:
        report.going_on(f"equal-time, {name}: path tracer")
        size = args.size
        truth = kept(args.keep, f"{name}_{size[0]}x{size[1]}_2x{args.spp}", lambda: truths(tracer(scene(name), size), args.spp))
        films = {"path tracer": tracer(scene(name), size), "balanced": Film(scene(name), size, "balanced", smooth=True),
                 "high": Film(scene(name), size, "high", off=args.off, smooth=True, **args.set)}
        for film in films.values():
            film.picture(WARM)
            film.cut()
        clocks, frames = dict.fromkeys(films, 0.0), dict.fromkeys(films, 0)
        for seconds, limit in EQUAL_TIME.items():
            waiting = set(films)
            while waiting:
                key = min(waiting, key=clocks.get)
                report.going_on(f"equal-time, {name}: {key}, {clocks[key]:.1f} of {seconds} s")
                if frames[key] and clocks[key] * (1 + 1 / frames[key]) > seconds:
                    waiting.remove(key)
                    continue
                clocks[key] += films[key].frame()
                frames[key] += 1
            pictures = {key: film.picture() for key, film in films.items()}
            errors = {key: compared(picture, truth)[0] for key, picture in pictures.items()}
            best = min(("balanced", "high"), key=errors.get)
            write(args.pictures, f"equal_time_{name}_{seconds}s.png", pictures[best], pictures["path tracer"], truth.mean(axis=0))
            report.figure(f"equal-time, {name}, {seconds} s: relMSE of {best} / path tracer", errors[best] / errors["path tracer"],
                          limit, more=", ".join(f"{key} {errors[key]:.5f} in {frames[key]} frames" for key in films))


def turned(film, name, frames):
    """Turn the camera by 2 degrees in each of some frames, in the Cornell box to and fro before its open side."""
    for frame in range(1, frames + 1):
        back = name == "cornell" and (frame + 5) // 10 % 2
        film.camera.Azimuth(-2 if back else 2)
        yield frame


def orbit(args, report):
    """Still frames from the same cameras follow each cut, up to a converged picture."""
    frames = 40 if args.quick else 120
    for name in args.scenes or ("cornell", "protein"):
        moving, still, raw = (Film(scene(name), args.size, "high", off=args.off + more, **args.set)
                              for more in ([], [], ["denoising"]))
        traced = tracer(scene(name), args.size)
        for film in (moving, still, raw):
            film.picture(WARM)
        errors = []
        for frame in turned(moving, name, frames):
            report.going_on(f"orbit, {name}: frame {frame} of {frames}")
            ours = moving.picture(1)
            if frame % 10 or frame <= frames // 4:
                continue
            for film in (still, raw, traced):
                film.place(moving.pose())
            for film in (still, raw):
                film.cut()
            single, unfiltered = still.picture(1), raw.picture(1)
            converged = still.picture(LONG - 1)
            spp = max(1, args.spp // 2)
            truth = kept(args.keep, f"orbit_{name}_{frame}_{args.size[0]}x{args.size[1]}_2x{spp}", lambda: truths(traced, spp))
            write(args.pictures, f"orbit_{name}_{frame:03d}.png", ours, single, converged, truth.mean(axis=0))
            coarse = np.stack([blocks(picture) for picture in truth])
            errors.append([compared(blocks(picture), coarse)[0] for picture in (ours, single, converged)] +
                          [penumbra.relative_error(picture, converged)[0] for picture in (ours, single, unfiltered)])
        ours, single, converged, noise, of_single, of_unfiltered = np.mean(errors, axis=0)
        report.figure(f"orbit, {name}: against the path tracer (means of 4x4 pixels)", ours / single,
                      more=f"{ours:.5f}, single frames {single:.5f}, converged {converged:.5f}")
        report.figure(f"orbit, {name}: against the converged picture / unfiltered frames", noise / of_unfiltered, ORBIT,
                      more=f"{noise:.5f}, unfiltered {of_unfiltered:.5f}")
        report.figure(f"orbit, {name}: against the converged picture / filtered frames", noise / of_single,
                      more=f"{noise:.5f}, filtered {of_single:.5f}")


def changes(films, place, folder):
    """Mean FLIP between successive pictures of a film while its lamp moves."""
    found = []
    for step in range(len(films)):
        place(step)
        picture = films[step]()
        Image.fromarray(picture).save(os.path.join(folder, f"{step}.png"))
        if step:
            pair = (os.path.join(folder, f"{index}.png") for index in (step, step - 1))
            found.append(json.loads(command("compare", *pair, "--json"))["flip-mean"])
    return np.mean(found)


def flicker(args, report):
    """The lamp circles by 6 degrees a frame, then stands still. The camera stands still all the time."""
    steps = 4 if args.quick else 8

    def move(room, step):
        turn = math.radians(6 * step)
        room.lamp.SetPosition(0.5 + 0.3 * math.cos(turn), 0.5 + 0.3 * math.sin(turn), 0.8)

    room, exact = Room(), Room()
    ours, traced = Film(room.renderer, args.size, "high", **args.set), tracer(exact.renderer, args.size)
    ours.picture(WARM)

    def reference():
        report.going_on("flicker: path tracer")
        return penumbra.render(traced.window, frames=2 * args.spp)

    with tempfile.TemporaryDirectory() as folder:
        drawn = changes(steps * [lambda: penumbra.render(ours.window)], lambda step: move(room, step), folder)
        expected = changes(steps * [reference], lambda step: move(exact, step), folder)
    ours.picture(16)
    frames = np.stack([ours.picture(1).mean(axis=2) for _ in range(30)])
    mean = frames.mean(axis=0)
    lit = mean > 1e-3 * mean.mean()
    write(args.pictures, "flicker.png", ours.picture(), traced.picture())
    report.figure("flicker: deviation / mean over 30 frames after the lamp stopped",
                  (frames.std(axis=0)[lit] / mean[lit]).mean(), FLICKER, share=True)
    report.figure("flicker: FLIP of successive frames / (path tracer's + 0.005)", drawn / (expected + FLIP_MORE), FLIP,
                  more=f"{drawn:.4f}, path tracer {expected:.4f}")


def remains(report, name, kind, make, change, args, where=None, **drawn):
    """Light left of what has gone.

    Only pixels count where the old and the new picture differ. A film that never saw what has gone gives the new
    picture, and the noise of as many frames after a cut. The figure is the larger one of two: the sum of absolute
    differences from the new picture, of means of 4x4 pixels, minus the same of the other film, which is noise; and the
    part of old minus new that is still in the picture, in which noise cancels.
    """
    report.going_on(f"ghost, {kind}: {name}")
    past, fresh = make(), make()
    film, other = (Film(part.renderer, args.size, **{**drawn, **args.set}) for part in (past, fresh))
    old = film.picture(LONG)
    change(fresh)
    change(past)
    counts = list(GHOST[kind])
    after = [film.picture(count - before) for before, count in zip([0] + counts, counts)]
    other.picture(WARM)
    other.cut()
    alone = [other.picture(count - before) for before, count in zip([0] + counts, counts)]
    new = other.picture(LONG - counts[-1])
    gone = (old - new) * (np.abs(old - new).sum(axis=2, keepdims=True) > 0.03 * old.mean())
    gone = gone if where is None else gone * where[..., None]
    mask = gone.any(axis=2, keepdims=True)
    whole = np.abs(blocks(gone)).sum()
    if not whole:
        raise RuntimeError(f"ghost, {kind}: {name} changes nothing in the picture")
    write(args.pictures, f"ghost_{kind}_{name.replace(' ', '_')}.png", old, *after, new)
    for count, picture, noisy in zip(counts, after, alone):
        total, noise = (np.abs(blocks((some - new) * mask)).sum() / whole for some in (picture, noisy))
        along = ((picture - new) * gone).sum() / (gone ** 2).sum()
        report.figure(f"ghost, {kind}, {name}, left after {count} frames", max(total - noise, abs(along)), GHOST[kind][count],
                      share=True, more=f"differences {100 * total:.2f} %, noise of them {100 * noise:.2f} %; along {100 * along:.2f} %")


def hidden(renderer, args):
    """The pixels of a scene that no light reaches straight."""
    straight = tracer(renderer, args.size, **{"path-tracing.bounces": 0}).picture(64).sum(axis=2)
    return straight < 1e-3 * straight.mean()


def ghost(args, report):
    """Shadows of lamps with a size alone; then light by `high` where it arrives after a reflection."""
    shadows = {"preset": "off", "on": ["ray-traced-shadows", "temporal-accumulation", "denoising"],
               "ray-traced-shadows.light-radius": 0.06}
    remains(report, "lamp", "direct", TwoLamps, lambda room: room.lamp.SwitchOff(), args, **shadows)
    remains(report, "ball", "direct", TwoLamps, lambda room: room.renderer.RemoveActor(room.ball), args, **shadows)

    def lamp():
        room = TwoLamps()
        room.renderer.RemoveLight(room.second)
        keep_lit(room.renderer)
        return room

    remains(report, "panel", "indirect", Cornell, lambda box: box.panel.GetProperty().SetAmbient(0), args,
            hidden(Cornell().renderer, args), preset="high")
    remains(report, "lamp", "indirect", lamp, lambda room: room.lamp.SwitchOff(), args, hidden(lamp().renderer, args),
            preset="high")


def emitters(args, report):
    """Emitters are not in the picture itself. Frames are timed while the camera turns."""
    films = {count: Film(glowing_room(count), args.size, "high", smooth=True) for count in (1, MANY)}
    for film in films.values():
        report.going_on("emitters")
        film.picture(WARM)
    times = {count: [] for count in films}
    for turn in range(5 if args.quick else 15):
        for count, film in films.items():
            film.camera.Roll(1 if turn % 2 else -1)
            times[count].append(film.frame())
    one, many = (statistics.median(column) for column in times.values())
    report.figure("emitters: time of a frame with 10,000 / with 1", many / one, EMITTERS,
                  more=f"{1000 * many:.0f} ms, {1000 * one:.0f} ms")
    for count, film in films.items():
        report.going_on(f"emitters: path tracer with {count}")
        truth = kept(args.keep, f"emitters_{count}_{args.size[0]}x{args.size[1]}_2x{args.spp}",
                     lambda: truths(tracer(glowing_room(count), args.size), args.spp))
        film.camera.SetRoll(0)
        film.cut()
        first = film.picture(1)
        last = film.picture(63)
        write(args.pictures, f"emitters_{count}.png", first, last, truth.mean(axis=0))
        for title, picture in (("first filtered frame", first), ("64 frames", last)):
            error, mean = compared(picture, truth)
            report.figure(f"emitters, {count}: relMSE of {title}", error, more=f"signed mean {100 * mean:+.2f} %")


def first_frame(args, report):
    """Each technique is alone, so that the only errors are noise and what the filter does. Means over three cuts."""
    size = tuple(2 * side for side in args.size)
    plain = ["temporal-accumulation"]
    cases = {
        "GI": (lambda: Cornell().renderer, ["ray-traced-light"], {}, None),
        "GI with probes": (lambda: Cornell().renderer, ["ray-traced-light", "ddgi"], {}, None),
        "AO by rays": (lambda: in_white("protein"), ["ray-traced-light"], {}, None),
        "AO": (lambda: scene("protein"), ["ambient-occlusion"], {"ambient-occlusion.ambient-share": 1}, "ambient-occlusion.filter"),
        "glossy": (lambda: metal_room().renderer, ["screen-space-reflections"], {}, "screen-space-reflections.filter"),
        "shadow": (lambda: TwoLamps().renderer, ["ray-traced-shadows"], {"ray-traced-shadows.light-radius": 0.06}, None)}
    for name, (make, on, settings, switch) in cases.items():
        films = []
        for filtered in (True, False):
            report.going_on(f"first-frame, {name}")
            extra = ["denoising"] if filtered and name != "AO" else []
            settings = {**settings, **({switch: float(filtered)} if switch else {})}
            films.append(Film(make(), size, "off", on + plain + extra, **settings))
        pictures = []
        for film in films:
            film.picture(WARM if "ddgi" in on else 1)
            pictures.append([])
            for _ in range(3):
                film.cut()
                pictures[-1].append(film.picture(1))
        report.going_on(f"first-frame, {name}: many frames")
        truth = films[1].picture(2 * LONG)
        where = np.broadcast_to(truth.max(axis=2, keepdims=True) < BRIGHT, truth.shape)
        with_filter, without = (np.mean([penumbra.relative_error(picture[where], truth[where])[0] for picture in some]) for some in pictures)
        write(args.pictures, f"first_frame_{name.replace(' ', '_')}.png", pictures[1][0], pictures[0][0], truth)
        report.figure(f"first-frame, {name}: relMSE filtered / unfiltered", with_filter / without, FIRST_FRAME.get(name),
                      more=f"{with_filter:.5f}, {without:.5f}")


def still(args, report):
    """Frames of one estimator: with the filter, without it, and many without it."""
    many = 8 * STILL_FRAMES
    for name in args.scenes or ("cornell", "head"):
        raw = ("denoising",)
        films = {"filtered": Film(scene(name), args.size, "high", smooth=True, **args.set),
                 "unfiltered": Film(scene(name), args.size, "high", off=raw, smooth=True, **args.set)}
        best = Film(scene(name), args.size, "high", off=raw, smooth=True,
                    **{**args.set, "ray-traced-light.rays": 8, "anti-aliasing.maximum-frames": many})
        pictures = {}
        for key, film in films.items():
            report.going_on(f"still, {name}: {key}")
            film.picture(WARM)
            film.cut()
            pictures[key] = film.picture(STILL_FRAMES)
        report.going_on(f"still, {name}: many frames")
        best.picture(WARM)
        best.cut()
        truth = best.picture(many)
        write(args.pictures, f"still_{name}.png", *pictures.values(), truth)
        found = {key: penumbra.relative_error(picture, truth) for key, picture in pictures.items()}
        report.figure(f"still, {name}: relMSE filtered / unfiltered", found["filtered"][0] / found["unfiltered"][0], STILL,
                      more=f"{found['filtered'][0]:.5f}, {found['unfiltered'][0]:.5f}")
        report.figure(f"still, {name}: error of the mean", abs(found["filtered"][1]), STILL_MEAN, share=True)


def seams(args, report):
    """Still frames after each of two cuts, then frames of a turning camera, whose cost is measured, too. A seam is off after both
    cuts, noise hardly ever."""
    sharing = {"full": 1, "checkerboard": 2, "half": 4, "quarter": 16}
    count = 16 if args.quick else 64
    for name in args.scenes or ("cornell", "head"):
        films = {key: Film(scene(name), args.size, "high", off=("anti-aliasing",), **{"ray-traced-light.resolution": key})
                 for key in sharing}
        best = Film(scene(name), args.size, "high", off=("anti-aliasing",), **{"ray-traced-light.rays": 8})
        pictures, turning, times = {}, {}, {key: [] for key in films}
        for key, film in films.items():
            report.going_on(f"seams, {name}: {key}")
            film.picture(WARM)
            pictures[key] = []
            for _ in range(2):
                film.cut()
                pictures[key].append(film.picture(count * sharing[key]))
        report.going_on(f"seams, {name}: converged")
        truth = best.picture(2 * LONG)
        list(turned(best, name, 12))
        truth_turned = best.picture(2 * LONG)
        for steps in zip(*(turned(film, name, 12) for film in films.values())):
            report.going_on(f"seams, {name}: turned {steps[0]} times")
            for key, film in films.items():
                times[key].append(film.frame())
        turning = {key: penumbra.relative_error(film.picture(), truth_turned)[0] for key, film in films.items()}
        write(args.pictures, f"seams_{name}.png", *(pair[0] for pair in pictures.values()), truth)
        errors = {key: np.mean([penumbra.relative_error(picture, truth)[0] for picture in pair]) for key, pair in pictures.items()}
        off = {key: np.all([np.abs(picture - truth).max(axis=2) > SEAM for picture in pair], axis=0).sum()
               for key, pair in pictures.items()}
        for key in list(sharing)[1:]:
            report.figure(f"seams, {name}, {key}: relMSE after {count} samples / of full", errors[key] / errors["full"], SEAMS,
                          more=f"{errors[key]:.5f}, {errors['full']:.5f}")
            report.figure(f"seams, {name}, {key}: pixels off by more than {SEAM}", off[key], off["full"])
            report.figure(f"seams, {name}, {key}: relMSE of a turning frame / of full", turning[key] / turning["full"],
                          more=f"{turning[key]:.5f}, {turning['full']:.5f}; time "
                          f"{statistics.median(times[key]) / statistics.median(times['full']):.2f} of full")


MEASURES = {"equal-time": equal_time, "orbit": orbit, "flicker": flicker, "ghost": ghost, "emitters": emitters,
            "first-frame": first_frame, "still": still, "seams": seams}


def size_of(text):
    """Width and height."""
    width, _, height = text.partition("x")
    if not (width.isdigit() and height.isdigit() and min(int(width), int(height)) >= 16):
        raise argparse.ArgumentTypeError(f"'{text}' is no size such as 128x128, of at least 16 pixels")
    return int(width), int(height)


def paths_of(text):
    """A number of paths."""
    if not (text.isdigit() and int(text) > 0):
        raise argparse.ArgumentTypeError(f"'{text}' is no number of paths")
    return int(text)


def setting_of(text):
    """A parameter and its value."""
    name, equals, value = text.partition("=")
    if "." not in name or not equals:
        raise argparse.ArgumentTypeError(f"{text} is not TECHNIQUE.PARAMETER=VALUE")
    return name, value


def options():
    """Parse the command line."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("measures", nargs="*", metavar="MEASURE", help="any of the above (default: all)")
    parser.add_argument("--size", default="128x128", type=size_of, metavar="WxH", help="size of the pictures (default %(default)s)")
    parser.add_argument("--spp", default=512, type=paths_of, help="paths per pixel of each of two references, whose noise cancels "
                        "(default %(default)s); half as many for each camera of the orbit")
    parser.add_argument("--scenes", nargs="+", default=[], metavar="SCENE",
                        help="of equal-time, orbit, still and seams: " + ", ".join(SCENES))
    parser.add_argument("--off", nargs="+", default=[], metavar="TECHNIQUE",
                        help="leave these out of high in equal-time and orbit; the path tracer shows all light")
    parser.add_argument("--set", nargs="+", default=[], type=setting_of, metavar="TECHNIQUE.PARAMETER=VALUE",
                        help="change these in what equal-time, orbit, flicker, ghost and still judge")
    parser.add_argument("--quick", action="store_true", help="fewer frames")
    parser.add_argument("--keep", metavar="FOLDER", help="folder that keeps traced pictures for the next run")
    parser.add_argument("--pictures", metavar="FOLDER", help="write the compared pictures there, the truth last")
    args = parser.parse_args()
    args.set = dict(args.set)
    for given, known, kind in ((args.measures, MEASURES, "measure"), (args.scenes, SCENES, "scene")):
        for name in given:
            if name not in known:
                parser.error(f"there is no {kind} '{name}': choose from {', '.join(known)}")
    for folder in (args.keep, args.pictures):
        try:
            if folder:
                os.makedirs(folder, exist_ok=True)
        except OSError as error:
            parser.error(f"cannot make the folder {folder}: {error.strerror}")
    return args


def main():
    """Take the measures."""
    args, report = options(), Report()
    for name in args.measures or MEASURES:
        try:
            MEASURES[name](args, report)
        except (RuntimeError, ValueError) as error:
            sys.exit(f"rays.py: {name}: {error}")
    return 0 if report.passed else 1


if __name__ == "__main__":
    sys.exit(main())
