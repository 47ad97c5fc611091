# SPDX-FileCopyrightText: Penumbra authors
# SPDX-License-Identifier: BSD-3-Clause
"""Files of baked light: Python reads the files that it writes, and refuses files that were altered."""
import pathlib
import re
import tempfile
import unittest

import numpy
import penumbra
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkStringArray
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkFiltersCore import vtkTriangleFilter
from vtkmodules.vtkFiltersSources import vtkCubeSource, vtkPlaneSource
from vtkmodules.vtkIOXML import vtkXMLImageDataReader, vtkXMLImageDataWriter
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper, vtkRenderer


def write(field, path):
    writer = vtkXMLImageDataWriter()
    writer.SetFileName(str(path))
    writer.SetInputData(field)
    writer.SetDataModeToBinary()  # some versions of VTK cannot read appended data
    writer.Write()


def read(path):
    reader = vtkXMLImageDataReader()
    reader.SetFileName(str(path))
    reader.Update()
    return reader.GetOutput()


class Probes(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.scratch = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.scratch.name)
        cls.renderer = vtkRenderer()
        cls.window = penumbra.window(cls.renderer, size=(32, 24))
        cls.cube, mapper, actor = vtkCubeSource(), vtkPolyDataMapper(), vtkActor()
        mapper.SetInputConnection(cls.cube.GetOutputPort())
        actor.SetMapper(mapper)
        actor.GetProperty().SetAmbient(0.5)
        cls.renderer.AddActor(actor)
        cls.gi = penumbra.enable(cls.renderer, "off")

    @classmethod
    def tearDownClass(cls):
        cls.window.Finalize()
        cls.scratch.cleanup()

    def bake(self, name):
        baker, field = penumbra.vtkGIProbeBaker(), vtkImageData()
        baker.SetProbes(200)
        baker.SetSamples(2)
        self.assertTrue(baker.Bake(self.renderer, field), baker.GetLastError())
        baker.ReleaseGraphicsResources(self.window)
        write(field, self.folder / name)
        return self.folder / name

    def refused(self, path, *words):
        technique = self.gi.GetTechnique("sh-probes")
        technique.SetBake(None)
        technique.EnabledOff()
        with self.assertRaises(ValueError) as caught:
            penumbra.load_bake(self.gi, path)
        for word in (str(path), *words):
            self.assertIn(word, str(caught.exception))
        self.assertFalse(technique.HasBake())
        self.assertFalse(technique.GetEnabled())

    def test_the_number_of_probes_is_limited(self):
        baker = penumbra.vtkGIProbeBaker()
        baker.SetProbes(2 ** 30)
        self.assertEqual(baker.GetProbes(), baker.MostProbes)

    def test_written_files_are_read(self):
        for size in ((2, 2, 2), (1 / 3, 0.1, 2 ** 0.5), (1e-7 / 3, 7e-8, 9e-8), (1e6 / 7, 2e5 / 3, 1e6)):
            self.cube.SetXLength(size[0])
            self.cube.SetYLength(size[1])
            self.cube.SetZLength(size[2])
            self.cube.SetCenter(size[1] / 3, size[2] / 7, 5 * size[0] / 9)
            technique = penumbra.load_bake(self.gi, self.bake("room.vti"))
            self.assertTrue(technique.HasBake())
            self.assertTrue(technique.GetEnabled())

    def test_altered_files_are_refused(self):
        path = self.bake("room.vti")
        content, altered = path.read_text("latin-1"), self.folder / "altered.vti"
        for attribute in ("Spacing", "Origin"):
            digits = re.search(f' {attribute}="[^"]*[0-9]', content)
            last = str((int(content[digits.end() - 1]) + 1) % 10)
            altered.write_text(content[:digits.end() - 1] + last + content[digits.end():], "latin-1")
            self.refused(altered, "checksum")
        for name in ("light", "distance", "offset", "backs"):
            field = read(path)
            values = vtk_to_numpy(field.GetPointData().GetArray(name))
            values.flat[-1] = 1 - (values.flat[-1] != 0)
            write(field, altered)
            self.refused(altered, "checksum")
        field.GetFieldData().RemoveArray("checksum")  # as in files of earlier versions
        write(field, altered)
        self.assertTrue(penumbra.load_bake(self.gi, altered).HasBake())

    def test_damaged_and_foreign_files_are_refused(self):
        path = self.bake("room.vti")
        content, other = path.read_bytes(), self.folder / "other.vti"
        other.write_bytes(content[:len(content) // 2])
        self.refused(other)
        other.write_bytes(b'<VTKFile type="Something">')
        self.refused(other, "holds no baked light")
        image = vtkImageData()
        image.SetDimensions(2, 2, 2)
        write(image, other)
        self.refused(other, "holds no baked light")
        with self.assertRaises(FileNotFoundError):
            penumbra.load_bake(self.gi, self.folder / "none.vti")


class Lightmaps(unittest.TestCase):
    """A floor with random light, set directly and read from a file."""

    @classmethod
    def setUpClass(cls):
        cls.scratch = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.scratch.name)
        cls.renderer, plane, mapper, actor = vtkRenderer(), vtkPlaneSource(), vtkPolyDataMapper(), vtkActor()
        cls.window = penumbra.window(cls.renderer, size=(32, 24), multisamples=0)
        mapper.SetInputConnection(plane.GetOutputPort())
        actor.SetMapper(mapper)
        actor.GetProperty().SetColor(0.3, 0.3, 0.3)
        cls.renderer.AddActor(actor)
        cls.gi = penumbra.enable(cls.renderer, "off")
        cls.technique = cls.gi.GetTechnique("lightmap")
        triangles = vtkTriangleFilter()
        triangles.SetInputConnection(plane.GetOutputPort())
        triangles.Update()
        cls.surfaces = triangles.GetOutput()
        text = vtkStringArray()
        text.SetName("scene")
        text.InsertNextValue(penumbra.vtkGILightmap.DescribeScene(cls.renderer))
        cls.surfaces.GetFieldData().AddArray(text)

    @classmethod
    def tearDownClass(cls):
        cls.window.Finalize()
        cls.scratch.cleanup()

    def light(self, components):
        values = numpy.random.default_rng(components).random((7 * 5, components), numpy.float32)
        image = vtkImageData()
        image.SetDimensions(7, 5, 1)
        image.GetPointData().SetScalars(numpy_to_vtk(values, deep=True))
        return image, values

    def write(self, light, name="map.vti"):
        bake, file = vtkImageData(), penumbra.vtkGIBakeFile()
        self.assertTrue(self.technique.JoinBake(self.surfaces, light, bake), self.technique.GetBakeError())
        self.assertTrue(file.Write(str(self.folder / name), bake), file.GetLastError())
        return self.folder / name

    def test_written_files_are_read(self):
        for components in (3, 6, 12, 24):
            light, values = self.light(components)
            self.assertTrue(self.technique.SetBake(self.surfaces, light))
            self.technique.EnabledOn()
            memory = penumbra.render(self.window)
            path = self.write(light)
            points = read(path).GetPointData()
            layers = [points.GetArray(name) for name in ("light", "moments", "lamps", "lamp moments")]
            stored = numpy.hstack([vtk_to_numpy(layer) for layer in layers if layer])
            numpy.testing.assert_array_equal(stored, values)
            self.technique.SetBake(None)
            self.assertTrue((penumbra.render(self.window) != memory).any())
            self.technique.EnabledOff()
            self.assertIs(penumbra.load_bake(self.gi, path), self.technique)
            self.assertTrue(self.technique.GetEnabled())
            numpy.testing.assert_array_equal(penumbra.render(self.window), memory)

    def test_damaged_and_foreign_files_are_refused(self):
        whole, bad = self.write(self.light(3)[0]).read_bytes(), self.folder / "bad.vti"
        for content, words in ((whole[:len(whole) // 3], "is damaged"), (b"", "holds no baked light"),
                               (b"\x76\x2f\x31\x01" + whole, f"penumbra bake convert {bad} -o NEW.vti")):
            bad.write_bytes(content)
            with self.assertRaises(ValueError) as caught:
                penumbra.load_bake(self.gi, bad)
            self.assertIn(words, str(caught.exception))
            self.assertIn(f"'{bad}'", str(caught.exception))


if __name__ == "__main__":
    unittest.main()
