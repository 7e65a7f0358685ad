# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
"""The program that measures how processes share a volume, on a small one."""
import pathlib
import re
import unittest

import mpi

SCRIPT = pathlib.Path(__file__).parent.parent / "Benchmarks" / "Scaling.py"
DIMENSIONS = 24, 24, 64


class TestScaling(unittest.TestCase):
    def run_processes(self, count, *arguments):
        """The digest of the picture, and the millions of points of each process."""
        text = mpi.start(SCRIPT, count, "--dimensions", *map(str, DIMENSIONS), "--size", "60",
                         *arguments)
        points = [float(n) for n in re.findall(r"process \d: +([\d.]+) million points", text)]
        self.assertEqual(len(points), count)
        self.assertEqual(len(re.findall(r"processor time +[\d.]+ s of the busiest", text)), 4 if
                         arguments else 3)
        self.assertGreater(float(re.search(r"surface on ([\d.]+) %", text)[1]), 5)
        return re.search(r"digest (\w+)", text)[1], points

    def check(self, *arguments):
        digest, whole = self.run_processes(1, *arguments)
        other, points = self.run_processes(2, *arguments)
        self.assertEqual(other, digest)
        return whole[0], points

    def test_processes_have_their_parts(self):
        whole, points = self.check()
        self.assertAlmostEqual(whole, 24 * 24 * 64 / 1e6, places=3)
        self.assertLess(max(points), 0.7 * whole)

    def test_slabs_are_streamed(self):
        whole = 24 * 24 * 64 / 1e6
        one, points = self.check("--pieces", "4")
        self.assertLess(max(one, *points), 0.5 * whole)


if __name__ == "__main__":
    unittest.main()
