# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
"""One, two and four processes, by MPI, give the same output of every filter, bit for bit."""
import glob
import unittest

import mpi
import numpy


def read(path):
    """(slices of the whole, values) of a piece."""
    with numpy.load(path) as piece:
        extent = piece["extent"].reshape(3, 2)
        return extent, piece["values"]


class TestProcesses(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folders = {count: mpi.run("processes.py", count) for count in (1, 2, 4)}

    def test_filters(self):
        names = {path.name.split(".")[0] for path in self.folders[1].glob("*.npz")}
        self.assertGreater(len(names), 8)
        for name in sorted(names):
            whole, expected = read(self.folders[1] / f"{name}.0.npz")
            for count in 2, 4:
                with self.subTest(name, processes=count):
                    covered = numpy.zeros(expected.shape[:3], bool)
                    for path in glob.glob(str(self.folders[count] / f"{name}.*.npz")):
                        extent, values = read(path)
                        (x0, x1), (y0, y1), (z0, z1) = extent - whole[:, :1]
                        part = numpy.s_[z0 : z1 + 1, y0 : y1 + 1, x0 : x1 + 1]
                        self.assertEqual(values.tobytes(), expected[part].tobytes())
                        self.assertLess(values.size, expected.size, "no process has the whole")
                        covered[part] = True
                    self.assertTrue(covered.all())


if __name__ == "__main__":
    unittest.main()
