# SPDX-FileCopyrightText: Penumbra authors
# SPDX-License-Identifier: BSD-3-Clause
"""Scenes and films of the bench rays.py, and its report."""
import json
import sys
import time

import numpy as np
import penumbra
from bench_scenes import SCENES, surround
from cornell_moving_light import SIDES, WHITE, Room, painted
from cornell_rays import SCENE
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkRenderingCore import vtkLight, vtkRenderer

MANY = 10000  # emitters


def polygons(points, cells):
    """A mesh from lists of points and of the points' numbers."""
    positions, faces, data = vtkPoints(), vtkCellArray(), vtkPolyData()
    positions.SetData(numpy_to_vtk(np.array(points, float), deep=True))
    for cell in cells:
        faces.InsertNextCell(len(cell), cell)
    data.SetPoints(positions)
    data.SetPolys(faces)
    return data


def glowing(data, radiance):
    """An actor that emits light and reflects none."""
    actor = painted(data, (0, 0, 0))
    actor.GetProperty().SetAmbient(1)
    actor.GetProperty().SetAmbientColor(radiance)
    return actor


def keep_lit(renderer):
    """Add a light that is too faint to see: without a light VTK draws unlit colours."""
    renderer.AutomaticLightCreationOff()
    faint = vtkLight()
    faint.SetIntensity(1e-9)
    renderer.AddLight(faint)


class Cornell:
    """The Cornell box of examples/cornell.json, lit by its panel."""

    def __init__(self):
        scene = json.loads(SCENE.read_text(encoding="utf-8"))
        self.renderer = vtkRenderer()
        for item in scene["objects"]:
            material, data = item["material"], polygons(item["mesh"]["points"], item["mesh"]["polygons"])
            if "emission" in material:
                self.panel = actor = glowing(data, material["emission"])
            else:
                actor = painted(data, material["color"])
                look = actor.GetProperty()
                look.SetInterpolationToPBR()
                look.SetRoughness(material["roughness"])
                look.SetBaseIOR(material["ior"])
            self.renderer.AddActor(actor)
        keep_lit(self.renderer)
        view, camera = scene["camera"], self.renderer.GetActiveCamera()
        camera.SetPosition(view["position"])
        camera.SetFocalPoint(view["position"][:2] + [280])  # the middle of the box
        camera.SetViewUp(view["up"])
        camera.SetViewAngle(view["angle"])
        self.renderer.SetBackground(0, 0, 0)
        self.renderer.ResetCameraClippingRange()


class TwoLamps(Room):
    """The room with a second lamp and a ball, for shadows."""

    def __init__(self):
        super().__init__()
        self.second = vtkLight()
        self.second.SetLightTypeToSceneLight()
        self.second.PositionalOn()
        self.second.SetConeAngle(180)
        self.second.SetPosition(0.15, 0.2, 0.9)
        self.second.SetIntensity(0.6)
        self.renderer.AddLight(self.second)
        source = vtkSphereSource()
        source.SetRadius(0.12)
        source.SetCenter(0.5, 0.35, 0.45)
        source.SetThetaResolution(32)
        source.SetPhiResolution(24)
        source.Update()
        self.ball = painted(source.GetOutput(), WHITE)
        self.ball.GetProperty().SetInterpolationToGouraud()
        self.renderer.AddActor(self.ball)


def metal_room():
    """The room with a floor of rough metal."""
    room = Room()
    floor = room.renderer.GetActors().GetItemAsObject(list(SIDES).index("floor")).GetProperty()
    floor.SetInterpolationToPBR()
    floor.SetMetallic(1)
    floor.SetRoughness(0.4)
    floor.SetColor(0.9, 0.9, 0.9)
    return room


def squares(count, area=0.09, gap=1e-4):
    """One glowing square under the room's ceiling, or many of the same total area over the ceiling and the walls."""
    half = 0.5 * np.sqrt(area / count)
    if count == 1:
        corners = [(0.5 + x * half, 0.5 + y * half, 1 - gap) for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1))]
        return polygons(corners, [range(4)])
    random, points = np.random.default_rng(7), []
    axes = {"ceiling": (2, 1), "back": (1, 1), "left": (0, 0), "right": (0, 1)}
    for axis, end in np.array(list(axes.values()))[random.integers(len(axes), size=count)]:
        center = random.uniform(0.02, 0.98, 3)
        center[axis] = end + (0.5 - end) * 2 * gap
        first, second = np.eye(3)[[i for i in range(3) if i != axis]] * half
        points += [center - first - second, center + first - second, center + first + second, center - first + second]
    return polygons(points, np.arange(4 * count).reshape(count, 4).tolist())


def glowing_room(count):
    """The room from its ceiling, lit by a number of squares. Only the floor and what stands on it is in the picture.

    The room of one square has the others, too, but dark, so that rays meet the same surfaces."""
    room = Room()
    room.renderer.RemoveAllLights()
    keep_lit(room.renderer)
    if count == 1:
        room.renderer.AddActor(glowing(squares(MANY), (0, 0, 0)))
    room.renderer.AddActor(glowing(squares(count), (10, 10, 10)))
    camera = room.renderer.GetActiveCamera()
    camera.SetPosition(0.5, 0.5, 0.97)
    camera.SetFocalPoint(0.5, 0.5, 0)
    camera.SetViewUp(0, 1, 0)
    camera.SetViewAngle(49)
    camera.SetClippingRange(0.05, 2)
    return room.renderer


def scene(name):
    """A renderer with one of the bench's scenes by name, before black."""
    renderer = Cornell().renderer if name == "cornell" else SCENES[name]()
    renderer.GradientBackgroundOff()
    renderer.SetBackground(0, 0, 0)
    return renderer


def in_white(name):
    """One of the bench's scenes in white surroundings, without lamps: surfaces are as bright as they are open."""
    renderer = scene(name)
    renderer.RemoveAllLights()
    keep_lit(renderer)
    surround(renderer, np.ones((4, 8, 3)))
    return renderer


class Film:
    """A scene drawn in one way in a window. smooth: still frames are averaged to smooth edges, as the path tracer's are."""

    def __init__(self, renderer, size, preset, on=(), off=(), smooth=False, **parameters):
        self.renderer = renderer
        if smooth:
            parameters["anti-aliasing.mode"] = "accumulate"
        self.gi = penumbra.enable(renderer, preset, on=on, off=off, **parameters)
        self.gi.KeepRadianceOn()
        self.window = penumbra.window(renderer, size=size, multisamples=0)
        self.camera = renderer.GetActiveCamera()

    def frame(self):
        """Draw a frame; returns the seconds that it took."""
        started = time.perf_counter()
        self.window.Render()
        self.window.WaitForCompletion()
        if self.gi.GetLastError():
            raise RuntimeError(self.gi.GetLastError())
        return time.perf_counter() - started

    def picture(self, frames=0):
        """The radiance after some more frames."""
        for _ in range(frames):
            self.frame()
        return penumbra.radiance(self.gi, self.renderer)[..., :3].astype(float)

    def cut(self):
        """Look the other way for a frame. The next frame finds no history on its surfaces; probes keep their light."""
        self.camera.Yaw(180)
        self.frame()
        self.camera.Yaw(-180)

    def pose(self):
        """Where the camera is, for place()."""
        return self.camera.GetPosition(), self.camera.GetFocalPoint(), self.camera.GetViewUp(), self.camera.GetClippingRange()

    def place(self, pose):
        """Move the camera to a pose."""
        self.camera.SetPosition(pose[0])
        self.camera.SetFocalPoint(pose[1])
        self.camera.SetViewUp(pose[2])
        self.camera.SetClippingRange(pose[3])


def tracer(renderer, size, **parameters):
    """A film of the path tracer that goes on as long as it is asked to."""
    return Film(renderer, size, "reference", **{"path-tracing.samples": 1000000, **parameters})


class Report:
    """Prints figures with their limits, and remembers whether all hold. Shows on stderr what is going on."""

    def __init__(self):
        self.passed, self.width, self.shown = True, 0, time.monotonic()

    def going_on(self, what):
        """Say what is done now: on a terminal in a line that is overwritten, else every ten seconds."""
        if sys.stderr.isatty():
            print("\r" + what.ljust(self.width), end="", file=sys.stderr, flush=True)
            self.width = len(what)
        elif time.monotonic() - self.shown > 10:
            print(what, file=sys.stderr, flush=True)
            self.shown = time.monotonic()

    def figure(self, what, value, limit=None, share=False, more=""):
        """Print a figure. share: as a percentage. more: what else to say about it."""
        if self.width:
            print("\r" + " " * self.width + "\r", end="", file=sys.stderr, flush=True)
            self.width = 0

        def text(number):
            return f"{100 * number:.3g} %" if share else f"{number:.3g}"
        verdict = ""
        if limit is not None:
            holds = bool(value <= limit)  # not if it is NaN
            self.passed = self.passed and holds
            verdict = f"at most {text(limit)}: {'holds' if holds else 'EXCEEDED'}"
        print(f"{what:58} {text(value):>10}  {verdict:25} {more}".rstrip(), flush=True)
