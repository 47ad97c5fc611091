# SPDX-FileCopyrightText: Penumbra authors
# SPDX-License-Identifier: BSD-3-Clause
"""The ground: a catcher equals a ground that is modelled, on any background, and is no prop."""
import tempfile
import unittest

import numpy as np
import penumbra
from PIL import Image
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkFloatArray
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPiecewiseFunction
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm
from vtkmodules.vtkFiltersSources import vtkPlaneSource, vtkSphereSource
from vtkmodules.vtkRenderingCore import (
    vtkActor, vtkCellPicker, vtkColorTransferFunction, vtkLight, vtkPolyDataMapper, vtkRenderer, vtkTexture, vtkVolume)
from vtkmodules.vtkRenderingVolumeOpenGL2 import vtkOpenGLGPUVolumeRayCastMapper

WIDTH, HEIGHT = 200, 150
UP = np.array((0.0, 0.0, 1.0))


def texture(colors):
    """An unfiltered texture of bytes of shape (height, width, 3), top row first."""
    image = vtkImageData()
    image.SetDimensions(colors.shape[1], colors.shape[0], 1)
    image.GetPointData().SetScalars(numpy_to_vtk(np.ascontiguousarray(colors[::-1].reshape(-1, 3)), deep=True))
    made = vtkTexture()
    made.SetInputData(image)
    made.InterpolateOff()
    made.SetColorModeToDirectScalars()
    return made


CHECKERS = np.kron(np.indices((16, 16)).sum(0) % 2, np.ones((8, 8)))[..., None].repeat(3, 2)
CHECKERS = (CHECKERS * 100 + 100).astype(np.uint8)


def matte(source, color=(0.9, 0.4, 0.3)):
    mapper, actor = vtkPolyDataMapper(), vtkActor()
    mapper.SetInputConnection(source.GetOutputPort())
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(*color)
    actor.GetProperty().SetAmbient(0)
    return actor


def ball(center=(0, 0, 1), radius=1.0, **look):
    source = vtkSphereSource()
    source.SetCenter(*center)
    source.SetRadius(radius)
    source.SetThetaResolution(48)
    source.SetPhiResolution(48)
    source.SetOutputPointsPrecision(vtkAlgorithm.DOUBLE_PRECISION)
    return matte(source, **look)


def floor(half, origin=(0, 0, 0)):
    """A white square in the plane z = 0, with a texture of checkers."""
    source = vtkPlaneSource()
    source.SetOrigin(origin[0] - half, origin[1] - half, origin[2])
    source.SetPoint1(origin[0] + half, origin[1] - half, origin[2])
    source.SetPoint2(origin[0] - half, origin[1] + half, origin[2])
    actor = matte(source, (1, 1, 1))
    actor.SetTexture(texture(CHECKERS))
    return actor


class View:
    """A renderer in a window, seen from the side and above. turn: maps the scene's axes; origin: its place."""

    def __init__(self, *props, background=(0, 0, 0), camera=(4, -7, 5), light=(-5, -1, 5), turn=np.eye(3), origin=(0, 0, 0),
                 parallel=False):
        self.renderer = vtkRenderer()
        self.renderer.AutomaticLightCreationOff()
        self.renderer.SetBackground(*background)
        for prop in props:
            self.renderer.AddViewProp(prop)
        origin = np.array(origin, float)
        lamp = vtkLight()
        lamp.SetLightTypeToSceneLight()
        lamp.SetPosition(*(origin + turn @ np.array(light, float)))
        lamp.SetFocalPoint(*origin)
        self.renderer.AddLight(lamp)
        eye = self.renderer.GetActiveCamera()
        eye.SetPosition(*(origin + turn @ np.array(camera, float)))
        eye.SetFocalPoint(*(origin + turn @ np.array((0, 0, 0.5))))
        eye.SetViewUp(*(turn @ UP))
        eye.SetParallelProjection(parallel)
        eye.SetParallelScale(3)
        self.window = penumbra.window(self.renderer, size=(WIDTH, HEIGHT), multisamples=0)
        self.window.SetAlphaBitPlanes(1)
        self.renderer.ResetCameraClippingRange()

    def draw(self, *on, frames=1, alpha=False, **parameters):
        """The picture with these techniques, as whole numbers."""
        gi = penumbra.enable(self.renderer, "off", on=on, off="anti-aliasing", **parameters)
        picture = penumbra.render(self.window, frames, alpha).astype(int)
        assert not gi.GetLastError(), gi.GetLastError()
        return picture


def within(one, other, tolerance, where=None):
    """Share of pixels whose every channel differs by at most the tolerance."""
    same = np.abs(one - other).max(axis=2) <= tolerance
    return same.mean() if where is None else same[where].mean()


def beside_the_ball(**where):
    """The pixels that a ball leaves to the background."""
    return (View(ball(), background=(0, 0, 1), **where).draw() == (0, 0, 255)).all(axis=2)


SHADOWS = ("shadow-maps",)
BOTH = ("shadow-maps", "ambient-occlusion")
LARGE = {"ground.size": 30}  # beyond the picture's borders, so that nothing fades


class Catcher(unittest.TestCase):
    def check_modelled(self, techniques, name, parallel=False, **parameters):
        """The catcher in front of a picture of the floor without the ball equals the floor with the ball."""
        above = {"camera": (3, -4, 9), "parallel": parallel}  # so that a small floor, and thus a fine shadow map, fills the picture
        whole = View(floor(7), **above).draw(*techniques, **parameters)
        modelled = View(floor(7), ball(), **above)
        truth = modelled.draw(*techniques, **parameters)
        bare = View(ball(), **above)
        bare.renderer.TexturedBackgroundOn()
        bare.renderer.SetBackgroundTexture(texture(whole.astype(np.uint8)))
        bare.renderer.GetActiveCamera().SetClippingRange(modelled.renderer.GetActiveCamera().GetClippingRange())
        caught = bare.draw(*techniques, "ground", **LARGE, **parameters)
        ground = beside_the_ball(**above)
        share = within(caught, truth, 2, ground)
        dark = (whole - truth).max(axis=2)[ground] > 20
        print(f"{name}: {100 * share:.2f} % of the ground's pixels within 2/255, {100 * dark.mean():.1f} % in shadow")
        self.assertGreater(dark.mean(), 0.02)
        self.assertLess(dark.mean(), 0.5)
        self.assertGreaterEqual(share, 0.995)

    def test_shadow_of_a_light_equals_a_modelled_ground(self):
        self.check_modelled(SHADOWS, "directional light")

    def test_occlusion_equals_a_modelled_ground(self):
        self.check_modelled(BOTH, "light and ambient share", ambient_occlusion__ambient_share=0.6,
                            ambient_occlusion__radius=2, ambient_occlusion__interreflection=0)

    def test_path_tracer_agrees(self):
        view = View(ball(), background=(0.8, 0.8, 0.8))
        raster = view.draw(*SHADOWS, "ground", **LARGE)
        traced = view.draw("path-tracing", "ground", frames=32, path_tracing__samples=32, **LARGE)
        bare = View(ball(), background=(0.8, 0.8, 0.8)).draw()
        ground = bare[..., 0] == bare[0, 0, 0]
        share = within(raster, traced, 8, ground)
        print(f"path tracer: {100 * share:.2f} % of the ground's pixels within 8/255")
        self.assertGreater((traced[ground].max(axis=1) < 20).mean(), 0.02, "a shadow")
        self.assertGreater(share, 0.97, "the rest are edges, which paths smooth")

    def test_alpha_holds_the_shadow(self):
        """Composited over a colour, the picture with alpha equals the one drawn over that colour."""
        for techniques, frames in ((BOTH, 1), (("path-tracing",), 4)):
            clear = View(ball()).draw(*techniques, "ground", frames=frames, alpha=True)
            self.assertEqual(clear[0, 0].tolist(), [0, 0, 0, 0])
            for color in ((1, 1, 1), (0.2, 0.6, 0.4)):
                drawn = View(ball(), background=color).draw(*techniques, "ground", frames=frames)
                over = clear[..., :3] + (255 - clear[..., 3:]) * np.array(color)
                share = within(np.rint(over).astype(int), drawn, 1)
                print(f"{techniques}: {100 * share:.2f} % of the pixels over {color} within 1/255")
                changed = (np.abs(drawn - np.rint(np.array(color) * 255)) > 20).any(axis=2)
                self.assertGreater(changed[beside_the_ball()].mean(), 0.02, "a shadow")
                self.assertEqual(share, 1)

    def test_png_files_hold_straight_alpha(self):
        for behind in ((0, 0, 0), (1, 1, 1)):
            clear = View(ball(), background=behind)
            clear.renderer.SetBackgroundAlpha(0)
            over = View(ball(), background=(0.2, 0.6, 0.4))
            for view in (clear, over):
                penumbra.enable(view.renderer, "off", on=(*SHADOWS, "ground"), **{"anti-aliasing.mode": "accumulate"})
            with tempfile.TemporaryDirectory() as folder:
                penumbra.save_png(clear.window, folder + "/clear.png", frames=8, alpha=True)
                with Image.open(folder + "/clear.png") as file:
                    straight = np.asarray(file, float)
            share = straight[..., 3:] / 255
            laid = share * straight[..., :3] + (1 - share) * 255 * np.array((0.2, 0.6, 0.4))
            drawn = penumbra.render(over.window, frames=8)
            self.assertGreater(((share > 0.2) & (share < 0.8)).mean(), 0.003, "edges")
            self.assertGreater(within(laid, drawn.astype(int), 3), 0.999)

    def test_nothing_changes_without_shadows(self):
        view = View(ball(), background=(0.2, 0.3, 0.4))
        self.assertEqual(within(view.draw("ground"), view.draw(), 0), 1)

    def test_it_is_no_prop(self):
        view = View(ball())
        without = np.array(view.renderer.ComputeVisiblePropBounds()), view.renderer.GetViewProps().GetNumberOfItems()
        view.draw(*SHADOWS, "ground")
        self.assertTrue(np.array_equal(view.renderer.ComputeVisiblePropBounds(), without[0]))
        self.assertEqual(view.renderer.GetViewProps().GetNumberOfItems(), without[1])
        picker = vtkCellPicker()
        self.assertEqual(picker.Pick(WIDTH // 2, HEIGHT // 2, 0, view.renderer), 1)
        self.assertEqual(picker.Pick(5, 5, 0, view.renderer), 0)
        self.assertEqual(view.renderer.GetZ(5, 5), 1, "no depth where the ground catches shadows")
        view.renderer.ResetCamera()
        distance = view.renderer.GetActiveCamera().GetDistance()
        penumbra.disable(view.renderer)
        view.renderer.ResetCamera()
        self.assertAlmostEqual(view.renderer.GetActiveCamera().GetDistance(), distance)

    def test_depth_does_not_move_while_still_frames_shift_the_picture(self):
        for kind in ("catcher", "surface"):
            view = View(ball(), background=(0.8, 0.8, 0.8))
            gi = penumbra.enable(view.renderer, "off", on=(*SHADOWS, "ground"),
                                 **{"ground.kind": kind, "anti-aliasing.mode": "accumulate"})
            depths = []
            for frames in (1, 4):
                penumbra.render(view.window, frames)
                values = vtkFloatArray()
                view.window.GetZbufferData(0, 0, WIDTH - 1, HEIGHT - 1, values)
                depths.append(vtk_to_numpy(values).copy())
            self.assertEqual(gi.GetLastError(), "")
            self.assertGreater((depths[0] < 1).mean(), 0.1)
            self.assertTrue(np.array_equal(depths[0], depths[1]), kind)

    def test_it_is_not_seen_from_below(self):
        for parallel in (False, True):
            view = View(ball(), background=(0.8, 0.8, 0.8), camera=(3, -6, -3), parallel=parallel)
            for kind in ("catcher", "surface"):
                self.assertEqual(within(view.draw(*SHADOWS, "ground", ground__kind=kind), view.draw(*SHADOWS), 0), 1)

    def test_up(self):
        """The same scene, turned with its camera, gives the same picture with that axis up."""
        picture = View(ball(), background=(0.8, 0.8, 0.8)).draw(*SHADOWS, "ground", shadow_maps__cascades=1)
        for name, turn in (("y", np.array(((0, 1, 0), (0, 0, 1), (1, 0, 0)))),
                           ("minus-x", np.array(((0, 0, -1), (0, 1, 0), (1, 0, 0))))):
            prop = ball(tuple(turn @ UP))
            for up in (name, "automatic"):
                turned = View(prop, background=(0.8, 0.8, 0.8), turn=turn).draw(
                    *SHADOWS, "ground", ground__up=up, shadow_maps__cascades=1)
                self.assertGreater(within(turned, picture, 40), 0.985, f"{name}, {up}")
            wrong = View(prop, background=(0.8, 0.8, 0.8), turn=turn).draw(*SHADOWS, "ground", ground__up="z")
            self.assertLess(within(wrong, picture, 40), 0.96)

    def test_automatic_up_stays_while_the_camera_orbits(self):
        view = View(ball(), background=(0.8, 0.8, 0.8))
        for _ in range(2):
            automatic = view.draw(*SHADOWS, "ground")
            view.renderer.GetActiveCamera().Elevation(70)
            view.renderer.GetActiveCamera().OrthogonalizeViewUp()
            view.renderer.ResetCameraClippingRange()
            self.assertGreater(abs(view.renderer.GetActiveCamera().GetViewUp()[1]), 0.8)
            automatic = view.draw(*SHADOWS, "ground")
            self.assertEqual(within(automatic, view.draw(*SHADOWS, "ground", ground__up="z"), 0), 1)
            view.renderer.GetActiveCamera().Elevation(-70)

    def test_parallel_projection_equals_a_modelled_ground(self):
        self.check_modelled(SHADOWS, "parallel projection", parallel=True)

    def test_large_coordinates(self):
        origin = (1e6, -2e6, 1e6)
        view = View(ball(tuple(np.array(origin) + UP)), origin=origin, background=(0.8, 0.8, 0.8))
        near = View(ball(), background=(0.8, 0.8, 0.8))
        for techniques in (BOTH, ("path-tracing",)):
            self.assertGreater(within(view.draw(*techniques, "ground", frames=4), near.draw(*techniques, "ground", frames=4), 12), 0.995)

    def test_it_follows_the_props(self):
        moving = ball()
        view = View(moving, background=(0.8, 0.8, 0.8))
        for techniques, frames in ((SHADOWS, 1), (("path-tracing",), 8)):
            first = view.draw(*techniques, "ground", frames=frames)
            moving.SetPosition(1, 1, -0.5)
            second = view.draw(*techniques, "ground", frames=frames)
            self.assertLess(within(first, second, 20), 0.95)
            fresh = View(ball((1, 1, 0.5)), background=(0.8, 0.8, 0.8)).draw(*techniques, "ground", frames=frames)
            self.assertGreater(within(second, fresh, 20), 0.98)
            moving.SetPosition(0, 0, 0)

    def test_beyond_the_clipping_range(self):
        """A narrow clipping range cuts props, not the ground."""
        view = View(ball(), background=(0.8, 0.8, 0.8))
        wide = view.draw(*SHADOWS, "ground", shadow_maps__cascades=1, **LARGE)
        whole = view.draw()
        bare = whole[..., 0] == 204
        view.renderer.GetActiveCamera().SetClippingRange(8.5, 9.3)
        narrow = view.draw(*SHADOWS, "ground", shadow_maps__cascades=1, **LARGE)
        cut = view.draw(*SHADOWS, shadow_maps__cascades=1)
        self.assertLess(within(view.draw(), whole, 20), 0.99, "the range cuts the ball")
        self.assertGreater(within(narrow, wide, 20, bare), 0.995)
        self.assertGreater(within(narrow, cut, 2, cut[..., 0] != 204), 0.99)

    def test_translucent_props_and_volumes(self):
        """They are drawn over the ground, in front of it and beneath it."""
        def volume():
            image = vtkImageData()
            image.SetDimensions(8, 8, 8)
            image.SetOrigin(-1, -1, 0.0)
            image.SetSpacing(0.25, 0.25, 0.25)
            image.GetPointData().SetScalars(numpy_to_vtk(np.full(512, 200, np.uint8), deep=True))
            mapper, prop = vtkOpenGLGPUVolumeRayCastMapper(), vtkVolume()
            mapper.SetInputData(image)
            mapper.AutoAdjustSampleDistancesOff()
            mapper.SetSampleDistance(0.05)
            colors, opacities = vtkColorTransferFunction(), vtkPiecewiseFunction()
            colors.AddRGBPoint(0, 0, 1, 0)
            colors.AddRGBPoint(255, 0, 1, 0)
            opacities.AddPoint(0, 0.5)
            opacities.AddPoint(255, 0.5)
            prop.SetMapper(mapper)
            prop.GetProperty().SetColor(colors)
            prop.GetProperty().SetScalarOpacity(opacities)
            return prop

        def glass():
            prop = ball(color=(0, 1, 0))
            prop.GetProperty().SetOpacity(0.5)
            return prop

        for name, made in (("glass", glass), ("volume", volume)):
            view = View(made(), background=(0.8, 0.2, 0.8))
            plain = view.draw(*SHADOWS)
            covered = (plain != plain[0, 0]).any(axis=2)
            self.assertGreater(covered.mean(), 0.05, name)
            above = covered & (np.arange(HEIGHT) < HEIGHT // 2 - 8)[:, None]
            self.assertGreater(within(view.draw("ground", *SHADOWS), plain, 3, above), 0.99, f"{name} in front")
            beneath = view.draw("ground", *SHADOWS, ground__offset=3)
            self.assertGreater(within(beneath, plain, 3), 0.99, f"{name} beneath")
        with self.subTest("a ground of kind surface hides what is beneath it"):
            view = View(glass(), ball((0, 0, 0.5), 0.5), background=(0.8, 0.2, 0.8))
            hidden = view.draw("ground", ground__kind="surface", ground__offset=3, **LARGE)
            self.assertLess(np.ptp(hidden[HEIGHT // 2, WIDTH // 2]), 3)


class Surface(unittest.TestCase):
    def test_it_equals_a_modelled_ground(self):
        look = {f"ground.{channel}": 0.6 for channel in ("red", "green", "blue")}
        white = matte(vtkPlaneSource(), (0.6, 0.6, 0.6))
        white.SetScale(120, 120, 1)
        for techniques, frames, tolerance in ((BOTH, 1, 2), (("path-tracing",), 16, 24)):
            modelled = View(ball(), white)
            view = View(ball())
            view.renderer.GetActiveCamera().SetClippingRange(modelled.renderer.GetActiveCamera().GetClippingRange())
            more = {"ambient-occlusion.radius": 1} if techniques == BOTH else {}
            truth = modelled.draw(*techniques, frames=frames, **more)
            share = within(view.draw(*techniques, "ground", frames=frames, ground__kind="surface", **LARGE, **look,
                                     **more), truth, tolerance)
            print(f"surface, {techniques}: {100 * share:.2f} % within {tolerance}/255")
            self.assertGreater(share, 0.985)

    def test_a_floor_at_its_height_hides_it(self):
        for camera in ((4, -7, 5), (1, -3, 8), (6, -6, 2)):
            view = View(ball(), floor(3), camera=camera)
            own = view.draw()
            red = {"ground.kind": "surface", "ground.green": 0, "ground.blue": 0}
            with_ground = view.draw("ground", **red)
            coloured = with_ground[..., 0] - with_ground[..., 2] > 40
            on_floor = own.max(axis=2) > 0
            self.assertGreater((coloured & ~on_floor).sum(), 100, "no ground beside the floor")
            self.assertGreater(within(own, with_ground, 1, on_floor), 0.995)

    def test_light_bounces_off_it(self):
        view = View(ball(color=(1, 1, 1)))
        black = {f"ground.{channel}": 0 for channel in ("red", "green", "blue")}
        for techniques in (("ddgi",), ("path-tracing",)):
            dark = view.draw(*techniques, "ground", frames=24, ground__kind="surface", **black)
            red = view.draw(*techniques, "ground", frames=24, ground__kind="surface", **{**black, "ground.red": 1})
            center = red[HEIGHT // 2:HEIGHT // 2 + 10, WIDTH // 2 - 5:WIDTH // 2 + 5].mean(axis=(0, 1))
            before = dark[HEIGHT // 2:HEIGHT // 2 + 10, WIDTH // 2 - 5:WIDTH // 2 + 5].mean(axis=(0, 1))
            self.assertGreater(center[0] - before[0], 5, techniques)
            self.assertLess(abs(center[1] - before[1]), 3, techniques)


if __name__ == "__main__":
    unittest.main()
