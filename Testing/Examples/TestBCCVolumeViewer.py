# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
"""The viewers, C++ and Python: every file type, mode and kind of bad input."""
import os

import numpy
from bravais import vtkBCCVolumeSource
from vtkmodules.vtkIOXML import vtkXMLImageDataWriter

import examples


class TestBCCVolumeViewer(examples.ExampleTest):
    def setUp(self):
        super().setUp()
        self.volumes = examples.write_volumes(self.folder)

    def test_help(self):
        text = self.passes("--help")
        for word in "--isovalue", "--kernel", "--prefilter", "--mode", "--interactive":
            self.assertIn(word, text)

    def test_file_types(self):
        pictures = []
        for volume in self.volumes:
            self.passes(volume, "-i", 40, "-s", 80, 60)
            self.shows("volume.png", (80, 60))
            pictures.append(examples.read_picture(self.path("volume.png")))
        for picture in pictures[1:]:
            self.assertLess(numpy.abs(picture - pictures[0]).mean(), 0.5)

    def test_modes_and_kernels(self):
        for arguments in (["-m", "composite", "-i", "30,60"], ["-m", "mip"], ["-k", "bcc12"],
                          ["-k", "bcc8", "-p", "interpolation"], ["-p", "projection"],
                          ["-k", "bcc4", "-p", "none", "-r", 0.5]):
            self.passes(self.volumes[0], *arguments, "-s", 60, 60, "-o", "a.png")
            self.shows("a.png", (60, 60))

    def test_isolate_and_crop(self):
        def count(*arguments):
            self.passes(self.volumes[0], "-i", 40, "-s", 100, 100, *arguments)
            return self.shows("volume.png", (100, 100), 0.01)
        everything = count()
        self.assertLess(count("--isolate", 30), everything)
        self.assertLess(count("--crop", 0, 1, 0, 1, 0.5, 1), 0.8 * everything)
        self.assertGreater(count("--zoom", 1.5), 1.4 * everything)

    def test_bcc_volume(self):
        source = vtkBCCVolumeSource()
        source.Update()
        path = self.path("lobb.vti")
        examples.write(vtkXMLImageDataWriter(), source.GetOutput(), path)
        text = self.passes(path, "-i", 0.5, "-s", 60, 60)
        self.assertIn("39 x 39 x 78", text)
        self.shows("volume.png", (60, 60))

    def test_truncated_files(self):
        for volume in self.volumes:
            name = volume.replace(".mhd", ".raw")
            with open(name, "rb") as file:
                content = file.read()
            with open(name, "wb") as file:
                file.write(content[:len(content) // 2])
            with self.subTest(volume):
                self.refuses(os.path.basename(volume), volume, "-s", 20, 20)

    def test_bad_input(self):
        self.refuses("there is no such file", self.path("none.vti"))
        text = self.path("text.txt")
        with open(text, "w", encoding="ascii") as file:
            file.write("no volume")
        self.refuses("unknown type", text)
        os.rename(text, self.path("text.vti"))
        self.refuses("text.vti", self.path("text.vti"))
        flat = self.path("flat.vti")
        examples.write(
            vtkXMLImageDataWriter(), examples.make_image(numpy.zeros((1, 8, 8), "u1")), flat)
        self.refuses("8 x 8 x 1", flat)
        ball = self.volumes[0]
        self.refuses("nan is not a finite number", ball, "-i", "nan")
        self.refuses("outside the volume's values", ball, "-i", 1000)
        self.refuses("bcc9", ball, "-k", "bcc9")
        self.refuses("Ratio", ball, "-r", 0)
        self.refuses("nterpolation", ball, "-p", "interpolation", "-k", "bcc7")
        self.refuses("none/a.png", ball, "-o", self.path("none/a.png"), "-s", 20, 20)


if __name__ == "__main__":
    examples.main()
