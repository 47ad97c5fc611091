#!/usr/bin/env python3
# SPDX-FileCopyrightText: Penumbra authors
# SPDX-License-Identifier: BSD-3-Clause
"""Make random public calls on windows, renderers, props, lights, vtkGIPass and the light gatherer.

Each call is printed before it is made, so that the last line before a crash names it. The same seed makes the same calls.
Fails if OpenGL or VTK reports an error, if a value out of range is accepted, or if the program ends before it prints
"done". With --stock no pass is set: stock VTK must survive the same sequence.
"""
import argparse
import faulthandler
import gc
import random
import sys

import gl_errors
import penumbra
from vtkmodules.vtkCommonCore import vtkFloatArray, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPiecewiseFunction
from vtkmodules.vtkFiltersSources import vtkConeSource, vtkPlaneSource, vtkSphereSource
from vtkmodules.vtkImagingCore import vtkRTAnalyticSource
from vtkmodules.vtkRenderingCore import (vtkActor, vtkHardwareSelector, vtkLight, vtkPolyDataMapper, vtkRenderer,
                                         vtkTexture, vtkVolume, vtkWindowToImageFilter)
from vtkmodules.vtkRenderingVolumeOpenGL2 import vtkOpenGLGPUVolumeRayCastMapper

# Number of times that each call is drawn, relative to the others; methods of Fuzz with these names make them. Left out is
# what stock VTK does not survive without messages: depth peeling, stereo, tiled pictures and other numbers of samples, each
# with windows that change, and half of a window that is one pixel wide.
CALLS = {"render": 6, "enable": 1, "disable": 1, "preset": 1, "toggle": 1, "parameter": 2, "add": 1, "remove": 1,
         "light": 1, "resize": 1, "radiance": 1, "buffer": 1, "statistics": 1, "new_window": 1, "delete_window": 1,
         "finalize": 1, "move_renderer": 1, "remove_renderer": 1, "release": 1, "share": 1, "forget_pass": 1, "keep": 1,
         "restart": 1, "camera": 1, "reset": 1, "select": 1, "screenshot": 1, "gather": 1}


def environment(pick):
    image = vtkImageData()
    image.SetDimensions(256, 128, 1)  # VTK's prefilter reports errors for small ones
    scalars = vtkFloatArray()
    scalars.SetNumberOfComponents(3)
    scalars.SetNumberOfTuples(256 * 128)
    for channel in range(3):
        scalars.FillComponent(channel, pick.random())
    image.GetPointData().SetScalars(scalars)
    texture = vtkTexture()
    texture.MipmapOn()
    texture.InterpolateOn()
    texture.SetInputData(image)
    return texture


def surface(pick):
    source = pick.choice([vtkSphereSource, vtkConeSource, vtkPlaneSource])()
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(source.GetOutputPort())
    prop = vtkActor()
    prop.SetMapper(mapper)
    prop.SetPosition(*[pick.uniform(-2, 2) for _ in range(3)])
    prop.SetScale(pick.choice([1, 1, 0.01, 100, -1]))
    prop.GetProperty().SetOpacity(pick.choice([1, 1, 1, 0.5, 0]))
    if pick.random() < 0.3:
        prop.GetProperty().SetInterpolationToPBR()
        prop.GetProperty().SetMetallic(pick.random())
        prop.GetProperty().SetRoughness(pick.random())
    return prop


def volume(pick):
    source = vtkRTAnalyticSource()
    source.SetWholeExtent(-5, 5, -5, 5, -5, 5)
    mapper = vtkOpenGLGPUVolumeRayCastMapper()
    mapper.SetInputConnection(source.GetOutputPort())
    prop = vtkVolume()
    prop.SetMapper(mapper)
    opacity = vtkPiecewiseFunction()
    opacity.AddPoint(37, 0)
    opacity.AddPoint(277, 0.3)
    prop.GetProperty().SetScalarOpacity(opacity)
    prop.GetProperty().SetShade(pick.random() < 0.5)
    return prop


class Fuzz:
    def __init__(self, seed, stock):
        self.pick = random.Random(seed)
        self.stock = stock
        self.failures = 0
        # All windows have the same number: VTK's translucent pass does not notice if a renderer moves to a window with another.
        self.samples = self.pick.choice([0, 0, 4, 8])
        self.windows, self.renderers, self.passes = [], [], []
        self.props = []  # pairs of renderer and prop
        self.gatherer = penumbra.vtkGILightGatherer()
        self.gatherer.SetSamples(1)
        self.new_window()
        self.add()

    def fail(self, text):
        self.failures += 1
        print("FAILED:", text, flush=True)

    def choose(self):
        """Choose the window and the renderer of the next call."""
        if not self.windows or not self.renderers:
            self.new_window()
        self.window, self.renderer = self.pick.choice(self.windows), self.pick.choice(self.renderers)

    @property
    def gi(self):
        current = self.renderer.GetPass()
        return current if isinstance(current, penumbra.vtkGIPass) else None

    def technique(self):
        return self.gi.GetTechnique(self.pick.choice(penumbra.techniques()).name)

    # ------------------------------------------------------------------------------------------- windows

    def render(self):
        self.window.Render()
        gl_errors.watch()

    def new_window(self):
        if len(self.windows) >= 3:
            return
        renderers = [vtkRenderer() for _ in range(self.pick.choice([1, 1, 2]))]
        if len(renderers) == 2:
            renderers[0].SetViewport(0, 0, 0.5, 1)
            renderers[1].SetViewport(0.5, 0, 1, 1)
        self.renderers.extend(renderers)
        size = self.pick.choice([2, 16, 64, 200, 333]), self.pick.choice([1, 16, 64, 120, 217])
        self.windows.append(penumbra.window(*renderers, size=size, multisamples=self.samples))

    def delete_window(self):
        if len(self.windows) < 2:
            return
        self.windows.remove(self.window)
        for renderer in list(self.window.GetRenderers()):
            if renderer in self.renderers and self.pick.random() < 0.7:
                self.forget(renderer)
        renderer = self.window = self.renderer = None
        gc.collect()

    def finalize(self):
        self.window.Finalize()

    def resize(self):
        self.window.SetSize(self.pick.choice([2, 7, 64, 300]), self.pick.choice([1, 9, 50, 200]))

    def screenshot(self):
        capture = vtkWindowToImageFilter()
        capture.SetInput(self.window)
        capture.ReadFrontBufferOff()
        capture.Update()

    # ----------------------------------------------------------------------------------------- renderers

    def forget(self, renderer):
        self.renderers.remove(renderer)
        self.props[:] = [pair for pair in self.props if pair[0] is not renderer]

    def remove_renderer(self):
        if len(self.renderers) > 1 and self.window.HasRenderer(self.renderer):
            self.window.RemoveRenderer(self.renderer)
            self.forget(self.renderer)

    def move_renderer(self):
        owner = self.renderer.GetRenderWindow()
        if owner is not None and owner is not self.window:
            owner.RemoveRenderer(self.renderer)
            self.window.AddRenderer(self.renderer)

    def add(self):
        renderer = self.renderer if hasattr(self, "renderer") else self.renderers[0]
        prop = volume(self.pick) if self.pick.random() < 0.25 else surface(self.pick)
        renderer.AddViewProp(prop)
        self.props.append((renderer, prop))
        if self.pick.random() < 0.1:
            renderer.SetEnvironmentTexture(environment(self.pick))
            renderer.SetUseImageBasedLighting(self.pick.random() < 0.7)

    def remove(self):
        if self.props:
            owner, prop = self.props.pop(self.pick.randrange(len(self.props)))
            owner.RemoveViewProp(prop)

    def light(self):
        light = vtkLight()
        light.SetPosition(*[self.pick.uniform(-5, 5) for _ in range(3)])
        light.SetPositional(self.pick.random() < 0.5)
        light.SetConeAngle(self.pick.choice([10, 90, 180]))
        light.SetIntensity(self.pick.choice([0, 1, 1e6]))
        self.renderer.AddLight(light)

    def camera(self):
        self.renderer.GetActiveCamera().Azimuth(self.pick.uniform(-90, 90))
        self.renderer.GetActiveCamera().SetParallelProjection(self.pick.random() < 0.3)

    def reset(self):
        self.renderer.ResetCamera()

    def select(self):
        if self.window.HasRenderer(self.renderer):
            selector = vtkHardwareSelector()
            selector.SetRenderer(self.renderer)
            selector.SetArea(0, 0, *[max(0, side - 1) for side in self.window.GetSize()])
            selector.Select()

    # ------------------------------------------------------------------------------------------ the pass

    def enable(self):
        if not self.stock:
            self.passes.append(penumbra.enable(self.renderer, self.pick.choice(penumbra.presets())))

    def disable(self):
        penumbra.disable(self.renderer)

    def share(self):
        if self.passes:
            self.renderer.SetPass(self.pick.choice(self.passes))

    def forget_pass(self):
        if self.passes:
            self.passes.pop(self.pick.randrange(len(self.passes)))
            gc.collect()

    def preset(self):
        if self.gi:
            self.gi.SetPreset(self.pick.choice(penumbra.presets()))

    def toggle(self):
        if self.gi:
            technique = self.technique()
            technique.SetEnabled(not technique.GetEnabled())

    def parameter(self):
        info = self.pick.choice(penumbra.techniques())
        numbers = [p for p in info.parameters if not p.values]
        if not self.gi or not numbers:
            return
        chosen = self.pick.choice(numbers)
        value = float(self.pick.choice([chosen.minimum, min(chosen.maximum, 32), chosen.default, -1, 1e30]))
        print("  ", info.name, chosen.name, value, flush=True)
        technique = self.gi.GetTechnique(info.name)
        errors = []
        watch = technique.AddObserver("ErrorEvent", lambda *_: errors.append(1))
        accepted = technique.SetParameter(chosen.name, value)
        technique.RemoveObserver(watch)
        if accepted == bool(errors) or accepted != (chosen.minimum <= value <= chosen.maximum):
            self.fail(f"{info.name}.{chosen.name} = {value}: {'accepted' if accepted else 'refused'}, {len(errors)} errors")

    def radiance(self):
        if self.gi:
            image = vtkImageData()
            if self.gi.GetRadiance(self.renderer, image) and not self.gi.GetKeepRadiance():
                self.renderer.GetRenderWindow().Render()
                if self.gi.GetRadiance(self.renderer, image):
                    self.fail("GetRadiance() succeeds although the last frame did not keep radiance")

    def buffer(self):
        if self.gi:
            name = self.pick.choice(["gbuffer.normal", "path-tracing.albedo", "nosuch", ""])
            self.gi.GetBuffer(self.renderer, name, vtkImageData())

    def statistics(self):
        if self.gi:
            self.gi.SetCollectStatistics(self.pick.random() < 0.5)
            penumbra.statistics(self.gi)

    def keep(self):
        if self.gi:
            self.gi.SetKeepRadiance(self.pick.random() < 0.5)

    def restart(self):
        if self.gi:
            self.gi.Restart()

    def release(self):
        if self.gi:
            self.gi.ReleaseGraphicsResources(self.pick.choice([self.window, None]))

    def gather(self):
        if self.stock:
            return
        points, light = vtkPoints(), vtkFloatArray()
        points.InsertNextPoint(0.1, 0.2, 0.3)
        if self.pick.random() < 0.3:
            self.gatherer.ReleaseGraphicsResources(self.window)
        if not self.gatherer.Gather(self.renderer, points.GetData(), None, light, None):
            print("   refused:", self.gatherer.GetLastError(), flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("seed", type=int)
    parser.add_argument("calls", type=int, nargs="?", default=100)
    parser.add_argument("--stock", action="store_true", help="never set a pass")
    arguments = parser.parse_args()
    faulthandler.enable()
    fuzz = Fuzz(arguments.seed, arguments.stock)
    names = list(CALLS)
    for _ in range(arguments.calls):
        fuzz.choose()
        name = fuzz.pick.choices(names, CALLS.values())[0]
        print(name, flush=True)
        try:
            getattr(fuzz, name)()
        except (ValueError, RuntimeError) as error:
            print("   refused:", error, flush=True)
    failures = fuzz.failures + gl_errors.count
    del fuzz
    gc.collect()
    print("done," if not failures else "failed,", failures, "failures", flush=True)
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
