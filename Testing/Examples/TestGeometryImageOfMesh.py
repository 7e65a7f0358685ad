# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
"""The example of geometry images, on the mesh that it generates and on small files."""
import os
import pathlib
import re
import subprocess
import sys
import unittest

from vtkmodules.vtkIOImage import vtkPNGReader

ROOT = pathlib.Path(__file__).resolve().parents[2]
FOLDER = pathlib.Path(os.environ["BRAVAIS_TEMPORARY"]) / "GeometryImageOfMesh"
OCTAHEDRON = """OFF
6 8 12 # vertices, triangles, edges
1 0 0  -1 0 0  0 1 0  0 -1 0  0 0 1  0 0 -1
3 0 2 4  3 2 1 4  3 1 3 4  3 3 0 4
3 2 0 5  3 1 2 5  3 3 1 5  3 0 3 5
"""


def run(*arguments):
    command = [sys.executable, ROOT / "Examples/Python/GeometryImageOfMesh.py", FOLDER, *arguments]
    return subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)


class TestGeometryImageOfMesh(unittest.TestCase):
    def passes(self, name, *arguments):
        """Percent, decibels, flipped triangles and stretch, of the first line printed."""
        result = run(*arguments)
        self.assertEqual(result.returncode, 0, result.stderr)
        number = r"([-+\d.]+)"
        found = re.search(rf"{number} % of the diagonal, {number} dB; {number} flipped, "
                          rf"stretch {number},", result.stdout)
        self.assertTrue(found, result.stdout)
        self.assertTrue(result.stdout.startswith(name + ": "), result.stdout)
        reader = vtkPNGReader()
        reader.SetFileName(str(FOLDER / f"geometry-image-{name}.png"))
        reader.Update()
        self.assertEqual(reader.GetOutput().GetDimensions(), (900, 300, 1))
        low, high = reader.GetOutput().GetScalarRange()
        self.assertGreater(high - low, 100)
        return [float(value) for value in found.groups()]

    def test_generated(self):
        percent, decibels, flipped, stretch = self.passes("generated", "--dimensions", "97", "97")
        self.assertLess(percent, 0.15)
        self.assertGreater(decibels, 56)
        self.assertEqual(flipped, 0)
        self.assertLess(stretch, 1.4)

    def test_file(self):
        FOLDER.mkdir(parents=True, exist_ok=True)
        path = FOLDER / "octahedron.off"
        path.write_text(OCTAHEDRON, encoding="ascii")
        percent, _, flipped, _ = self.passes("octahedron", path, "--dimensions", "65", "33")
        self.assertLess(percent, 2)
        self.assertEqual(flipped, 0)

    def test_bad_arguments(self):
        for arguments, word in ((("none.xyz",), "none.xyz"), (("none.ply",), "none.ply"),
                                (("--debian", "cow"), "cow is none of")):
            result = run(*arguments)
            self.assertGreater(result.returncode, 0)
            self.assertIn(word, result.stderr)
            self.assertNotIn("Traceback", result.stderr)


if __name__ == "__main__":
    unittest.main()
