# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
"""The example of aliasing, on a small texture."""
import re
import unittest

import examples


class TestTextureAliasing(examples.ExampleTest):
    def test_filters_take_aliasing_away(self):
        lines = self.passes(".", "--size", 48, "--texture", 128).splitlines()[:4]
        for line in lines:
            point, super_sampled, _, trilinear = (float(e) for e in re.findall(r"[\d.]+(?=,|$)", line))
            self.assertLess(super_sampled, 0.75 * point, line)
            self.assertLess(trilinear, point, line)
        self.assertEqual(examples.read_picture(self.path("texture-aliasing.png")).shape[:2],
                         (192, 192))


if __name__ == "__main__":
    examples.main()
