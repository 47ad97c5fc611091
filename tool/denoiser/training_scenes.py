# SPDX-FileCopyrightText: Penumbra authors
# SPDX-License-Identifier: BSD-3-Clause
"""Scenes to train the denoiser on, made from random numbers alone: what scientists look at, and rooms lit by panels.

make(family, seed) is the same scene on each machine. TUBES and PLATES are never trained on: they show how the network does on
what it has not seen.
"""
import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkImageData, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkAppendPolyData, vtkFlyingEdges3D, vtkGlyph3D, vtkPolyDataNormals, vtkTubeFilter
from vtkmodules.vtkFiltersSources import (vtkArrowSource, vtkConeSource, vtkCubeSource, vtkLineSource, vtkPlaneSource,
                                          vtkSphereSource)
from vtkmodules.vtkRenderingCore import vtkActor, vtkLight, vtkPolyDataMapper, vtkRenderer, vtkTexture

GRID = 80      # points of a volume along each axis
FIELD = 200    # points of a terrain along each axis


def output(source):
    """The data of a source."""
    source.Update()
    return source.GetOutput()


def painted(data, random, color=None):
    """An actor of a random colour, without highlights."""
    mapper, actor = vtkPolyDataMapper(), vtkActor()
    mapper.SetInputDataObject(data)
    mapper.ScalarVisibilityOff()
    actor.SetMapper(mapper)
    look = actor.GetProperty()
    look.SetColor(random.uniform(0.1, 0.95, 3) if color is None else color)
    look.SetAmbient(0)
    look.SetSpecular(0)
    return actor


def box(low, high):
    """A mesh of a box between two corners."""
    cube = vtkCubeSource()
    cube.SetBounds(*np.stack((low, high), 1).ravel())
    return output(cube)


def joined(meshes):
    """One mesh of several."""
    append = vtkAppendPolyData()
    for mesh in meshes:
        append.AddInputData(mesh)
    return output(append)


def placed(source, places, turned=None, size=1):
    """A mesh of copies of a source at points, turned in directions."""
    points, data, glyph = vtkPoints(), vtkPolyData(), vtkGlyph3D()
    points.SetData(numpy_to_vtk(places, deep=True))
    data.SetPoints(points)
    if turned is not None:
        data.GetPointData().SetVectors(numpy_to_vtk(turned, deep=True))
    glyph.SetInputData(data)
    glyph.SetSourceConnection(source.GetOutputPort())
    glyph.SetScaleModeToDataScalingOff()
    glyph.SetScaleFactor(size)
    return output(glyph)


def floor(random):
    """A ground below the scene, in most scenes."""
    if random.random() > 0.7:
        return []
    plane = vtkPlaneSource()
    plane.SetOrigin(-2, -2, -1)
    plane.SetPoint1(2, -2, -1)
    plane.SetPoint2(-2, 2, -1)
    return [painted(output(plane), random)]


def isosurface(function, value):
    """Where a function of x, y and z has a value, within the cube from -1 to 1."""
    axis = np.linspace(-1, 1, GRID)
    z, y, x = np.meshgrid(axis, axis, axis, indexing="ij")
    image, contour = vtkImageData(), vtkFlyingEdges3D()
    image.SetDimensions(GRID, GRID, GRID)
    image.SetSpacing(*[2 / (GRID - 1)] * 3)
    image.SetOrigin(-1, -1, -1)
    image.GetPointData().SetScalars(numpy_to_vtk(function(x, y, z).astype(np.float32).ravel(), deep=True))
    contour.SetInputData(image)
    contour.SetValue(0, value)
    return output(contour)


def fourier(random):
    """An isosurface of a sum of waves."""
    most = random.uniform(4, 14)
    waves = [(random.uniform(-most, most, 3), random.uniform(0, 2 * np.pi), random.uniform(0.3, 1)) for _ in range(12)]

    def field(x, y, z):
        return sum(size * np.cos(k[0] * x + k[1] * y + k[2] * z + phase) for k, phase, size in waves)
    return [painted(isosurface(field, random.uniform(-0.5, 1.5)), random)]


def cloud(random):
    """A rough isosurface: of noise whose spectrum falls with a power of the frequency, denser in the middle."""
    wave = np.fft.fftfreq(GRID) * GRID
    length = np.sqrt(sum(values ** 2 for values in np.meshgrid(wave, wave, wave)))
    length[0, 0, 0] = 1
    spectrum = np.fft.fftn(random.normal(size=(GRID,) * 3)) * length ** -random.uniform(2.2, 3.2)
    noise = np.fft.ifftn(spectrum).real
    noise *= random.uniform(0.1, 0.4) / noise.std()

    def field(x, y, z):
        return noise - np.sqrt(x * x + y * y + z * z)
    return [painted(isosurface(field, -random.uniform(0.55, 0.8)), random)] + floor(random)


def gyroid(random):
    """A surface that divides space in two labyrinths."""
    scale = random.uniform(3, 14)

    def field(x, y, z):
        x, y, z = scale * x, scale * y, scale * z
        return np.sin(x) * np.cos(y) + np.sin(y) * np.cos(z) + np.sin(z) * np.cos(x)
    return [painted(isosurface(field, random.uniform(-0.7, 0.7)), random)]


def metaballs(random):
    """Balls that melt into each other."""
    balls = [(random.uniform(-0.7, 0.7, 3), random.uniform(0.1, 0.3)) for _ in range(14)]

    def field(x, y, z):
        return sum(r * r / ((x - c[0]) ** 2 + (y - c[1]) ** 2 + (z - c[2]) ** 2 + 1e-3) for c, r in balls)
    return [painted(isosurface(field, random.uniform(1.2, 3)), random)] + floor(random)


def glyphs(random):
    """Glyphs of one kind, turned at random."""
    count = int(60 * 20 ** random.random())
    source = (vtkSphereSource, vtkConeSource, vtkCubeSource, vtkArrowSource)[random.integers(4)]()
    places, directions = random.uniform(-0.9, 0.9, (count, 3)), random.normal(size=(count, 3))
    mesh = placed(source, places, directions, random.uniform(0.5, 1.5) * count ** (-1 / 3))
    return [painted(mesh, random)] + floor(random)


def terrain(random):
    """Heights whose spectrum falls with a power of the frequency."""
    wave = np.fft.fftfreq(FIELD) * FIELD
    length = np.hypot(*np.meshgrid(wave, wave))
    length[0, 0] = 1
    spectrum = np.fft.fft2(random.normal(size=(FIELD, FIELD))) * length ** -random.uniform(1.6, 2.6)
    heights = np.fft.ifft2(spectrum).real
    heights = -np.abs(heights) if random.random() < 0.5 else heights  # ridges
    heights *= random.uniform(0.25, 0.8) / np.abs(heights).max()
    axis = np.linspace(-1, 1, FIELD)
    plane, points, normals = vtkPlaneSource(), vtkPoints(), vtkPolyDataNormals()
    plane.SetResolution(FIELD - 1, FIELD - 1)
    data = output(plane)
    x, y = np.meshgrid(axis, axis)
    points.SetData(numpy_to_vtk(np.stack((x, y, heights), -1).reshape(-1, 3), deep=True))
    data.SetPoints(points)
    data.GetPointData().Initialize()
    normals.SetInputData(data)
    normals.SplittingOff()
    return [painted(output(normals), random)]


def rod(start, end, radius):
    """A tube between two points."""
    line, tube = vtkLineSource(), vtkTubeFilter()
    line.SetPoint1(start)
    line.SetPoint2(end)
    tube.SetInputConnection(line.GetOutputPort())
    tube.SetRadius(radius)
    tube.SetNumberOfSides(12)
    return output(tube)


def sticks(random):
    """Balls and sticks, as molecules are drawn."""
    meshes, place = [], np.zeros(3)
    for _ in range(random.integers(20, 70)):
        ball = vtkSphereSource()
        ball.SetCenter(place)
        ball.SetRadius(random.uniform(0.05, 0.12))
        ball.SetThetaResolution(16)
        ball.SetPhiResolution(12)
        following = np.clip(place + 0.22 * random.normal(size=3), -0.9, 0.9)
        meshes += [output(ball), rod(place, following, 0.03)]
        place = following
    return [painted(joined(meshes), random)] + floor(random)


def balls(random):
    """Balls close together in one colour, or in a few, as atoms of a molecule are drawn."""
    count, kinds = int(40 * 40 ** random.random()), int(random.integers(1, 4))
    places = random.normal(size=(count, 3))
    places *= 0.85 * random.random((count, 1)) ** (1 / 3) / np.linalg.norm(places, axis=1)[:, None]
    places *= random.uniform(0.5, 1, 3)
    size, actors = random.uniform(0.5, 1.1) * count ** (-1 / 3), []
    for kind in range(kinds):
        ball = vtkSphereSource()
        ball.SetRadius(size * (0.7 + 0.3 * kind / kinds))
        ball.SetThetaResolution(16)
        ball.SetPhiResolution(12)
        actors.append(painted(placed(ball, places[kind::kinds]), random))
    return actors + floor(random)


def bars(random):
    """Columns of various heights beside each other."""
    count, filled = int(random.integers(5, 30)), random.uniform(0.5, 0.95)
    width, steep, meshes = 2 / count, random.uniform(0.2, 1.4), []
    for x in range(count):
        for y in range(count):
            low = np.array((-1 + width * x, -1 + width * y, -1))
            meshes.append(box(low, low + (filled * width, filled * width, 0.02 + steep * random.random() ** 2)))
    return [painted(joined(meshes), random)] + floor(random)


def furniture(random):
    """What stands in a room: boxes, or something else."""
    actors = []
    for _ in range(random.integers(2, 7)):
        half, center = random.uniform(0.08, 0.35, 3), random.uniform(-0.8, 0.8, 3)
        center[2] = half[2] - 1 if random.random() < 0.7 else center[2]  # most stand on the floor
        actors.append(painted(box(center - half, center + half), random))
    if random.random() < 0.5:
        thing = (fourier, cloud, metaballs, balls, sticks)[random.integers(5)](random)[0]
        thing.SetScale(random.uniform(0.4, 0.8))
        thing.SetPosition(0, 0, random.uniform(-0.5, 0))
        actors = actors[::3] + [thing]
    return actors


def room(random):
    """A room without its front wall, mostly lit by panels below its ceiling."""
    actors = []
    for axis in range(3):
        for side in (-1, 1):
            if (axis, side) == (1, -1):
                continue
            low, high = -np.ones(3), np.ones(3)
            low[axis], high[axis] = sorted((side, 1.02 * side))
            actors.append(painted(box(low, high), random))
    actors += furniture(random)
    for _ in range(random.integers(0, 4)):
        half, center = np.append(0.02 * 20 ** random.random(2), 0.005), np.append(random.uniform(-0.6, 0.6, 2), 0.975)
        panel = painted(box(center - half, center + half), random, (0, 0, 0))
        panel.GetProperty().SetAmbient(1)
        panel.GetProperty().SetAmbientColor(random.uniform(0.6, 1, 3) * random.uniform(2, 12))
        actors.append(panel)
    return actors


def curve(points, radius):
    """A tube along points."""
    places, cells, data, tube = vtkPoints(), vtkCellArray(), vtkPolyData(), vtkTubeFilter()
    places.SetData(numpy_to_vtk(points, deep=True))
    cells.InsertNextCell(len(points), list(range(len(points))))
    data.SetPoints(places)
    data.SetLines(cells)
    tube.SetInputData(data)
    tube.SetRadius(radius)
    tube.SetNumberOfSides(12)
    return output(tube)


def tubes(random):
    """A bundle of tubes along smooth curves."""
    time, orders = np.linspace(0, 1, 40)[:, None, None], np.arange(1, 5)
    meshes = []
    for _ in range(random.integers(12, 40)):
        sizes, phases = random.normal(size=(3, 4)), random.uniform(0, 2 * np.pi, (3, 4))
        points = random.uniform(-0.6, 0.6, 3) + 0.4 * (sizes / orders * np.sin(2.2 * orders * time + phases)).sum(2)
        meshes.append(curve(points, random.uniform(0.015, 0.05)))
    return [painted(joined(meshes), random)] + floor(random)


def plates(random):
    """A plate with holes above thin bars."""
    count = int(random.integers(5, 12))
    width, meshes = 2 / count, []
    for x in range(count):
        for y in range(count):
            if random.random() < 0.75:
                center = np.array((-1 + width * (x + 0.5), -1 + width * (y + 0.5), 0.2))
                half = np.append([width * random.uniform(0.3, 0.5)] * 2, 0.025)
                meshes.append(box(center - half, center + half))
    for x in random.uniform(-1, 1, 8):
        meshes.append(box((x - 0.02, -1, -0.3), (x + 0.02, 1, -0.26)))
    return [painted(joined(meshes), random)] + floor(random)


TRAINED = {family.__name__: family for family in (fourier, cloud, gyroid, metaballs, glyphs, terrain, sticks, balls, bars,
                                                    room)}
HELD_OUT = {family.__name__: family for family in (tubes, plates)}


def add_sky(renderer, random):
    """Surroundings that change from the ground to the zenith."""
    height = np.linspace(0, 1, 8)[:, None, None]
    low, high = random.uniform(0.1, 0.8, 3), random.uniform(0.2, 1.2, 3)
    pixels = np.broadcast_to(low + height * (high - low), (8, 16, 3))
    image, texture = vtkImageData(), vtkTexture()
    image.SetDimensions(16, 8, 1)
    image.GetPointData().SetScalars(numpy_to_vtk(np.ascontiguousarray(pixels, np.float32).reshape(-1, 3), deep=True))
    texture.SetInputData(image)
    texture.SetColorModeToDirectScalars()
    texture.InterpolateOn()
    texture.MipmapOn()
    renderer.SetEnvironmentTexture(texture)
    renderer.UseImageBasedLightingOn()
    renderer.SetEnvironmentUp(0, 0, 1)
    renderer.SetEnvironmentRight(1, 0, 0)
    # VTK's own tables, which only its highlights use, are made as small as possible.
    renderer.GetEnvMapPrefiltered().SetPrefilterMaxSamples(2)
    renderer.GetEnvMapPrefiltered().SetPrefilterLevels(2)
    renderer.GetEnvMapIrradiance().SetIrradianceSize(8)
    renderer.GetEnvMapIrradiance().SetIrradianceStep(0.3)
    renderer.GetEnvMapLookupTable().SetLUTSize(8)
    renderer.GetEnvMapLookupTable().SetLUTSamples(8)


def add_lights(renderer, random, inside):
    """Up to three lights; in a room at most one. Without a light VTK would add one, so a faint one takes its place."""
    renderer.AutomaticLightCreationOff()
    glows = any(actor.GetProperty().GetAmbient() > 0 for actor in renderer.GetActors())
    count = int(random.integers(0 if glows else 1, 2) if inside else random.integers(1, 4))
    for _ in range(max(count, 1)):
        light = vtkLight()
        light.SetLightTypeToSceneLight()
        direction = random.normal(size=3)
        direction[2] = abs(direction[2]) + 0.3
        place = np.append(random.uniform(-0.8, 0.8, 2), 0.7) if inside else 4 * direction / np.linalg.norm(direction)
        light.SetPosition(place)
        light.SetFocalPoint(0, 0, 0)
        light.SetIntensity(random.uniform(0.4, 1.2) if count else 1e-9)
        light.SetColor(random.uniform(0.6, 1, 3))
        if inside or random.random() < 0.5:
            light.PositionalOn()
            light.SetConeAngle(180)
        if inside and random.random() < 0.5:  # what it lights on a wall is much like a lamp
            light.SetFocalPoint(random.uniform(-1, 1, 3))
            light.SetConeAngle(random.uniform(10, 50))
        renderer.AddLight(light)


def place_camera(camera, random, inside):
    """Look at about the middle: in a room through its open side, else from somewhere above."""
    azimuth, elevation, distance = random.uniform(0, 360), random.uniform(10, 55), random.uniform(2.2, 4)
    if inside:
        azimuth, elevation, distance = random.uniform(-102, -78), random.uniform(-8, 8), random.uniform(2.6, 3.4)
    a, e = np.radians((azimuth, elevation))
    camera.SetPosition(distance * np.array((np.cos(a) * np.cos(e), np.sin(a) * np.cos(e), np.sin(e))))
    camera.SetFocalPoint(random.uniform(-0.25, 0.25, 3))
    camera.SetViewUp(0, 0, 1)
    camera.SetViewAngle(random.uniform(28, 45))


def make(family, seed):
    """A renderer with a scene of a family, a name of TRAINED or HELD_OUT, and the generator of its random numbers."""
    random = np.random.default_rng((seed, 77))
    inside = family == "room"
    renderer = vtkRenderer()
    for actor in (TRAINED | HELD_OUT)[family](random):
        renderer.AddActor(actor)
    if random.random() < 0.4 and not inside:
        add_sky(renderer, random)
    add_lights(renderer, random, inside)
    place_camera(renderer.GetActiveCamera(), random, inside)
    renderer.SetBackground(0, 0, 0)
    renderer.ResetCameraClippingRange()
    return renderer, random
