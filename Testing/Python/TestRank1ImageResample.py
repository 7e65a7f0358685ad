# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
import math
import unittest

import numpy as np
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOXML import vtkXMLImageDataReader, vtkXMLImageDataWriter

from bravais import vtkBCCLattice, vtkRank1ImageResample, vtkRank1Lattice
from checks import (
    PieceSource, check_numbered_pieces, check_pieces, check_progress, check_threads, make_image,
    refuses, to_numpy)
from rank1 import TYPES, get_marks, get_places, make_picture, resample

FILTERS = [vtkRank1ImageResample.Box, vtkRank1ImageResample.Bilinear,
           vtkRank1ImageResample.Bicubic, vtkRank1ImageResample.Nearest]


def run(*arguments, **keywords):
    algorithm = resample(*arguments, **keywords)
    algorithm.Update()
    return algorithm.GetOutput()


class TestRank1ImageResample(unittest.TestCase):
    def test_defaults(self):
        algorithm = vtkRank1ImageResample()
        self.assertEqual(algorithm.GetNumberOfPoints(), 0)
        self.assertEqual(algorithm.GetTiles(), (1, 1))
        self.assertEqual(algorithm.GetGenerator(), (0, 0))
        self.assertEqual(algorithm.GetFilterAsString(), "Automatic")
        self.assertEqual(algorithm.GetBoundaryModeAsString(), "Periodic")
        self.assertEqual(algorithm.GetLayoutAsString(), "Korobov")
        algorithm.SetFilterToBicubic()
        algorithm.SetBoundaryModeToMirror()
        algorithm.SetLayoutToLocality()
        for word in "Bicubic", "Mirror", "Locality":
            self.assertIn(word, str(algorithm))

    def test_layout_and_marks(self):
        _, image = make_picture((12, 20), spacing=(2, 3, 1), origin=(5, -7, 4), start=(3, 2, 0))
        output = run(image)
        lattice = vtkRank1Lattice()
        lattice.SetNumberOfPoints(240)
        lattice.SetAspect(40, 36)
        lattice.MaximizeMinimumDistance()
        domain = (5 + 2 * 2.5, 5 + 2 * 22.5, -7 + 3 * 1.5, -7 + 3 * 13.5)
        self.assertEqual(output.GetDimensions(), (240, 1, 1))
        self.assertEqual(get_marks(output), ("Rank1", (240, *lattice.GetGenerator()), domain))
        self.assertEqual(output.GetPointData().GetScalars().GetName(), "values")
        tiled = run(image, tiles=(4, 3))
        self.assertEqual(tiled.GetDimensions(), (20, 4, 3))
        self.assertEqual(get_marks(tiled)[2], domain)
        self.assertEqual(run(image, n=33, generator=(1, 5)).GetDimensions(), (33, 1, 1))

    def test_box_keeps_the_mean(self):
        for n in 1, 2, 7, 100, 239, 500:
            for tiles in (1, 1), (3, 2):
                values, image = make_picture((13, 17, 3))
                texels = to_numpy(run(image, n, tiles, filter=vtkRank1ImageResample.Box))
                np.testing.assert_allclose(
                    texels.mean((0, 1, 2)), values.mean((0, 1)), rtol=1e-12)

    def test_nearest_is_the_pixel_there(self):
        values, image = make_picture((13, 17), spacing=(2, 1, 1))
        output = run(image, 50, (3, 2), filter=vtkRank1ImageResample.Nearest)
        _, generator, domain = get_marks(output)
        x, y = np.moveaxis(get_places(generator, (3, 2), domain), -1, 0)
        pixels = values[np.floor(y + 0.5).astype(int), np.floor(x / 2 + 0.5).astype(int)]
        np.testing.assert_array_equal(to_numpy(output), pixels)

    def test_smooth_pictures(self):
        y, x = np.meshgrid(np.arange(64) + 0.5, np.arange(96) + 0.5, indexing="ij")
        f = lambda x, y: np.sin(2 * np.pi * (x / 96 + y / 32)) + np.cos(2 * np.pi * x / 48)
        image = make_image(f(x, y)[None], origin=(0.5, 0.5, 0))
        for method, tolerance in zip(FILTERS, (2e-2, 2e-2, 1e-3, 0.2)):
            output = run(image, 1000, filter=method)
            _, generator, domain = get_marks(output)
            places = get_places(generator, (1, 1), domain)
            np.testing.assert_allclose(
                to_numpy(output), f(*np.moveaxis(places, -1, 0)), atol=tolerance)

    def test_all_types_and_numbers_of_components(self):
        for dtype in TYPES:
            for components in 1, 2, 3, 5:
                shape = (9, 11) if components == 1 else (9, 11, components)
                values, image = make_picture(shape, dtype)
                exact = make_image(values.astype(float)[None])
                for method in FILTERS:
                    result = to_numpy(run(image, 40, filter=method))
                    self.assertEqual(result.dtype, dtype)
                    expected = to_numpy(run(exact, 40, filter=method))
                    if np.issubdtype(dtype, np.integer):
                        info = np.iinfo(dtype)
                        expected = np.clip(np.floor(expected + 0.5), info.min, info.max)
                    np.testing.assert_allclose(result, expected, rtol=1e-6)

    def test_floats_are_not_clamped(self):
        values, _ = make_picture((8, 8))
        values *= 1e30
        values[3, 4] = -1e35
        output = run(make_image(values[None].astype(np.float32)), filter=FILTERS[0])
        self.assertAlmostEqual(to_numpy(output).mean(dtype=float) / values.mean(), 1, 6)
        self.assertLess(to_numpy(output).min(), -1e34)

    def test_boundaries_differ_at_the_border_alone(self):
        _, image = make_picture((20, 20))
        for method in FILTERS[:3]:
            results = [to_numpy(run(image, 400, filter=method, boundary=mode)) for mode in range(3)]
            _, generator, domain = get_marks(run(image, 400))
            inside = ((get_places(generator) > 0.15) & (get_places(generator) < 0.85)).all(-1)
            for result in results[1:]:
                np.testing.assert_array_equal(result[inside], results[0][inside])
                self.assertGreater(np.abs(result - results[0]).max(), 1)

    def test_periodic_picture_may_be_rolled(self):
        # A shift of the picture by pixels that are whole tiles is a shift of tiles.
        values, image = make_picture((12, 20))
        first = to_numpy(run(image, 30, (5, 3)))
        rolled = make_image(np.roll(values, (4, -8), (0, 1))[None])
        np.testing.assert_allclose(
            to_numpy(run(rolled, 30, (5, 3))), np.roll(first, (1, -2), (0, 1)), atol=1e-12)

    def test_direction_matrix(self):
        values, image = make_picture((6, 9), spacing=(2, 3, 1), origin=(1, 2, 3))
        plain = run(image, 20)
        image.SetDirectionMatrix(0, -1, 0, 1, 0, 0, 0, 0, 1)
        turned = run(image, 20)
        np.testing.assert_array_equal(to_numpy(turned), to_numpy(plain))
        self.assertEqual(get_marks(turned)[2], (2 - 1, 2 + 17, -1 - 1.5, -1 + 16.5))
        self.assertEqual(turned.GetDirectionMatrix().GetElement(0, 1), -1)

    def test_locality_has_the_same_points(self):
        _, image = make_picture((32, 32))
        outputs = []
        for layout in 0, 1:
            algorithm = resample(image)
            algorithm.SetLayout(layout)
            algorithm.Update()
            outputs.append(algorithm.GetOutput())
        found = [{tuple(p): v for p, v in zip(
            np.round(get_places(get_marks(o)[1])[0, 0], 9), to_numpy(o)[0, 0])} for o in outputs]
        self.assertEqual(found[0].keys(), found[1].keys())
        self.assertEqual(found[0], found[1])
        self.assertNotEqual(get_marks(outputs[0]), get_marks(outputs[1]))

    def test_pieces_threads_and_progress(self):
        values, _ = make_picture((30, 40, 2), np.float32)
        source = PieceSource(make_image(values[None]))
        algorithm = vtkRank1ImageResample()
        algorithm.SetInputConnection(source.GetOutputPort())
        algorithm.SetNumberOfPoints(50)
        algorithm.SetTiles(7, 6)
        check_pieces(self, algorithm, bcc=False)
        check_numbered_pieces(self, algorithm, 5)
        check_threads(self, algorithm)
        check_progress(self, algorithm)
        self.assertEqual(source.asked[-1], [0, 39, 0, 29, 0, 0])

    def test_survives_a_file(self):
        _, image = make_picture((6, 9), np.uint8)
        output = run(image, 20, (2, 1))
        writer = vtkXMLImageDataWriter()
        writer.SetInputDataObject(output)
        writer.WriteToOutputStringOn()
        writer.Write()
        reader = vtkXMLImageDataReader()
        reader.ReadFromInputStringOn()
        reader.SetInputString(writer.GetOutputString())
        reader.Update()
        self.assertEqual(get_marks(reader.GetOutput()), get_marks(output))
        np.testing.assert_array_equal(to_numpy(reader.GetOutput()), to_numpy(output))

    def test_one_pixel(self):
        values, image = make_picture((1, 1))
        for n in 0, 1, 2, 97:
            np.testing.assert_allclose(to_numpy(run(image, n)), values[0, 0])

    def test_bad_parameters(self):
        _, image = make_picture((8, 8))
        for keywords, words in (
                (dict(n=-1), ["NumberOfPoints is -1"]),
                (dict(n=2 ** 40), ["NumberOfPoints is 1099511627776"]),
                (dict(n=2 ** 30 - 5, tiles=(1000, 1000)), ["bytes; the machine has"]),
                (dict(tiles=(0, 1)), ["Tiles are 0 x 1"]),
                (dict(tiles=(1, -3)), ["Tiles are 1 x -3"]),
                (dict(tiles=(2 ** 31 - 1, 2 ** 31 - 1)), ["Tiles are"]),
                (dict(tiles=(2 ** 20, 2 ** 20)), ["at most 268435456 tiles"]),
                (dict(n=8, generator=(2, 4)), ["(2, 4)", "4 points", "not 8"])):
            refuses(self, resample(image, **keywords), *words)

    def test_bad_input(self):
        refuses(self, resample(make_image(np.zeros((2, 4, 4)))), "4 x 4 x 2", "one layer")
        refuses(self, resample(vtkImageData()), "each has to be at least 1")
        empty = vtkImageData()
        empty.SetDimensions(4, 4, 1)
        refuses(self, resample(empty), "no point scalars")
        _, image = make_picture((8, 8))
        refuses(self, resample(run(image)), "tagged", "Rank1")
        vtkBCCLattice.Tag(image)
        refuses(self, resample(image), "tagged", "BCC")
        for spacing in (math.nan, 1, 1), (-1, 1, 1), (math.inf, 1, 1):
            _, image = make_picture((8, 8), spacing=spacing)
            refuses(self, resample(image), "spacing")
        _, image = make_picture((8, 8), spacing=(1e9, 1, 1))
        refuses(self, resample(image), "neither more than 1e+06 times the other")


if __name__ == "__main__":
    unittest.main()
