# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
import math
import unittest

import numpy as np

from bravais import vtkRank1Lattice
from checks import Errors


def make(n, generator=None, aspect=(1, 1)):
    lattice = vtkRank1Lattice()
    lattice.SetNumberOfPoints(n)
    lattice.SetAspect(*aspect)
    if generator:
        lattice.SetGenerator(*generator)
    else:
        assert lattice.MaximizeMinimumDistance()
    return lattice


def get_distances(points, uv, aspect):
    apart = points - uv
    return np.hypot(*((apart - np.round(apart)) * aspect).T)


def get_points(n, generator):
    return np.outer(np.arange(n), generator) % n / n


class TestRank1Lattice(unittest.TestCase):
    def test_defaults(self):
        lattice = vtkRank1Lattice()
        self.assertEqual(lattice.GetNumberOfPoints(), 1)
        self.assertEqual(lattice.GetAspect(), (1, 1))
        self.assertEqual(lattice.GetLayoutAsString(), "Korobov")
        self.assertEqual(lattice.GetMinimumDistance(), 1)

    def test_example_of_figure_5(self):
        lattice = make(56, (4, 7))
        for b1, b2 in ([0, 0], [0, 0]), ([0.0, 0.0], [0.0, 0.0]):
            lattice.GetBasis(b1, b2)
            self.assertEqual((b1, b2), ([8, 0], [4, 7]))
        kl = [0, 0]
        lattice.GetBasisIndices(kl)
        self.assertEqual(kl, [16, 1])
        self.assertEqual(lattice.GetIndex(-1, 3), 43)
        self.assertEqual(lattice.GetIndex(4, 5), 13)
        ids = [0] * 6
        lattice.GetNeighbors(35, ids)
        self.assertEqual(sorted(ids), [19, 20, 34, 36, 50, 51])
        self.assertAlmostEqual(lattice.GetMinimumDistance(), 8 / 56)
        self.assertAlmostEqual(lattice.GetSamplingEfficiency(), math.pi * 64 / (4 * 56))

    def test_best_lattices(self):
        self.assertEqual(make(56).GetGenerator(), (4, 7))
        self.assertEqual(make(262144).GetGenerator(), (1, 1990))
        for n in 2, 3, 97, 1000, 16384, 2 ** 24:
            lattice = make(n)
            best = lattice.GetMinimumDistance()
            for g in range(1, min(n, 60)):
                if math.gcd(g, n) == 1:
                    lattice.SetGenerator(1, g)
                    self.assertLessEqual(lattice.GetMinimumDistance(), best)

    def test_points_and_the_nearest_of_them(self):
        generator = np.random.default_rng(1)
        for n, g, aspect in (56, (4, 7), (1, 1)), (97, (5, 31), (2, 1)), (256, (1, 30), (1, 3)):
            lattice = make(n, g, aspect)
            points = get_points(n, g)
            uv = [0.0, 0.0]
            for i in range(n):
                lattice.GetPoint(i, uv)
                np.testing.assert_allclose(uv, points[i], atol=1e-15)
            for uv in generator.random((200, 2)) * 1.2 - 0.1:
                distances = get_distances(points, uv, aspect)
                self.assertAlmostEqual(distances[lattice.FindNearest(*uv)], distances.min())
            rest = get_distances(points, points[0], aspect)[1:]
            self.assertAlmostEqual(lattice.GetMinimumDistance(), rest.min())

    def test_theorem_2(self):
        lattice = make(210, (14, 15), (3, 2))
        b1, b2 = [0, 0], [0, 0]
        lattice.GetBasis(b1, b2)
        points = [tuple(p) for p in np.outer(np.arange(210), (14, 15)) % 210]
        for s in range(-20, 20):
            for t in range(-20, 20):
                x = tuple((s * b1[a] + t * b2[a]) % 210 for a in range(2))
                self.assertEqual(lattice.GetIndex(s, t), points.index(x))

    def test_cell_and_dual(self):
        lattice = make(97, (5, 31), (3, 2))
        corners = [0.0] * 12
        lattice.GetVoronoiCell(corners)
        x, y = np.array(corners).reshape(6, 2).T
        area = 0.5 * (x * np.roll(y, -1) - y * np.roll(x, -1)).sum()
        self.assertAlmostEqual(area, 1 / 97)
        b1, b2, d1, d2 = [0, 0], [0, 0], [0.0, 0.0], [0.0, 0.0]
        lattice.GetBasis(b1, b2)
        lattice.GetDualBasis(d1, d2)
        basis = np.array((b1, b2)) * (3, 2) / 97
        np.testing.assert_allclose(np.array((d1, d2)) @ basis.T, np.eye(2), atol=1e-12)

    def test_locality(self):
        korobov, local = make(2 ** 16), vtkRank1Lattice()
        local.SetNumberOfPoints(2 ** 16)
        local.SetLayoutToLocality()
        self.assertTrue(local.MaximizeMinimumDistance())
        self.assertEqual(local.GetMinimumDistance(), korobov.GetMinimumDistance())
        ids = [0] * 6
        local.GetNeighbors(0, ids)
        self.assertIn(1, ids)
        self.assertAlmostEqual(local.GetLayoutMeasure(16), (1 / 16 + 2) / 3)
        self.assertGreater(korobov.GetLayoutMeasure(16), local.GetLayoutMeasure(16))

    def test_bad_parameters(self):
        for n, g, aspect, words in (
                (0, (1, 1), (1, 1), ["number of points is 0"]),
                (-7, (1, 1), (1, 1), ["number of points is -7"]),
                (2 ** 31, (1, 1), (1, 1), ["2147483648"]),
                (8, (2, 4), (1, 1), ["(2, 4)", "4 points", "2 is one"]),
                (8, (1, 3), (-1, 1), ["-1 x 1"]),
                (8, (1, 3), (1, math.nan), ["1 x nan"]),
                (8, (1, 3), (1, math.inf), ["1 x inf"]),
                (8, (1, 3), (0, 1), ["0 x 1"])):
            lattice = make(n, g, aspect)
            ids = [0] * 6
            for question, answer in (
                    (lattice.GetMinimumDistance, 0), (lattice.GetSamplingEfficiency, 0),
                    (lambda: lattice.GetIndex(1, 2), -1), (lambda: lattice.FindNearest(0, 0), -1),
                    (lambda: lattice.GetNeighbors(0, ids), None)):
                with Errors(lattice) as errors:
                    self.assertEqual(question(), answer)
                self.assertEqual(len(errors.texts), 1)
                for word in words:
                    self.assertIn(word, errors.texts[0])
            self.assertEqual(ids, [-1] * 6)
        for n, aspect in (0, (1, 1)), (8, (-1, 1)), (8, (math.nan, 1)), (2 ** 31, (1, 1)):
            lattice = make(n, (1, 1), aspect)
            with Errors(lattice) as errors:
                self.assertFalse(lattice.MaximizeMinimumDistance())
            self.assertEqual(len(errors.texts), 1)
            self.assertEqual(lattice.GetGenerator(), (1, 1))

    def test_bad_arguments(self):
        lattice = make(8)
        for question in (lambda: lattice.FindNearest(math.nan, 0),
                         lambda: lattice.FindNearest(0, math.inf),
                         lambda: lattice.GetLayoutMeasure(0)):
            with Errors(lattice) as errors:
                self.assertLessEqual(question(), 0)
            self.assertEqual(len(errors.texts), 1)

    def test_small_numbers_of_points(self):
        self.assertEqual(make(1).GetMinimumDistance(), 1)
        self.assertAlmostEqual(make(2).GetMinimumDistance(), math.sqrt(0.5))
        self.assertAlmostEqual(make(2, aspect=(1, 4)).GetMinimumDistance(), 1)
        self.assertEqual(make(3).GetGenerator()[0], 1)

    def test_print(self):
        text = str(make(56))
        for word in "NumberOfPoints: 56", "Generator: (4, 7)", "Aspect: (1, 1)", "Layout: Korobov":
            self.assertIn(word, text)


if __name__ == "__main__":
    unittest.main()
