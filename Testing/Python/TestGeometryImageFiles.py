# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
"""vtkGeometryImageReader and vtkGeometryImageWriter."""
import math
import os
import pathlib
import struct
import unittest

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOImage import vtkMetaImageWriter, vtkPNGWriter
from vtkmodules.vtkIOXML import vtkXMLImageDataWriter

from bravais import vtkGeometryImageReader, vtkGeometryImageSource, vtkGeometryImageWriter
from checks import Errors, make_image, refuses
from geometry import get_points, get_used, make_geometry_image

FOLDER = pathlib.Path(os.environ.get("BRAVAIS_TEMPORARY", "/tmp")) / "TestGeometryImageFiles"
FORMATS = ".gim", ".vti", ".exr", ".tif"


def make_path(name):
    FOLDER.mkdir(parents=True, exist_ok=True)
    return str(FOLDER / name)


def make_source(width=13, height=9):
    source = vtkGeometryImageSource()
    source.SetShapeToBumpySphere()
    source.SetDimensions(width, height)
    source.Update()
    return source.GetOutput()


def write(image, name):
    writer = vtkGeometryImageWriter()
    writer.SetFileName(make_path(name))
    writer.SetInputDataObject(image)
    writer.Write()
    return make_path(name)


def make_reader(path):
    reader = vtkGeometryImageReader()
    reader.SetFileName(path)
    return reader


def read(path):
    reader = make_reader(path)
    reader.Update()
    return reader.GetOutput()


def write_bytes(name, data):
    path = make_path(name)
    with open(path, "wb") as file:
        file.write(data)
    return path


class TestGeometryImageFiles(unittest.TestCase):
    def check_same(self, found, image):
        self.assertEqual(found.GetDimensions(), image.GetDimensions())
        self.assertEqual(found.GetFieldData().GetAbstractArray("Lattice").GetValue(0),
                         "GeometryImage")
        self.assertEqual(found.GetPointData().GetVectors().GetName(), "Points")
        used = get_used(image)
        np.testing.assert_array_equal(get_used(found), used)
        np.testing.assert_array_equal(get_points(found)[used], get_points(image)[used])

    def test_round_trips(self):
        for size in (13, 9), (1, 1), (1, 6), (7, 1), (64, 65):
            for ending in FORMATS:
                image = make_source(*size)
                self.check_same(read(write(image, "image" + ending)), image)

    def test_unused_gixels(self):
        generator = np.random.default_rng(1)
        points = generator.normal(size=(7, 9, 3)).astype(np.float32)
        points[2, 3] = np.nan
        image = make_geometry_image(points, generator.integers(0, 2, (7, 9)))
        for ending in FORMATS:
            self.check_same(read(write(image, "holes" + ending)), image)

    def test_vti_keeps_all(self):
        points = np.random.default_rng(2).normal(size=(7, 9, 3))
        image = make_geometry_image(points, np.ones((7, 9)))
        other = numpy_to_vtk(np.arange(63.0), deep=True)
        other.SetName("other")
        image.GetPointData().AddArray(other)
        found = read(write(image, "all.vti"))
        self.check_same(found, image)
        self.assertEqual(get_points(found).tobytes(), points.tobytes())
        for name in "Defined", "other":
            np.testing.assert_array_equal(vtk_to_numpy(found.GetPointData().GetArray(name)),
                                          vtk_to_numpy(image.GetPointData().GetArray(name)))

    def test_gim_bytes(self):
        image = make_source(5, 3)
        with open(write(image, "bytes.gim"), "rb") as file:
            data = file.read()
        self.assertEqual(data, struct.pack("<ii", 5, 3) + get_points(image).astype("<f4").tobytes())

    def test_images_without_a_tag(self):
        points = np.random.default_rng(3).normal(size=(1, 6, 8, 3))
        for dtype in np.float32, np.float64:
            image = make_image(points.astype(dtype), start=(4, -2, 7), name="xyz")
            for writer, ending in (vtkXMLImageDataWriter(), "vti"), (vtkMetaImageWriter(), "mhd"):
                writer.SetFileName(make_path("plain." + ending))
                writer.SetInputData(image)
                writer.Write()
                found = read(make_path("plain." + ending))
                self.assertEqual(found.GetExtent(), (0, 7, 0, 5, 0, 0))
                np.testing.assert_array_equal(get_points(found), points.astype(dtype).reshape(-1, 3))
                self.assertEqual(found.GetPointData().GetVectors().GetName(), "Points")

    def test_pieces(self):
        image = make_source(13, 9)
        points = get_points(image).reshape(9, 13, 3)
        for ending in FORMATS:
            reader = make_reader(write(image, "pieces" + ending))
            for x0, x1, y0, y1 in (0, 12, 3, 5), (2, 2, 0, 8), (4, 11, 8, 8):
                reader.Modified()
                reader.UpdateExtent((x0, x1, y0, y1, 0, 0))
                self.assertEqual(reader.GetOutput().GetExtent(), (x0, x1, y0, y1, 0, 0))
                np.testing.assert_array_equal(
                    get_points(reader.GetOutput()), points[y0:y1 + 1, x0:x1 + 1].reshape(-1, 3))

    def test_broken_gim(self):
        good = struct.pack("<ii", 3, 2) + bytes(72)
        for data, words in (
                (b"", ("0 bytes",)), (good[:7], ("7 bytes",)), (good[:8], ("3 x 2", "8 bytes")),
                (good[:-1], ("truncated", "79 bytes")), (good + b"x", ("longer", "81 bytes")),
                (struct.pack("<ii", 0, 5), ("0 x 5",)), (struct.pack("<ii", -3, -2) + bytes(72), ("-3 x -2",)),
                (struct.pack("<ii", 2 ** 31 - 1, 2 ** 31 - 1) + bytes(72), ("2147483647", "truncated")),
                (struct.pack(">ii", 3, 2) + bytes(72), ("50331648 x 33554432",))):
            refuses(self, make_reader(write_bytes("broken.gim", data)), "broken.gim", *words)

    def test_broken_pictures(self):
        image = make_source(40, 30)
        for ending in ".exr", ".tif":
            with open(write(image, "whole" + ending), "rb") as file:
                data = file.read()
            for size in 0, 3, 40, len(data) // 2:
                path = write_bytes("broken" + ending, data[:size])
                refuses(self, make_reader(path), "broken" + ending)
        with open(write(image, "whole.vti"), "rb") as file:
            data = file.read()
        for size in 0, 20, 100:
            reader = make_reader(write_bytes("broken.vti", data[:size]))
            refuses(self, reader, "broken.vti")
            with Errors(reader) as errors:
                reader.Modified()
                reader.Update()
            self.assertNotIn("vtkXML", errors.window.GetOutput())  # nothing of VTK's own besides
        text = data.replace(b'"0 39 0 29 0 0"', b'"0 1999999999 0 1999999999 0 0"')
        self.assertNotEqual(text, data)
        refuses(self, make_reader(write_bytes("broken.vti", text)), "2000000000 x 2000000000")

    def test_other_images(self):
        path = make_path("bytes.png")
        writer = vtkPNGWriter()
        writer.SetFileName(path)
        writer.SetInputData(make_image(np.zeros((1, 4, 4, 3), np.uint8)))
        writer.Write()
        refuses(self, make_reader(path), "uint8", "float")
        for array, word in ((np.zeros((1, 4, 4)), "1 components"), (np.zeros((2, 4, 4, 3)), "4 x 4 x 2"),
                            (np.zeros((1, 4, 4, 3), np.int16), "short")):
            vti = vtkXMLImageDataWriter()
            vti.SetFileName(make_path("other.vti"))
            vti.SetInputData(make_image(array))
            vti.Write()
            refuses(self, make_reader(make_path("other.vti")), "other.vti", word)

    def test_names(self):
        refuses(self, vtkGeometryImageReader(), "FileName")
        for name in "missing.gim", "missing.vti", "missing.exr", ".":
            refuses(self, make_reader(make_path(name)), "no file")
        refuses(self, make_reader(write_bytes("text.unknown", b"text")), "text.unknown")

    def check_write(self, image, path, *words):
        writer = vtkGeometryImageWriter()
        writer.SetFileName(path)
        if image is not None:
            writer.SetInputDataObject(image)
        with Errors(writer) as errors:
            writer.Write()
        self.assertEqual(len(errors.texts), 1, errors.texts)
        for word in words:
            self.assertIn(word, errors.texts[0])
        self.assertNotEqual(writer.GetErrorCode(), 0)
        if path:
            self.assertFalse(os.path.exists(path))

    def test_refused_writes(self):
        image = make_source()
        self.check_write(image, None, "FileName")
        self.check_write(None, make_path("no.gim"), "input")
        self.check_write(vtkImageData(), make_path("no.gim"), "GeometryImage")
        for name in "no.png", "no.jpg", "no.hdr", "no.unknown", "no":
            self.check_write(image, make_path(name), make_path(name))
        for ending in FORMATS:
            self.check_write(image, make_path("no folder/no" + ending), "cannot be written")

    def test_an_older_file_stays(self):
        path = write_bytes("old.png", b"old")
        writer = vtkGeometryImageWriter()
        writer.SetInputDataObject(make_source())
        writer.SetFileName(path)
        with Errors(writer) as errors:
            writer.Write()
        self.assertEqual(len(errors.texts), 1)
        writer.AddObserver("ProgressEvent", lambda *unused: writer.SetAbortExecute(1))
        for ending in FORMATS:
            aborted = write_bytes("old" + ending, b"old")
            writer.SetFileName(aborted)
            writer.Write()
            self.assertEqual(writer.GetErrorCode(), 0)
            for name in path, aborted:
                with open(name, "rb") as file:
                    self.assertEqual(file.read(), b"old")

    def test_good_after_bad(self):
        reader = make_reader(make_path("missing.gim"))
        refuses(self, reader, "missing.gim")
        image = make_source()
        reader.SetFileName(write(image, "good.gim"))
        reader.Update()
        self.check_same(reader.GetOutput(), image)
        self.assertTrue(math.isfinite(get_points(reader.GetOutput()).sum()))


if __name__ == "__main__":
    unittest.main()
