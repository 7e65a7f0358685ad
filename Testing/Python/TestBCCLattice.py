# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
import unittest

from vtkmodules.vtkCommonCore import vtkLogger, vtkOutputWindow, vtkStringOutputWindow
from vtkmodules.vtkCommonDataModel import vtkImageData

from bravais import vtkBCCLattice


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
        window = vtkStringOutputWindow()
        former = vtkOutputWindow.GetInstance()
        vtkOutputWindow.SetInstance(window)
        vtkLogger.SetStderrVerbosity(vtkLogger.VERBOSITY_OFF)
        try:
            box = [7.0] * 6
            vtkBCCLattice.GetBox(None, box)
            x = [7.0] * 3
            vtkBCCLattice.GetPoint(None, (0, 0, 0), x)
            vtkBCCLattice.Tag(None)
        finally:
            vtkOutputWindow.SetInstance(former)
            vtkLogger.SetStderrVerbosity(vtkLogger.VERBOSITY_INFO)
        self.assertEqual((box, x), ([7.0] * 6, [7.0] * 3))
        for helper in "GetBox", "GetPoint", "Tag":
            self.assertIn(f"vtkBCCLattice::{helper} expects an image", window.GetOutput())


if __name__ == "__main__":
    unittest.main()
