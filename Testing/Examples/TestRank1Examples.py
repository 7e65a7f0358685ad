# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
"""The examples of rank-1 lattices and textures, on the small inputs that they generate."""
import os
import pathlib
import re
import subprocess
import sys
import unittest

from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

ROOT = pathlib.Path(__file__).resolve().parents[2]
FOLDER = pathlib.Path(os.environ["BRAVAIS_TEMPORARY"]) / "Rank1Examples"


def run(example, *arguments, fails=False):
    """What an example prints, or complains of."""
    command = [sys.executable, ROOT / "Examples" / "Python" / example, FOLDER, *arguments]
    result = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    if (result.returncode != 0) != fails:
        raise AssertionError(result.stderr)
    return result.stderr if fails else result.stdout


class TestRank1Examples(unittest.TestCase):
    def read(self, name, size):
        """A picture of that size, [row from below, column, RGB]."""
        reader = vtkPNGReader()
        reader.SetFileName(str(FOLDER / name))
        reader.Update()
        image = reader.GetOutput()
        self.assertEqual(image.GetDimensions()[:2], size)
        pixels = vtk_to_numpy(image.GetPointData().GetScalars())
        return pixels.reshape(size[1], size[0], -1).astype(int)

    def test_lattices(self):
        text = run("Rank1Lattices.py")
        efficiencies = [float(number) for number in re.findall(r"efficiency ([\d.]+)", text)]
        self.assertEqual(efficiencies, [78.5, 44.9, 56.1, 81.3, 89.8, 90.7])
        self.assertGreater(self.read("rank1-lattices.png", (998, 208)).std(), 10)
        text = run("Rank1Lattices.py", "--points", "100")
        self.assertIn("g = (1, 1)", text)
        self.assertEqual(len(text.splitlines()), 5)  # and the picture's name
        self.assertGreater(float(re.findall(r"efficiency ([\d.]+)", text)[2]), 80)

    def test_look_ups(self):
        text = run("Rank1LookUps.py", "--texels", "256", "--window", "0.4", "0.6", "0.2", "0.4")
        self.assertIn("65536 texels", text)
        pixels = self.read("rank1-look-ups.png", (800, 400))
        true = pixels[200:, 400:600]
        for row, column, most in ((1, 0, 20), (1, 1, 6), (0, 0, 20), (0, 1, 8), (0, 2, 8),
                                  (0, 3, 12)):
            panel = pixels[200 * row:200 * (row + 1), 200 * column:200 * (column + 1)]
            error = abs(panel - true).mean()
            self.assertGreater(error, 0.1)
            self.assertLess(error, most)
        self.assertIn("0 texels", run("Rank1LookUps.py", "--texels", "0", fails=True))

    def test_against_square(self):
        text = run("Rank1AgainstSquare.py", "--side", "61", "--resolutions", "16", "32", "8")
        self.read("rank1-against-square.png", (900, 660))
        nearest, interpolated = (
            [float(number) for row in re.findall(r"^ +\d+ x \d+ +(.*)$", table, re.M)
             for number in row.split()[:3]]
            for table in text.split("interpolated"))
        self.assertEqual((len(nearest), len(interpolated)), (9, 9))
        # Waves of all directions: less than the square's on the average, and wherever interpolated.
        self.assertLess(sum(nearest) / 9, 99)
        self.assertLess(max(interpolated), 100)
        self.assertIn("experiment",
                      run("Rank1AgainstSquare.py", "--resolutions", "9", "3", "1", fails=True))

    def test_checkerboard_that_a_square_texture_has_exactly(self):
        text = run("Rank1AgainstSquare.py", "--side", "61", "--resolutions", "64", "64", "1")
        self.assertIn("square is 0", text)


if __name__ == "__main__":
    unittest.main()
