# SPDX-FileCopyrightText: Penumbra authors
# SPDX-License-Identifier: BSD-3-Clause
"""A renderer with one of its lights under study: what of it arrives, by shadow maps and by rays."""
import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkFloatArray, vtkUnsignedCharArray

from ..images import radiance
from ..passes import _apply
from ..vtkRenderingGI import vtkGIPass
from .measures import View

# A receiver takes at least this share of the brightest one's light: less is not seen.
DIMMEST = 1e-4


def _strength(light):
    return light.GetIntensity() * np.linalg.norm(light.GetDiffuseColor())


def positions(renderer, window):
    """World coordinates of the centre of each pixel's surface, top row first; NaN where there is none."""
    width, height = window.GetSize()
    depth = vtkFloatArray()
    window.GetZbufferData(0, 0, width - 1, height - 1, depth)
    z = vtk_to_numpy(depth).reshape(height, width)[::-1].astype(float)
    matrix = renderer.GetActiveCamera().GetCompositeProjectionTransformMatrix(
        renderer.GetTiledAspectRatio(), -1, 1)
    matrix = np.array([[matrix.GetElement(i, j) for j in range(4)] for i in range(4)])
    x = (np.arange(width) + 0.5) / width * 2 - 1
    y = 1 - (np.arange(height) + 0.5) / height * 2
    clip = np.stack(np.broadcast_arrays(x[None, :], y[:, None], 2 * z - 1, 1.0), axis=-1)
    world = clip @ np.linalg.inv(matrix).T
    world = world[..., :3] / world[..., 3:]
    world[z >= 1.0] = np.nan
    return world


class Bench:
    """Takes a renderer over: gives it a pass of its own, and switches off all lights but the strongest that casts
    shadows and headlights, which cast none and show what lies in them. Hides what is translucent, whose shadows are no
    matter of a bias. Raises a ValueError where no light can cast shadows in view.

    The window has no multisamples: a mask has one value for each pixel. Masks are the pass's linear radiance with
    shadows, between that without the light and that without shadows: materials, textures and highlights cancel out.
    """

    def __init__(self, window, renderer, **parameters):
        self.window, self.renderer = window, renderer
        self.gi = vtkGIPass()
        # One map for the whole scene, unless asked for more: a texel means the same everywhere.
        self.gi.SetPreset("balanced")
        _apply(self.gi, (), (), {"shadow-maps.cascades": 1, **parameters})
        for i in range(self.gi.GetNumberOfTechniques()):
            self.gi.GetTechnique(i).EnabledOff()
        self.maps, self.rays = self.gi.GetTechnique("shadow-maps"), self.gi.GetTechnique("ray-traced-shadows")
        for technique in (self.maps, self.rays):
            names = [technique.GetParameterName(i) for i in range(technique.GetNumberOfParameters())]
            for size in {"light-angle", "light-radius"}.intersection(names):
                technique.SetParameter(size, 0)
        self.gi.KeepRadianceOn()
        renderer.SetUseFXAA(False)
        self._choose_light()
        hidden = [prop for prop in renderer.GetViewProps() if prop.GetVisibility() and
                  (prop.HasTranslucentPolygonalGeometry() or prop.IsA("vtkVolume"))]
        for prop in hidden:
            prop.VisibilityOff()
        self.left_out = len(hidden)
        renderer.SetPass(self.gi)

    def _choose_light(self):
        on = [light for light in self.renderer.GetLights() if light.GetSwitch()]
        casting = [light for light in on if not light.LightTypeIsHeadlight() and _strength(light) > 0]
        if not casting:
            raise ValueError("no light of the scene casts shadows that its camera can see: add one that is no headlight")
        self.light = max(casting, key=_strength)
        self.other_lights = len(casting) - 1
        for light in on:
            light.SetSwitch(light is self.light or light.LightTypeIsHeadlight())

    def _shoot(self, technique=None):
        self.maps.SetEnabled(technique is self.maps)
        self.rays.SetEnabled(technique is self.rays)
        self.window.Render()
        if self.gi.GetLastError():
            raise RuntimeError(self.gi.GetLastError())
        return radiance(self.gi, self.renderer)

    def _share(self, shot):
        """The share of the light in the channel that it changes most."""
        light = (self._open - self._unlit)[..., :3]
        channel = light.argmax(axis=2)[..., None]
        most = np.take_along_axis(light, channel, 2)
        reaching = np.take_along_axis((shot - self._unlit)[..., :3], channel, 2)
        return np.clip(np.divide(reaching, most, out=np.ones_like(most), where=most > 0), 0, 1)[..., 0]

    def trace_truth(self):
        """The View, drawn without the light, without shadows and with rays. Lengths are in texels of the map as its
        parameters are now. Raises a ValueError where nothing in view is lit."""
        # Off, the light would leave VTK with none, which draws plain colours.
        intensity = self.light.GetIntensity()
        self.light.SetIntensity(0)
        self._unlit = self._shoot()
        self.light.SetIntensity(intensity)
        self._open = self._shoot()
        place = positions(self.renderer, self.window)
        surface = np.isfinite(place[..., 0]) & (self._open[..., 3] > 0)
        light = np.where(surface, np.maximum((self._open - self._unlit)[..., :3].max(axis=2), 0), 0)
        if not light.max() > 0:
            raise ValueError("the light shines on nothing in view, so that there is no shadow to study: turn the camera, "
                             "or move the light")
        receiver = light > DIMMEST * light.max()
        self.draw_mask()  # so that the map's texel is known
        across = self._place_across(place, receiver)
        truth = self._share(self._shoot(self.rays))
        return View(surface, receiver, np.minimum(light, 1), truth, place, across)  # brighter is no whiter

    def _place_across(self, place, receiver):
        """The lines of a light's rays, as points of a plane across them, or of the sphere around a lamp."""
        origin, target = (np.array(get()) for get in
                          (self.light.GetTransformedPosition, self.light.GetTransformedFocalPoint))
        texel = self.maps.GetTexelWidth()
        across = place - origin
        if self.light.GetPositional():
            distance = np.linalg.norm(across, axis=2, keepdims=True)
            across, widths = across / distance, (distance * texel)[receiver]
        else:
            axis = (target - origin) / np.linalg.norm(target - origin)
            across, widths = across - (across @ axis)[..., None] * axis, np.array([texel])
        self.texel = float(np.sort(widths.ravel())[widths.size // 2])  # in the middle of what the light reaches
        return across / texel

    def draw_mask(self):
        """The share of the light that arrives by the map; after trace_truth(), from the same camera."""
        shot = self._shoot(self.maps)
        return self._share(shot)

    def draw_truth(self):
        """Draws the view with rays, for shown()."""
        self._shoot(self.rays)

    def shown(self):
        """The picture that was drawn last, as bytes, top row first."""
        width, height = self.window.GetSize()
        pixels = vtkUnsignedCharArray()
        self.window.GetPixelData(0, 0, width - 1, height - 1, 0, pixels, 0)
        return vtk_to_numpy(pixels).reshape(height, width, 3)[::-1].copy()
