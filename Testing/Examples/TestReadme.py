# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
"""README's Python, as it stands there."""
import re
import sys
import unittest

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkRenderingCore import vtkWindowToImageFilter


class TestReadme(unittest.TestCase):
    def test_python(self):
        with open(README, encoding="utf-8") as file:
            blocks = re.findall(r"^```python\n(.*?)^```", file.read(), re.M | re.S)
        self.assertEqual(len(blocks), 2)
        names = {}
        exec(blocks[0], names)
        grabber = vtkWindowToImageFilter()
        grabber.SetInput(names["window"])
        grabber.ReadFrontBufferOff()
        grabber.Update()
        pixels = vtk_to_numpy(grabber.GetOutput().GetPointData().GetScalars()).astype(int)
        shown = numpy.abs(pixels - pixels[0]).max(1) > 12
        self.assertGreater(shown.mean(), 0.1)
        self.assertGreater(pixels[shown].std(), 5)

        exec(blocks[1], names)
        # x, y, z = 0.5, 0.5, 0.5 is the first point of the first odd layer.
        self.assertEqual(names["volume"].GetScalarComponentAsDouble(0, 0, 1, 0), 0.0)
        self.assertEqual(names["volume"].GetScalarComponentAsDouble(1, 0, 2, 0), 0.0)
        self.assertEqual(names["volume"].GetScalarComponentAsDouble(2, 1, 0, 0), 5.0)


if __name__ == "__main__":
    README = sys.argv[1]
    unittest.main(argv=sys.argv[:1])
