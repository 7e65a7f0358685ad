# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
"""The example of a texture on demand, on a small picture."""
import re
import unittest

import examples


class TestTextureOnDemand(examples.ExampleTest):
    def test_what_it_prints(self):
        wrote, sampled = self.passes("a.tif", "--size", 512, "--points", 20000).splitlines()
        megabytes = float(re.match(r"wrote ([\d.]+) MB", wrote)[1])
        self.assertLess(megabytes, 1.01)  # at most four times 512 x 512 bytes
        hits, misses = (int(re.search(rf"(\d+) {word}", sampled)[1]) for word in ("hits", "misses"))
        self.assertGreater(hits, 0)
        self.assertGreater(misses, 0)
        self.assertLess(misses, 15 * 15 + 1)  # each tile once
        mean = float(re.search(r"mean ([\d.]+)", sampled)[1])
        self.assertAlmostEqual(mean, 128, delta=10)

    def test_a_folder_that_is_not_there(self):
        self.assertGreater(self.run_example("none/a.tif", "--size", 64).returncode, 0)


if __name__ == "__main__":
    examples.main()
