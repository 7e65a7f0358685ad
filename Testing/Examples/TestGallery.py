# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
"""The gallery: an entry an example, and entries whose Python makes their pictures.

    TestGallery.py GALLERY              every example is there once, with a picture and some lines
    TestGallery.py GALLERY PICTURE.png  the lines make that picture, in a folder of their own

The files that some of them read are stood in for by small ones of the same kind.
"""
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

import bravais
import numpy
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkIOGeometry import vtkOBJWriter
from vtkmodules.vtkIOImage import vtkMetaImageWriter, vtkNIFTIImageWriter

PROGRAM = {"Cxx": r"^int main\(", "Python": r"\.parse_args\("}
MOST_LINES = 10  # besides imports
MOST_BYTES = 300_000


def make_ball(dtype, low, high):
    """A bumpy ball whose values fall from high in its middle to low."""
    z, y, x = numpy.mgrid[-1:1:36j, -1:1:40j, -1:1:38j]
    radius = numpy.sqrt(x * x + y * y + z * z) + 0.05 * numpy.sin(9 * x) * numpy.sin(9 * z)
    return (low + (high - low) / (1 + numpy.exp((radius - 0.7) * 12))).astype(dtype)


def write_head(path):
    image = bravais.image_from_numpy(make_ball("uint8", 0, 255), spacing=(5, 5, 5))
    bravais.apply(vtkNIFTIImageWriter, image, FileName=path)


def write_skull(path):
    image = bravais.image_from_numpy(make_ball("int16", -1000, 1500), spacing=(5, 5, 5))
    bravais.apply(vtkMetaImageWriter, image, FileName=path)


def write_bunny(path):
    ball = bravais.apply(vtkSphereSource, ThetaResolution=24, PhiResolution=16)
    bravais.apply(vtkOBJWriter, ball, FileName=path)


def write_portrait(path):
    y, x = numpy.mgrid[:512, :512] / 512
    rings = numpy.stack([numpy.sin(60 * numpy.hypot(x - a, y - 0.4)) for a in (0.2, 0.4, 0.6)], -1)
    bravais.write_picture(path, 127.5 + 100 * rings)


FILES = {"head.nii.gz": write_head, "brain.nii.gz": write_head, "skull.mhd": write_skull,
         "bunny.obj": write_bunny, "portrait.png": write_portrait}


def read_entries():
    """Title, pictures, blocks of Python and linked examples of each entry."""
    entries = []
    for text in re.split(r"^## ", GALLERY.read_text(encoding="utf-8"), flags=re.M)[1:]:
        title, _, text = text.partition("\n")
        entries.append((title, re.findall(r"!\[[^]]+\]\(gallery/([a-z0-9-]+\.png)\)", text),
                        re.findall(r"^```python\n(.*?)^```", text, re.M | re.S),
                        re.findall(r"\]\(\.\./Examples/([\w./]+)\)", text)))
    return entries


class TestPage(unittest.TestCase):
    def test_every_example_is_there_once(self):
        programs = []
        for language, sign in PROGRAM.items():
            for path in sorted((GALLERY.parents[1] / "Examples" / language).iterdir()):
                if path.suffix in (".cxx", ".py") and re.search(sign, path.read_text(), re.M):
                    programs.append(f"{language}/{path.name}")
        self.assertGreater(len(programs), 15)
        linked = [example for entry in read_entries() for example in entry[3]]
        self.assertEqual(sorted(linked), sorted(programs))

    def test_entries(self):
        titles, names = [], []
        for title, pictures, blocks, examples in read_entries():
            with self.subTest(title):
                self.assertEqual((len(pictures), len(blocks), len(examples)), (1, 1, 1))
                self.assertEqual(title.partition(",")[0], pathlib.Path(examples[0]).stem)
                self.assertIn(f'"{pictures[0]}"', blocks[0])
                lines = [line for line in blocks[0].splitlines() if line]
                self.assertLessEqual(max(map(len, lines)), 100)
                imports = [line for line in lines if re.match("import |from ", line)]
                statements = re.sub(r",\n\s+", ", ", blocks[0].strip()).splitlines()
                count = len([line for line in statements if line]) - len(imports)
                self.assertLessEqual(count, MOST_LINES)
                titles.append(title)
                names += pictures
        self.assertEqual(titles, sorted(titles))
        self.assertEqual(len(set(names)), len(titles))
        self.assertEqual(sorted(names), sorted(os.listdir(GALLERY.parent / "gallery")))


    def test_pictures_are_shown(self):
        """Every picture of the documentation is on one of its pages."""
        pages = GALLERY.parent.glob("*.md")
        text = "".join(page.read_text(encoding="utf-8") for page in pages)
        for path in GALLERY.parent.rglob("*.png"):
            self.assertIn(f"({path.relative_to(GALLERY.parent)})", text)


class TestPicture(unittest.TestCase):
    def test_lines_make_it(self):
        (block,) = (entry[2][0] for entry in read_entries() if PICTURE in entry[1])
        files = [name for name in FILES if f'"{name}"' in block]
        committed = GALLERY.parent / "gallery" / PICTURE
        self.assertLess(committed.stat().st_size, MOST_BYTES)
        with tempfile.TemporaryDirectory() as folder:
            for name in files:
                FILES[name](os.path.join(folder, name))
            result = subprocess.run([sys.executable, "-c", block], cwd=folder, text=True,
                                    stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
            self.assertEqual((result.returncode, result.stdout), (0, ""))
            pixels = bravais.read_picture(os.path.join(folder, PICTURE)).astype(int)
        expected = bravais.read_picture(str(committed)).astype(int)
        self.assertGreater(pixels.std(), 10)
        if files:  # another volume is of another size
            self.assertEqual(pixels.ndim, expected.ndim)
        else:
            self.assertEqual(pixels.shape, expected.shape)
            self.assertLess(numpy.abs(pixels - expected).mean(), 4)


if __name__ == "__main__":
    GALLERY, PICTURE = pathlib.Path(sys.argv[1]).resolve(), (sys.argv + [None])[2]
    unittest.main(argv=[sys.argv[0], "TestPicture" if PICTURE else "TestPage"])
