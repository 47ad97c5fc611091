# SPDX-FileCopyrightText: Penumbra authors
# SPDX-License-Identifier: BSD-3-Clause
"""A scene built twice: with ParaView's pipeline and views, and with VTK's own classes."""
import pathlib

import penumbra.paraview  # noqa: F401 first, so that windows can be created without a display
import numpy
from paraview import servermanager, simple
from PIL import Image
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkRenderingCore import vtkActor, vtkCamera, vtkLightKit, vtkPolyDataMapper, vtkRenderer
from vtkmodules.vtkRenderingCore import vtkWindowToImageFilter

SIZE = (320, 240)
# A ground plane below three isosurfaces, with a ball on it: near and distant shadows, hollows, and colours by an array.
GROUND = {"Origin": [-20, -20, -11], "Point1": [20, -20, -11], "Point2": [-20, 20, -11]}


def sources():
    """(source, array that it is coloured by or None, colour) of all visible sources."""
    wavelet = simple.Wavelet()
    surface = simple.Contour(Input=wavelet, ContourBy=["POINTS", "RTData"], Isosurfaces=[130.0, 160.0, 220.0])
    ball = simple.Sphere(Center=[9, -9, -8], Radius=3, ThetaResolution=48, PhiResolution=48)
    return [(simple.Plane(**GROUND), None, [0.8, 0.8, 0.75]), (surface, "RTData", None),
            (ball, None, [0.9, 0.3, 0.2])]


def show(view, sources):
    for source, array, colour in sources:
        shown = simple.Show(source, view, "GeometryRepresentation")
        if array:
            simple.ColorBy(shown, ("POINTS", array))
            shown.RescaleTransferFunctionToDataRange(False)
            shown.SetScalarBarVisibility(view, False)
        else:
            shown.ColorArrayName = [None, ""]
            shown.AmbientColor = shown.DiffuseColor = colour
    aim(view)


def aim(view):
    view.CameraPosition = [34, -42, 22]
    view.CameraFocalPoint = [0, 0, -4]
    view.CameraViewUp = [0, 0, 1]


def make_view(**properties):
    return prepare_view(simple.CreateView("RenderView"), **properties)


def prepare_view(view, **properties):
    """Set the size and background of a view, and other properties."""
    view.ViewSize = SIZE
    view.OrientationAxesVisibility = 0
    view.CenterAxesVisibility = 0
    view.UseColorPaletteForBackground = 0
    view.Background = [0.32, 0.34, 0.43]
    for name, value in properties.items():
        view.GetProperty(name).SetData(value)
    return view


def picture(view):
    """Render a view. Returns its picture as an array of bytes, top row first."""
    simple.Render(view)
    return capture(view)


def capture(view):
    """The picture of a view as it was drawn last."""
    reader = vtkWindowToImageFilter()
    reader.SetInput(view.GetRenderWindow())
    reader.ReadFrontBufferOff()
    reader.ShouldRerenderOff()
    reader.Update()
    image = reader.GetOutput()
    width, height, _ = image.GetDimensions()
    return vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, -1)[::-1, :, :3].copy()


def saved(target, path, size=SIZE, **options):
    """Picture of a view or layout by SaveScreenshot, as an array of bytes, top row first."""
    simple.SaveScreenshot(str(path), target, ImageResolution=list(size), **options)
    return numpy.asarray(Image.open(path))[..., :3]


def settle(view):
    """Set the preset high, and render until the probes have converged."""
    penumbra.paraview.enable(view, "high", frames=2, ddgi__probes=64, ddgi__updates=8)
    for _ in range(4):
        simple.Render(view)


def refuse_to_bake(view, path):
    """Print the error of baking probes if several processes draw a view."""
    try:
        penumbra.paraview.bake_probes(view, path, probes=27, samples=1)
    except RuntimeError as error:
        print("refused:", error, pathlib.Path(path).exists())


def vtk_renderer(view, sources):
    """The same scene in VTK's own classes, with the camera of the view and ParaView's light kit."""
    renderer = vtkRenderer()
    renderer.SetBackground(*view.Background)
    renderer.SetTwoSidedLighting(True)
    renderer.SetUseFXAA(bool(view.UseFXAA))
    renderer.SetFXAAOptions(view.GetClientSideObject().GetRenderer().GetFXAAOptions())
    for source, array, colour in sources:
        mapper = vtkPolyDataMapper()
        mapper.SetInputData(servermanager.Fetch(source))
        actor = vtkActor()
        actor.SetMapper(mapper)
        if array:
            table = simple.GetColorTransferFunction(array)
            mapper.SetLookupTable(table.GetClientSideObject())
            mapper.SetScalarModeToUsePointFieldData()
            mapper.SelectColorArray(array)
            mapper.InterpolateScalarsBeforeMappingOn()
        else:
            mapper.ScalarVisibilityOff()
            actor.GetProperty().SetColor(*colour)
        renderer.AddActor(actor)
    camera = vtkCamera()
    camera.DeepCopy(view.GetClientSideObject().GetActiveCamera())
    renderer.SetActiveCamera(camera)
    renderer.RemoveAllLights()
    renderer.AutomaticLightCreationOff()
    kit = vtkLightKit()
    kit.AddLightsToRenderer(renderer)
    kit.Update()
    return renderer


def within(one, other, limit=2):
    """Share of pixels whose components all differ by at most a limit."""
    difference = numpy.abs(one.astype(int) - other.astype(int)).max(axis=2)
    return float((difference <= limit).mean())
