# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
"""README's Python, as it stands there."""
import os
import re
import sys
import tempfile
import unittest

import bravais
import numpy


class TestReadme(unittest.TestCase):
    def test_python(self):
        with open(README, encoding="utf-8") as file:
            blocks = re.findall(r"^```python\n(.*?)^```", file.read(), re.M | re.S)
        self.assertEqual(len(blocks), 2)
        self.assertLessEqual(len(blocks[0].split("\n")), 13)
        names = {}
        with tempfile.TemporaryDirectory() as folder:
            os.chdir(folder)
            exec(blocks[0], names)
            pixels = bravais.read_picture("marschner-lobb.png").astype(int)
            os.chdir("/")
        shown = numpy.abs(pixels - pixels[:, :1]).max(axis=2) > 12
        self.assertGreater(shown.mean(), 0.1)
        self.assertGreater(pixels[shown].std(), 5)

        exec(blocks[1], names)
        # x, y, z = 0.5, 0.5, 0.5 is the first point of the first odd layer.
        self.assertEqual(names["volume"].GetScalarComponentAsDouble(0, 0, 1, 0), 0.0)
        self.assertEqual(names["volume"].GetScalarComponentAsDouble(1, 0, 2, 0), 0.0)
        self.assertEqual(names["volume"].GetScalarComponentAsDouble(2, 1, 0, 0), 5.0)


if __name__ == "__main__":
    README = sys.argv[1]
    unittest.main(argv=sys.argv[:1])
