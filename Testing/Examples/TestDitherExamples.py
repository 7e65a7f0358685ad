# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
"""The examples of Bayer patterns and dithering, on the small inputs that they generate."""
import os
import pathlib
import re
import subprocess
import sys
import unittest

from vtkmodules.vtkIOImage import vtkPNGReader

ROOT = pathlib.Path(__file__).resolve().parents[2]
FOLDER = pathlib.Path(os.environ["BRAVAIS_TEMPORARY"]) / "DitherExamples"


def run(example, *arguments):
    """What an example prints."""
    command = [sys.executable, ROOT / "Examples" / "Python" / example, FOLDER, *arguments]
    return subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True).stdout


def get_numbers(text):
    return [float(number) for number in re.findall(r"[-+]?\d+\.\d*", text)]


class TestDitherExamples(unittest.TestCase):
    def check_picture(self, name, size):
        reader = vtkPNGReader()
        reader.SetFileName(str(FOLDER / name))
        reader.Update()
        image = reader.GetOutput()
        self.assertEqual(image.GetDimensions()[:2], size)
        lo, hi = image.GetScalarRange()
        self.assertGreater(hi - lo, 100)

    def test_photograph(self):
        lines = run("DitherPhotograph.py").splitlines()
        self.assertEqual(sum("rounded" in line for line in lines), 6)
        dithered = [get_numbers(line)[0] for line in lines if "dithered" in line]
        self.assertEqual(len(dithered), 6)
        for error in dithered:
            self.assertLess(abs(error), 0.5)  # of 255
        self.check_picture("dither-photograph-grey.png", (768, 512))
        self.check_picture("dither-photograph-color.png", (768, 512))

    def test_photograph_from_a_file(self):
        run("DitherPhotograph.py", ROOT / "Documentation" / "dither-photograph.png")
        self.check_picture("dither-photograph-color.png", (768, 512))

    def test_volume(self):
        lines = run("DitherVolume.py", "--size", "150").splitlines()
        rounded, square, cube = (get_numbers(line) for line in lines[1:4])
        self.assertLess(square[0], rounded[0] / 3)  # levels
        self.assertLess(cube[0], square[0])
        self.assertLess(square[1], rounded[1])  # grey values
        self.assertLess(cube[1], rounded[1])
        self.check_picture("dither-volume.png", (300, 300))

    def test_figures_are_those_of_the_documentation(self):
        text = (ROOT / "Documentation" / "bayer.md").read_text(encoding="utf-8")
        lines = run("BayerFigures.py").splitlines()
        figures = [line for line in lines if not line.endswith(".png")]
        self.assertEqual(len(figures), 10)
        for line in figures:
            if not line.startswith("random"):  # numpy's generators may change
                for number in get_numbers(line.split(":")[-1]):
                    written = [f"{number:.{digits}f}" for digits in (1, 3, 4)]
                    self.assertTrue(any(f" {w} " in text for w in written), (line, number))
        for name, size in (("square", (780, 260)), ("slices", (800, 400)), ("cells", (800, 440))):
            self.check_picture(f"bayer-{name}.png", size)


if __name__ == "__main__":
    unittest.main()
