# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
import math
import unittest

import numpy as np

from bravais import vtkGeometryImageSource
from checks import check_progress, check_threads, refuses, to_numpy

SHAPES = {"Sphere": 0, "Torus": 1, "BumpySphere": 2, "Plane": 3}


def make_source(shape, width, height, double=True):
    source = vtkGeometryImageSource()
    getattr(source, f"SetShapeTo{shape}")()
    source.SetDimensions(width, height)
    if double:
        source.SetOutputScalarTypeToDouble()
    return source


def run(*arguments, **keywords):
    source = make_source(*arguments, **keywords)
    source.Update()
    return to_numpy(source.GetOutput(), "Points")[0]


class TestGeometryImageSource(unittest.TestCase):
    def test_output(self):
        for shape, number in SHAPES.items():
            source = make_source(shape, 9, 5, double=False)
            self.assertEqual((source.GetShape(), source.GetShapeAsString()), (number, shape))
            source.Update()
            image = source.GetOutput()
            self.assertEqual(image.GetDimensions(), (9, 5, 1))
            self.assertEqual(image.GetPointData().GetVectors().GetName(), "Points")
            self.assertEqual(image.GetPointData().GetVectors().GetDataTypeAsString(), "float")
            lattice = image.GetFieldData().GetAbstractArray("Lattice")
            self.assertEqual(lattice.GetValue(0), "GeometryImage")

    def test_sphere(self):
        for points in run("Sphere", 17, 33), run("Sphere", 12, 7):
            np.testing.assert_allclose(np.linalg.norm(points, axis=-1), 1, atol=1e-15)
        np.testing.assert_array_equal(points[3, [0, -1]][:, 1:], [[0, 0], [0, 0]])
        points = run("Sphere", 17, 33)
        np.testing.assert_array_equal(points[16, 8], [0, 0, 1])
        np.testing.assert_array_equal(points[[0, 0, -1, -1], [0, -1, 0, -1]], [[0, 0, -1]] * 4)

    def test_edges_of_spheres_fold_on_themselves(self):
        for shape in "Sphere", "BumpySphere":
            for points in run(shape, 16, 33), run(shape, 65, 5), run(shape, 9, 9, double=False):
                for edge in points[0], points[-1], points[:, 0], points[:, -1]:
                    self.assertEqual(edge.tobytes(), edge[::-1].tobytes())

    def test_bumps(self):
        points = run("BumpySphere", 33, 33)
        radius = np.linalg.norm(points, axis=-1)
        expected = 1 + 0.2 * np.prod(np.sin(3 * math.pi * points / radius[..., None]), axis=-1)
        np.testing.assert_allclose(radius, expected, atol=1e-14)
        self.assertGreater(radius.max() - radius.min(), 0.1)

    def test_torus(self):
        points = run("Torus", 21, 14)
        ring = np.hypot(points[..., 0], points[..., 1]) - 1
        np.testing.assert_allclose(ring ** 2 + points[..., 2] ** 2, 0.16, atol=1e-15)
        np.testing.assert_array_equal(points[0], points[-1])
        np.testing.assert_array_equal(points[:, 0], points[:, -1])

    def test_plane(self):
        points = run("Plane", 5, 3)
        np.testing.assert_array_equal(points[..., 0], [[-1, -0.5, 0, 0.5, 1]] * 3)
        np.testing.assert_array_equal(points[..., 1], np.repeat([[-1], [0], [1]], 5, axis=1))
        np.testing.assert_array_equal(points[..., 2], 0)

    def test_triangles_face_outwards(self):
        for shape, middle in ("Sphere", 0), ("BumpySphere", 0), ("Torus", 1):
            p = run(shape, 18, 18)
            volume = 0
            for a, b, c in ((p[:-1, :-1], p[:-1, 1:], p[1:, :-1]), (p[1:, 1:], p[1:, :-1], p[:-1, 1:])):
                volume += np.sum(a * np.cross(b, c)) / 6
            self.assertGreater(volume, 2)

    def test_placement(self):
        for shape in SHAPES:
            source = make_source(shape, 8, 8)
            source.SetCenter(1, 2, 3)
            source.SetRadius(2)
            source.SetCrossSectionRadius(0.8)
            source.Update()
            points = to_numpy(source.GetOutput(), "Points")[0]
            np.testing.assert_allclose(points, 2 * run(shape, 8, 8) + [1, 2, 3], atol=1e-14)

    def test_few_gixels(self):
        for shape in SHAPES:
            for size in (1, 1), (1, 4), (3, 1), (2, 2):
                points = run(shape, *size)
                self.assertEqual(points.shape, size[::-1] + (3,))
                self.assertTrue(np.isfinite(points).all())

    def test_pipeline(self):
        for shape in SHAPES:
            source = make_source(shape, 130, 120)
            check_threads(self, source)
            source.Update()
            whole = to_numpy(source.GetOutput(), "Points")[0].copy()
            for x0, x1, y0, y1 in (0, 0, 0, 119), (3, 129, 7, 7), (5, 60, 100, 119):
                source.Modified()
                source.UpdateExtent((x0, x1, y0, y1, 0, 0))
                self.assertEqual(source.GetOutput().GetExtent(), (x0, x1, y0, y1, 0, 0))
                piece = to_numpy(source.GetOutput(), "Points")[0]
                np.testing.assert_array_equal(piece, whole[y0:y1 + 1, x0:x1 + 1])
        check_progress(self, source)

    def test_errors(self):
        for size in (0, 5), (5, -1):
            refuses(self, make_source("Sphere", *size), "Dimensions", str(min(size)))
        refuses(self, make_source("Sphere", 2 ** 30, 2 ** 30), "1073741824 x 1073741824")
        refuses(self, make_source("Plane", 2 ** 21, 2 ** 21), "bytes")
        nan = float("nan")
        for shape, name, value in (
                ("Sphere", "Radius", -1.0), ("Plane", "Radius", nan), ("Torus", "Radius", math.inf),
                ("Torus", "CrossSectionRadius", 0.0), ("BumpySphere", "BumpAmplitude", nan),
                ("BumpySphere", "BumpFrequency", math.inf), ("Sphere", "Center", (0.0, nan, 0.0))):
            source = make_source(shape, 5, 5)
            getattr(source, "Set" + name)(value)
            refuses(self, source, name)


if __name__ == "__main__":
    unittest.main()
