# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
"""One, two and four processes, by MPI, show the same pictures of a BCC volume, without a seam."""
import unittest

import mpi
import numpy
import views


class TestPictures(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folders = {count: mpi.run("pictures.py", count) for count in (1, 2, 4)}

    def compare(self, name, limit):
        """The largest difference of 8-bit values is not more than that many a picture, or three."""
        expected = views.read_picture(str(self.folders[1] / f"{name}.png"))
        self.assertGreater(views.get_shown(expected).mean(), 0.1, name)
        for count in 2, 4:
            with self.subTest(name, processes=count):
                picture = views.read_picture(str(self.folders[count] / f"{name}.png"))
                self.assertLessEqual(numpy.abs(picture - expected).max(), max(count, 3) * limit)

    def test_surfaces_and_slices_are_the_same(self):
        for name in "Surface", "SurfaceSteps", "SurfaceKernel", "Slice", "Filtered":
            self.compare(name, 0)

    def test_composites_are_blended_in_order(self):
        # IceT rounds colours to 8 bits before each picture is added, and so does OpenGL.
        for name in "Composite", "Cropped", "Projection", "Tiny":
            self.compare(name, 1)

    def test_maximum_is_that_of_the_whole(self):
        self.compare("Maximum", 0)

    def test_no_process_has_the_whole(self):
        for count in 2, 4:
            whole = int((self.folders[1] / "points.0.txt").read_text())
            points = [int((self.folders[count] / f"points.{rank}.txt").read_text())
                      for rank in range(count)]
            self.assertGreaterEqual(sum(points), whole)
            self.assertLess(max(points), whole)


if __name__ == "__main__":
    unittest.main()
