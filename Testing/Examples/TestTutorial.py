# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
"""The tutorial's Python, as it stands there, on a small volume of its own."""
import os
import re
import sys
import tempfile
import unittest

import bravais
import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkNIFTIImageWriter, vtkPNGReader


def write_head(path):
    """A bright ball in the dark, as large in samples as step 4 looks into."""
    z, y, x = numpy.mgrid[:110, :120, :100]
    distance = numpy.sqrt((x - 50) ** 2 + (y - 60) ** 2 + (z - 55) ** 2)
    values = (255 / (1 + numpy.exp((distance - 40) / 3))).astype(numpy.uint8)
    writer = vtkNIFTIImageWriter()
    writer.SetInputData(bravais.image_from_numpy(values))
    writer.SetFileName(path)
    writer.Write()


class TestTutorial(unittest.TestCase):
    def test_steps(self):
        with open(TUTORIAL, encoding="utf-8") as file:
            blocks = re.findall(r"^```python\n(.*?)^```", file.read(), re.M | re.S)
        self.assertEqual(len(blocks), 4)
        with tempfile.TemporaryDirectory() as folder:
            os.chdir(folder)
            write_head("head.nii.gz")
            names = {}
            for block in blocks:
                exec(block, names)
            count = numpy.prod(names["volume"].GetDimensions())
            self.assertAlmostEqual(count / (100 * 120 * 110), 0.7, delta=0.03)
            reader = vtkPNGReader()
            reader.SetFileName("head.png")
            reader.Update()
            os.chdir("/")
        pixels = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars()).astype(int)
        shown = numpy.abs(pixels - pixels[0]).max(axis=1) > 12
        self.assertGreater(shown.mean(), 0.2)
        self.assertLess(shown.mean(), 0.8)


if __name__ == "__main__":
    TUTORIAL = sys.argv[1]
    unittest.main(argv=sys.argv[:1])
