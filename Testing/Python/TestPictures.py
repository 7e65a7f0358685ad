# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures in few lines: what is drawn where, and files that come back."""
import math
import os
import unittest

import numpy
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkFiltersSources import vtkSphereSource

import bravais

FOLDER = os.environ["BRAVAIS_TEMPORARY"]


def get_shown(picture):
    """Which pixels are not the background, which the first column has alone."""
    return numpy.abs(picture.astype(int) - picture[:, :1]).max(axis=2) > 12


class TestRender(unittest.TestCase):
    def test_the_same_ball_by_three_mappers(self):
        """A BCC volume, a Cartesian one and a mesh: pictures differ by little along the edge."""
        bcc = bravais.apply(bravais.vtkBCCVolumeSource, Function="Sphere", Dimensions=(16, 16, 31))
        cartesian = bravais.apply(bravais.vtkBCCVolumeToImage, bcc, OutputDimensions=(31, 31, 31))
        self.assertEqual(bravais.isosurface(bcc, 0.8).GetMapper().GetClassName(), "vtkBCCVolumeMapper")
        self.assertNotIn("BCC", bravais.isosurface(cartesian, 0.8).GetMapper().GetClassName())
        view = {"size": (120, 100), "position": (0, -1, 0)}
        one, other = (get_shown(bravais.render(bravais.isosurface(v, 0.8), **view))
                      for v in (bcc, cartesian))
        self.assertEqual(one.shape, (100, 120))
        self.assertLess((one != other).mean(), 0.01)
        ball = bravais.apply(vtkSphereSource, Radius=0.8, ThetaResolution=64, PhiResolution=64)
        box = bravais.make_window(bravais.isosurface(bcc, 0.8), **view)
        renderer = box.GetRenderers().GetFirstRenderer()
        renderer.RemoveAllViewProps()
        renderer.AddActor(bravais.surface(ball))
        box.Render()
        self.assertLess((get_shown(bravais.grab(box)) != one).mean(), 0.01)

    def test_a_window_again(self):
        ball = bravais.surface(bravais.apply(vtkSphereSource))
        window = bravais.make_window(ball, size=(50, 40))
        first = bravais.render(window)
        numpy.testing.assert_array_equal(first, bravais.render(ball, size=(50, 40)))
        ball.GetProperty().SetColor(0, 0, 1)
        numpy.testing.assert_array_equal(bravais.grab(window), first)
        self.assertGreater(numpy.abs(bravais.render(window).astype(int) - first).max(), 50)

    def test_y_is_upwards(self):
        ball = bravais.apply(vtkSphereSource, Center=(0, 0, 3))
        floor = bravais.apply(vtkSphereSource)
        picture = bravais.render(bravais.surface(ball, (1, 0, 0)), bravais.surface(floor, (0, 0, 1)),
                                 size=(80, 80))
        shown = get_shown(picture)
        rows = [numpy.nonzero((picture[..., c] > picture[..., 2 - c] + 60) & shown)[0].mean()
                for c in (0, 2)]
        self.assertGreater(rows[0], rows[1] + 20)

    def test_zoom_and_color(self):
        mesh = bravais.apply(vtkSphereSource)
        small, large = (bravais.render(bravais.surface(mesh, (0, 1, 0)), size=(60, 60), zoom=zoom)
                        for zoom in (0.5, 1))
        self.assertAlmostEqual(get_shown(large).sum() / get_shown(small).sum(), 4, delta=1)
        red, green, blue = large[30, 30].astype(int)
        self.assertGreater(green, 2 * max(red, blue))

    def test_scalars_in_greys(self):
        """Voronoi cells, each with its texel's value."""
        image = bravais.rank1_from_numpy(numpy.arange(5), (1, 2))
        cells = bravais.apply(bravais.vtkRank1ImageToPolyData, image, Shape="VoronoiCells")
        picture = bravais.render(bravais.surface(cells, None), size=(90, 90), position=(0, 0, 1),
                                 up=(0, 1, 0))
        greys = picture[(numpy.ptp(picture.astype(int), axis=2) == 0)]
        values, counts = numpy.unique(greys[:, 0], return_counts=True)
        self.assertEqual((counts > 300).sum(), 5)
        self.assertGreaterEqual(values[counts > 300].max(), 254)


class TestFiles(unittest.TestCase):
    def test_round_trip(self):
        path = os.path.join(FOLDER, "picture.png")
        for shape in (5, 7), (5, 7, 3):
            pixels = numpy.random.default_rng(1).integers(0, 256, shape, dtype=numpy.uint8)
            bravais.write_picture(path, pixels)
            numpy.testing.assert_array_equal(bravais.read_picture(path), pixels)

    def test_numbers_become_bytes(self):
        path = os.path.join(FOLDER, "rounded.png")
        bravais.write_picture(path, [[-5.0, 0.4, 0.6], [254.6, 300.0, 17.0]])
        numpy.testing.assert_array_equal(bravais.read_picture(path), [[0, 0, 1], [255, 255, 17]])
        bravais.write_picture(path, [[math.nan, math.inf, -math.inf]])
        numpy.testing.assert_array_equal(bravais.read_picture(path), [[0, 255, 0]])

    def test_bad_input(self):
        with self.assertRaisesRegex(ValueError, r"\(2, 2, 2, 2\)"):
            bravais.write_picture(os.path.join(FOLDER, "a.png"), numpy.zeros((2, 2, 2, 2)))
        missing = os.path.join(FOLDER, "none", "a.png")
        with self.assertRaisesRegex(OSError, "none"):
            bravais.write_picture(missing, numpy.zeros((2, 2)))
        with self.assertRaisesRegex(RuntimeError, "none"):
            bravais.read_picture(missing)
        with self.assertRaisesRegex(ValueError, "7"):
            bravais.write_picture(os.path.join(FOLDER, "a.png"), numpy.zeros((2, 2, 7)))


class TestBadInput(unittest.TestCase):
    def test_no_volumes_meshes_and_props(self):
        image = bravais.image_from_numpy(numpy.zeros((2, 2, 2)))
        mesh = bravais.apply(vtkSphereSource)
        for call, words in (
                (lambda: bravais.isosurface(None, 0), "None is no vtkImageData"),
                (lambda: bravais.isosurface(numpy.zeros(4), 0), "array.* is no vtkImageData"),
                (lambda: bravais.isosurface(vtkImageData(), 0), "no scalars"),
                (lambda: bravais.isosurface(image, math.nan), "value is nan"),
                (lambda: bravais.surface(image), "vtkImageData is no vtkPolyData"),
                (lambda: bravais.surface(5), "5 is no vtkPolyData"),
                (lambda: bravais.surface(mesh, None), "no scalars"),
                (lambda: bravais.render(None), "None is no vtkProp"),
                (lambda: bravais.render(image), "vtkImageData is no vtkProp"),
                (lambda: bravais.render(bravais.surface(mesh), 5), "5 is no vtkProp"),
                (lambda: bravais.grab(None), "None is no vtkRenderWindow")):
            with self.assertRaisesRegex(ValueError, words):
                call()

    def test_views(self):
        for options, words in (({"size": (0, 5)}, r"size is \(0, 5\)"),
                               ({"size": (5, -1)}, r"size is \(5, -1\)"),
                               ({"zoom": 0}, "zoom is 0"), ({"zoom": math.nan}, "zoom is nan"),
                               ({"position": (0, 0, 0)}, "position is"),
                               ({"position": (1, math.nan, 0)}, "position is")):
            with self.assertRaisesRegex(ValueError, words):
                bravais.make_window(**options)


if __name__ == "__main__":
    unittest.main()
