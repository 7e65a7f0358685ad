# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
"""The viewer that refines, without a window: what it prints and draws after the mouse has dragged."""
import os
import pathlib
import subprocess
import sys
import unittest

from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

EXAMPLE = pathlib.Path(__file__).resolve().parents[2] / "Examples/Python/ProgressiveViewer.py"
PICTURE = pathlib.Path(os.environ["BRAVAIS_TEMPORARY"]) / "ProgressiveViewer.png"


class TestProgressiveViewer(unittest.TestCase):
    def test_passes_after_a_drag(self):
        text = subprocess.run(
            [sys.executable, EXAMPLE, "--size", "100", "--output", PICTURE],
            check=True, stdout=subprocess.PIPE, text=True).stdout
        self.assertIn("16 passes", text)
        self.assertIn("the last picture is the plain one", text)
        self.assertEqual(text.count("complete"), 1)
        reader = vtkPNGReader()
        reader.SetFileName(str(PICTURE))
        reader.Update()
        image = reader.GetOutput()
        self.assertEqual(image.GetDimensions()[:2], (300, 100))
        pixels = vtk_to_numpy(image.GetPointData().GetScalars()).reshape(100, 3, 100, 3).astype(int)
        errors = [abs(pixels[:, n] - pixels[:, 2]).mean() for n in (0, 1)]
        self.assertGreater(errors[1], 0)
        self.assertLess(errors[1], 0.8 * errors[0])


if __name__ == "__main__":
    unittest.main()
