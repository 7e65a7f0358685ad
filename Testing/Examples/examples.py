# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
"""Small volumes for the examples, and what their pictures and errors are checked for."""
import gzip
import os
import subprocess
import sys
import tempfile
import unittest

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOImage import vtkMetaImageWriter, vtkNIFTIImageWriter, vtkPNGReader
from vtkmodules.vtkIOLegacy import vtkStructuredPointsWriter
from vtkmodules.vtkIOXML import vtkXMLImageDataWriter

DIMENSIONS = (20, 22, 18)
SPACING = (1.0, 1.0, 1.25)


def make_ball():
    """A ball whose values fall from 100 in its middle, and a small one apart from it."""
    x, y, z = numpy.meshgrid(*(s * (numpy.arange(n) - (n - 1) / 2)
                               for n, s in zip(DIMENSIONS, SPACING)), indexing="ij")
    ball = 100 - 10 * numpy.sqrt(x * x + y * y + z * z)
    small = 80 - 20 * numpy.sqrt((x - 8) ** 2 + (y - 9) ** 2 + (z - 9) ** 2)
    values = numpy.maximum(numpy.maximum(ball, small), 0).astype(numpy.int16)
    return values.transpose(2, 1, 0)


def make_image(values, spacing=SPACING):
    image = vtkImageData()
    image.SetDimensions(values.shape[2::-1])
    image.SetSpacing(spacing)
    scalars = numpy_to_vtk(numpy.ascontiguousarray(values).ravel(), deep=True)
    scalars.SetName("values")
    image.GetPointData().SetScalars(scalars)
    return image


def write(writer, image, path):
    writer.SetInputData(image)
    writer.SetFileName(path)
    writer.Write()


def write_volumes(folder):
    """The ball as a file of each type; their paths."""
    values = make_ball()
    image = make_image(values)
    paths = [os.path.join(folder, "ball" + ending)
             for ending in (".vti", ".mhd", ".vtk", ".nii", ".nii.gz", ".nrrd")]
    meta = vtkMetaImageWriter()
    meta.SetCompression(False)
    for writer, path in zip(
            (vtkXMLImageDataWriter(), meta, vtkStructuredPointsWriter(), vtkNIFTIImageWriter()),
            paths):
        if hasattr(writer, "SetFileTypeToBinary"):
            writer.SetFileTypeToBinary()
        write(writer, image, path)
    with open(paths[3], "rb") as plain, gzip.open(paths[4], "wb") as packed:
        packed.write(plain.read())
    with open(paths[5], "wb") as file:
        file.write(("NRRD0001\ntype: short\ndimension: 3\nsizes: %d %d %d\n" % DIMENSIONS +
                    "spacings: %g %g %g\nendian: little\nencoding: raw\n\n" % SPACING).encode())
        file.write(values.astype("<i2").tobytes())
    return paths


def read_picture(path):
    reader = vtkPNGReader()
    reader.SetFileName(path)
    reader.Update()
    width, height, _ = reader.GetOutput().GetDimensions()
    pixels = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars())
    return pixels.reshape(height, width, -1).astype(int)


class ExampleTest(unittest.TestCase):
    """Runs the command of sys.argv in a folder of its own."""
    command = []

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def path(self, name):
        return os.path.join(self.folder, name)

    def run_example(self, *arguments):
        return subprocess.run([*self.command, *map(str, arguments)], cwd=self.folder, text=True,
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE, timeout=250)

    def passes(self, *arguments):
        result = self.run_example(*arguments)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(result.stderr, "")
        return result.stdout

    def refuses(self, word, *arguments):
        """Fails with one sentence that has the word in it, and no picture."""
        if os.path.exists(self.path("volume.png")):
            os.remove(self.path("volume.png"))
        result = self.run_example(*arguments)
        self.assertGreater(result.returncode, 0)
        self.assertEqual(result.stdout, "")
        sentences = [line for line in result.stderr.splitlines() if word in line]
        self.assertEqual(len(sentences), 1, result.stderr)
        self.assertNotIn("Traceback", result.stderr)
        self.assertFalse(os.path.exists(self.path("volume.png")))

    def shows(self, name, size, least=0.05):
        """A picture of that size, part of which differs from the background, a vertical gradient
        that the first column has alone; what part."""
        picture = read_picture(self.path(name))
        self.assertEqual(picture.shape, (size[1], size[0], 3))
        differs = numpy.abs(picture - picture[:, :1]).max(2) > 12
        self.assertGreater(differs.mean(), least)
        self.assertGreater(picture[differs].std(), 5)  # shaded, not one flat colour
        return differs.mean()


def main():
    ExampleTest.command = sys.argv[1:]
    unittest.main(module="__main__", argv=sys.argv[:1])
