# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
"""The examples of locality masks, on small surfaces that they make or are given."""
import os
import pathlib
import subprocess
import sys
import unittest

from vtkmodules.vtkIOImage import vtkPNGReader

from bravais import vtkGeometryImageSource, vtkGeometryImageWriter

ROOT = pathlib.Path(__file__).resolve().parents[2]
FOLDER = pathlib.Path(os.environ["BRAVAIS_TEMPORARY"]) / "GeometryImageExamples"


def run(example, *arguments):
    """Lines that an example prints."""
    command = [sys.executable, ROOT / "Examples" / "Python" / example, *map(str, arguments)]
    return subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True).stdout.splitlines()


def write_torus():
    source = vtkGeometryImageSource()
    source.SetShapeToTorus()
    source.SetDimensions(49, 33)
    writer = vtkGeometryImageWriter()
    writer.SetInputConnection(source.GetOutputPort())
    FOLDER.mkdir(parents=True, exist_ok=True)
    writer.SetFileName(str(FOLDER / "torus.gim"))
    writer.Write()
    return FOLDER / "torus.gim"


def get_cells(line):
    """Rows of a table as lists of numbers, those of a cell apart."""
    return [[float(n.rstrip(" %")) for n in cell.split("/")] for cell in line.split("|")[3:-1]]


class TestGeometryImageExamples(unittest.TestCase):
    def check_picture(self, name, size):
        reader = vtkPNGReader()
        reader.SetFileName(str(FOLDER / name))
        reader.Update()
        self.assertEqual(reader.GetOutput().GetDimensions()[:2], size)
        lo, hi = reader.GetOutput().GetScalarRange()
        self.assertGreater(hi - lo, 100)

    def test_tables(self):
        for arguments, models in ((), 2), ((write_torus(),), 1):
            lines = run("LocalityMaskTables.py", *arguments, "--size", "33", "--depths", "2", "3")
            self.assertEqual(len(lines), 2 + 2 * models)
            for line in lines[2:]:
                depth, nodes, plain, runs, roaring, saved, _ = get_cells(line)
                self.assertIn(depth[0], (2, 3))
                self.assertLess(nodes[0], nodes[1])
                for a, b in (runs, plain), (roaring, runs):
                    self.assertLess(a[0], b[0])
                    self.assertLess(a[1], b[1])
                self.assertGreater(saved[0], 50)

    def test_session(self):
        for encoding in "RLE", "Roaring":
            lines = run("LocalityMaskSession.py", FOLDER, "--size", "33", "--depth", "3", "--frames", "30",
                        "--repeats", "1", "--width", "200", "--encoding", encoding)
            rows = [[float(n) for n in line.split("|")[1:-1]] for line in lines[3:-2]]
            self.assertGreater(len(rows), 3)
            for leaves, cull, united, _, masks, union, indices in rows:
                self.assertGreater(leaves, 0)
                self.assertLess(cull, united)
                self.assertLess(union, masks)
                self.assertLess(masks, indices)
            self.check_picture("locality-mask-session.png", (200, 300))

    def test_fly_through(self):
        lines = run("GeometryImageFlyThrough.py", FOLDER, write_torus(), "--depth", "3", "--size", "60",
                    "--frames", "8", "--pictures", "1", "5")
        self.assertEqual(len(lines), 4)
        for line in lines[::2]:
            seen, leaves = (int(line.split()[n]) for n in (2, 4))
            self.assertTrue(0 < seen < leaves)
            fine, coarse, coarser = (int(line.split()[n]) for n in (-6, -4, -2))
            self.assertTrue(fine > coarse > coarser > 0)
        for frame in 1, 5:
            self.check_picture(f"geometry-image-fly-through-{frame}.png", (180, 180))


if __name__ == "__main__":
    unittest.main()
