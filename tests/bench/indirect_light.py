#!/usr/bin/env python3
# SPDX-FileCopyrightText: Penumbra authors
# SPDX-License-Identifier: BSD-3-Clause
"""Indirect light by DDGI compared with the path tracer in a Cornell box: in a static scene, and while its lamp and a box
move. Exits with 1 if an error is above its limit."""
import argparse
import os
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "..", "..", "examples"))

import numpy as np  # noqa: E402
import penumbra  # noqa: E402
from cornell_moving_light import WHITE, Room, cuboid, painted  # noqa: E402

STILL, STILL_MEAN, MOVING = 0.02, 0.02, 0.03  # limits: relMSE, signed mean, mean relMSE over the frames
BOUNCES = 30
FINER = 4  # our pixels per pixel of the reference along each axis, because the reference is anti-aliased


def options():
    """Parse the command line."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--size", type=int, default=96, help="width and height of the pictures in pixels")
    parser.add_argument("--spp", type=int, default=256, help="paths per pixel of the reference of moving pictures")
    parser.add_argument("--frames", type=int, default=60, help="number of frames of the lamp's orbit")
    parser.add_argument("--step", type=int, default=1, help="compare every Nth frame")
    parser.add_argument("--set", action="append", default=[], metavar="NAME=VALUE", help="parameter of ddgi; for other techniques: TECHNIQUE.NAME=VALUE")
    parser.add_argument("--keep", metavar="FOLDER", help="folder that keeps traced pictures for the next run")
    parser.add_argument("--pictures", metavar="FOLDER", help="write pairs of pictures there")
    parser.add_argument("--occlusion", type=float, metavar="RADIUS", nargs="+", default=[],
                        help="compare the static scene also with ambient occlusion of these radii; 0: automatic")
    parser.add_argument("--bricks", type=int, default=0, metavar="N",
                        help="number of bricks on the floor and walls of the static room, each smaller than a cell of the probe grid")
    parser.add_argument("--far", type=float, default=0, metavar="LENGTHS",
                        help="distance of a box behind the camera in the static scene, in lengths of the room, which enlarges the scene")
    parser.add_argument("--updates", type=int, default=400, help="number of probe updates before the picture of the static scene")
    parser.add_argument("--verbose", action="store_true", help="print the error of each frame")
    parser.add_argument("--only", choices=("still", "moving"))
    return parser.parse_args()


def room_with(bricks, far):
    """The room with a number of bricks, always the same ones, and with a distant box unless far is 0."""
    room = Room()
    if far:
        box = painted(cuboid(0.3, 0.3, 0.3), WHITE)
        box.SetPosition(0.5, -far, 0.4)
        room.renderer.AddActor(box)
    random = np.random.default_rng(3)
    for _ in range(bricks):
        side = 0.03 + 0.05 * random.random()
        axis, end = ((2, 0), (1, 1), (0, 0), (0, 1))[random.integers(4)]
        position = 0.1 + 0.8 * random.random(3)
        position[axis] = end + (0.5 - end) * side
        brick = painted(cuboid(side, side, side), WHITE)
        brick.SetPosition(*position)
        brick.SetOrientation(*(90 * random.random(3)))
        room.renderer.AddActor(brick)
    room.renderer.ResetCameraClippingRange()
    return room


class Camera:
    """Draws a room in one way, and returns its linear radiance."""

    def __init__(self, size, preset, room=None, **parameters):
        self.room = room or Room()
        self.gi = penumbra.enable(self.room.renderer, preset, **parameters)
        self.gi.KeepRadianceOn()
        self.window = penumbra.window(self.room.renderer, size=size if isinstance(size, tuple) else (size, size), multisamples=0)

    def picture(self, frames=1):
        """The radiance after a number of frames."""
        for _ in range(frames):
            self.window.Render()
        return penumbra.radiance(self.gi, self.room.renderer)[..., :3].astype(float)


def smaller(picture):
    """The picture reduced to the means of FINER by FINER pixels."""
    height, width, channels = picture.shape
    return picture.reshape(height // FINER, FINER, width // FINER, FINER, channels).mean(axis=(1, 3))


def direct_preset(ddgi, settings):
    """Ray-traced shadows, which equal those of the reference, and optionally DDGI."""
    return {"on": ["ray-traced-shadows"] + (["ddgi"] if ddgi else []),
            **({name if "." in name else f"ddgi.{name}": value for name, value in settings.items()} if ddgi else {})}


def kept(folder, name, make):
    """An array from an earlier run, or made now."""
    path = folder and os.path.join(folder, name + ".npy")
    if path and os.path.exists(path):
        return np.load(path)
    made = make()
    if path:
        os.makedirs(folder, exist_ok=True)
        np.save(path, made)
    return made


def write(folder, name, *pictures):
    """Write pictures side by side, encoded for display."""
    if not folder:
        return
    from PIL import Image
    os.makedirs(folder, exist_ok=True)
    row = np.concatenate(pictures, axis=1)
    Image.fromarray((255 * np.clip(row, 0, 1) ** (1 / 2.2) + 0.5).astype(np.uint8)).save(os.path.join(folder, name))


def traced(size, spp, bounces, moment=0.0, bricks=0, far=0.0):
    """Picture of the path tracer at one time."""
    camera = Camera(size, "reference", room_with(bricks, far), **{"path-tracing.samples": spp, "path-tracing.bounces": bounces})
    camera.room.at(moment)
    return camera.picture(spp)


def still(args, settings):
    """Compare indirect light in the static scene: pictures with it minus pictures without it."""
    spp = 16 * args.spp
    name = f"{args.size}_{spp}" + (f"_{args.bricks}" if args.bricks else "") + (f"_far{args.far:g}" if args.far else "")
    full = kept(args.keep, f"full_{name}", lambda: traced(args.size, spp, BOUNCES, bricks=args.bricks, far=args.far))
    once = kept(args.keep, f"once_{name}", lambda: traced(args.size, spp, 0, bricks=args.bricks, far=args.far))

    def drawn(ddgi, occlusion=None):
        preset = direct_preset(ddgi, settings)
        if occlusion is not None:
            preset["on"] += ["ambient-occlusion", "temporal-accumulation"]
            preset["ambient-occlusion.radius"] = occlusion
        camera = Camera(FINER * args.size, "off", room_with(args.bricks, args.far), **preset)
        return smaller(camera.picture(args.updates if ddgi else 1))

    direct, truth, passed = drawn(False), full - once, True
    for radius in (None, *args.occlusion):
        picture = drawn(True, radius)
        error, mean = penumbra.relative_error(picture - direct, truth)
        whole, whole_mean = penumbra.relative_error(picture, full)
        suffix = "" if radius is None else f" with occlusion of radius {radius or 'automatic'}"
        write(args.pictures, f"still{suffix.replace(' ', '_')}.png", picture, full, picture - direct, truth)
        print(f"static, indirect light only{suffix}: relMSE {error:.4f} (at most {STILL}), signed mean {100 * mean:+.2f} % "
              f"(within {100 * STILL_MEAN:.0f} %); whole picture {whole:.4f}, {100 * whole_mean:+.2f} %")
        passed &= bool(error <= STILL and abs(mean) <= STILL_MEAN)
    return passed


def moving(args, settings):
    """Compare whole pictures of the moving scene, with one probe update per frame."""
    camera = Camera(FINER * args.size, "off", **direct_preset(True, settings))
    camera.picture(60)
    errors = []
    for frame in range(args.frames):
        moment = frame / args.frames
        camera.room.at(moment)
        ours = smaller(camera.picture())
        if frame % args.step:
            continue
        truth = kept(args.keep, f"moving_{args.size}_{args.spp}_{args.frames}_{frame}",
                     lambda: traced(args.size, args.spp, BOUNCES, frame / args.frames))
        errors.append(penumbra.relative_error(ours, truth))
        if args.verbose:
            print(f"frame {frame}: relMSE {errors[-1][0]:.4f}, signed mean {100 * errors[-1][1]:+.2f} %")
        write(args.pictures, f"moving_{frame:02d}.png", ours, truth)
    error, mean = np.mean(errors, axis=0)
    print(f"moving, {len(errors)} frames: mean relMSE {error:.4f} (at most {MOVING}), worst {max(e for e, _ in errors):.4f}, "
          f"signed mean {100 * mean:+.2f} %")
    return error <= MOVING


def main():
    """Compare the static and the moving scene."""
    args = options()
    settings = dict(item.split("=", 1) for item in args.set)
    passed = [compare(args, settings) for name, compare in (("still", still), ("moving", moving)) if args.only in (None, name)]
    sys.exit(0 if all(passed) else 1)


if __name__ == "__main__":
    main()
