# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
import unittest

import numpy as np

from checks import refuses
from surfaces import add_array, make_bumps, make_image, make_surface, run


class TestGeometryImageToPolyDataBadInput(unittest.TestCase):
    def test_images_without_squares(self):
        for height, width in (1, 1), (1, 7), (7, 1):
            for level in 0, 2:
                for strips in False, True:
                    output = run(make_image(make_bumps(height, width)), level,
                                 GenerateTriangleStrips=strips)
                    self.assertEqual(output.GetNumberOfCells(), 0)
                    self.assertGreater(output.GetNumberOfPoints(), 0)

    def test_all_unused(self):
        for level in 0, 1:
            output = run(make_image(make_bumps(4, 4), np.zeros((4, 4))), level)
            self.assertEqual(output.GetNumberOfCells(), 0)
            self.assertEqual(output.GetNumberOfPoints(), 0)

    def test_levels(self):
        for level in -1, 31, 2 ** 31 - 1, -2 ** 31:
            refuses(self, make_surface(make_image(make_bumps(4, 4)), level),
                    f"LevelOfDetail is {level};", "0 to 30")

    def test_images_that_are_not_geometry_images(self):
        image = make_image(make_bumps(4, 4))
        image.GetFieldData().Initialize()
        refuses(self, make_surface(image), "GeometryImage")
        image = make_image(make_bumps(4, 4))
        image.GetPointData().RemoveArray("Points")
        refuses(self, make_surface(image), "Points")
        image = make_image(make_bumps(4, 4))
        image.SetDimensions(4, 2, 2)
        refuses(self, make_surface(image), "4 x 2 x 2")
        image = make_image(make_bumps(4, 4))
        add_array(image, "Points", np.zeros((16, 3), np.int32))
        refuses(self, make_surface(image), "int")

    def test_short_arrays(self):
        image = make_image(make_bumps(4, 4))
        add_array(image, "few", np.zeros(15))
        refuses(self, make_surface(image), "few", "15 tuples", "16 points")

    def test_infinities(self):
        points = make_bumps(4, 4)
        points[2, 1, 0] = np.inf
        refuses(self, make_surface(make_image(points)), "(1, 2)", "inf")

    def test_masks(self):
        image = make_image(make_bumps(4, 4))
        for bad in np.zeros(16), np.zeros((16, 2), np.uint8), np.zeros(9, np.uint8):
            add_array(image, "LocalityMask", bad)
            refuses(self, make_surface(image), "LocalityMask", "16 tuples", "unsigned char")


if __name__ == "__main__":
    unittest.main()
