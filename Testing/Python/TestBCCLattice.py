# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
import contextlib
import itertools
import math
import unittest

from vtkmodules.vtkCommonCore import vtkLogger, vtkOutputWindow, vtkStringOutputWindow
from vtkmodules.vtkCommonDataModel import vtkImageData

from bravais import vtkBCCLattice


@contextlib.contextmanager
def observed_errors():
    """Collects what VTK reports, so that it does not fail the test."""
    window = vtkStringOutputWindow()
    former = vtkOutputWindow.GetInstance()
    vtkOutputWindow.SetInstance(window)
    vtkLogger.SetStderrVerbosity(vtkLogger.VERBOSITY_OFF)
    try:
        yield window
    finally:
        vtkOutputWindow.SetInstance(former)
        vtkLogger.SetStderrVerbosity(vtkLogger.VERBOSITY_INFO)


def make_volume():
    image = vtkImageData()
    image.SetExtent(0, 3, 0, 2, 3, 8)
    image.SetOrigin(1, 2, 3)
    image.SetSpacing(2, 4, 1)
    vtkBCCLattice.Tag(image)
    return image


class TestBCCLattice(unittest.TestCase):
    def test_tag(self):
        self.assertTrue(vtkBCCLattice.IsBCC(make_volume()))
        self.assertFalse(vtkBCCLattice.IsBCC(vtkImageData()))

    def test_kernels(self):
        self.assertEqual(
            [vtkBCCLattice.BCC4, vtkBCCLattice.BCC7, vtkBCCLattice.BCC8, vtkBCCLattice.BCC12],
            [4, 7, 8, 12])

    def test_points_of_both_cosets(self):
        x = [0.0, 0.0, 0.0]
        vtkBCCLattice.GetPoint(make_volume(), (2, 1, 4), x)
        self.assertEqual(x, [1 + 2 * 2, 2 + 4 * 1, 3 + 4])
        vtkBCCLattice.GetPoint(make_volume(), (2, 1, 5), x)
        self.assertEqual(x, [1 + 2 * 2.5, 2 + 4 * 1.5, 3 + 5])

    def test_box_reaches_the_odd_layers(self):
        box = [0.0] * 6
        vtkBCCLattice.GetBox(make_volume(), box)
        self.assertEqual(box, [1, 1 + 2 * 3.5, 2, 2 + 4 * 2.5, 3 + 3, 3 + 8])

    def test_box_follows_the_direction_matrix(self):
        image = make_volume()
        image.SetDirectionMatrix(0, -1, 0, 1, 0, 0, 0, 0, 1)  # a quarter turn about z
        box = [0.0] * 6
        vtkBCCLattice.GetBox(image, box)
        self.assertEqual(box, [1 - 4 * 2.5, 1, 2, 2 + 2 * 3.5, 3 + 3, 3 + 8])

    def test_empty_image_has_no_box(self):
        box = [0.0] * 6
        vtkBCCLattice.GetBox(vtkImageData(), box)
        self.assertEqual(box, [1, -1, 1, -1, 1, -1])

    def test_no_image_is_an_error_that_changes_nothing(self):
        box = [7.0] * 6
        x = [7.0] * 3
        with observed_errors() as window:
            vtkBCCLattice.GetBox(None, box)
            vtkBCCLattice.GetPoint(None, (0, 0, 0), x)
            vtkBCCLattice.Tag(None)
        self.assertEqual((box, x), ([7.0] * 6, [7.0] * 3))
        for helper in "GetBox", "GetPoint", "Tag":
            self.assertIn(f"vtkBCCLattice::{helper} expects an image", window.GetOutput())

    def test_kernels_have_their_values_on_the_lattice(self):
        # bcc4 is a hat; bcc12 is half of three cubic B-splines, which are 2/3 at 0.
        self.assertEqual(vtkBCCLattice.Evaluate(4, 0, 0, 0), 1)
        self.assertEqual(vtkBCCLattice.Evaluate(4, 1, 1, 1), 0)
        self.assertAlmostEqual(vtkBCCLattice.Evaluate(12, 0, 0, 0), 4 / 27, delta=1e-15)
        self.assertAlmostEqual(vtkBCCLattice.Evaluate(12, 2, 0, 0), 1 / 27, delta=1e-15)

    def test_kernels_sum_to_one(self):
        points = [
            p for p in itertools.product(range(-4, 5), repeat=3)
            if p[0] % 2 == p[1] % 2 == p[2] % 2]
        for kernel in 4, 7, 8, 12:
            total = sum(
                vtkBCCLattice.Evaluate(kernel, 0.3 - p[0], 0.8 - p[1], -0.1 - p[2])
                for p in points)
            self.assertAlmostEqual(total, 1, delta=1e-14)

    def test_kernels_vanish_far_away(self):
        self.assertEqual(vtkBCCLattice.Evaluate(8, 1e300, 0, 0), 0)

    def test_unknown_kernel_is_an_error(self):
        for kernel in 0, 5, -7:
            with observed_errors() as window:
                self.assertEqual(vtkBCCLattice.Evaluate(kernel, 0, 0, 0), 0)
            self.assertIn(f"BCC4, BCC7, BCC8 or BCC12, not {kernel}.", window.GetOutput())

    def test_point_that_is_not_finite_is_an_error(self):
        for value in math.nan, math.inf, -math.inf:
            for point in (value, 0, 0), (0, value, 0), (0, 0, value):
                with observed_errors() as window:
                    self.assertEqual(vtkBCCLattice.Evaluate(7, *point), 0)
                self.assertIn("expects finite coordinates, not (", window.GetOutput())


if __name__ == "__main__":
    unittest.main()
