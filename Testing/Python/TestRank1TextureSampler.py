# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
import math
import unittest

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkFloatArray, vtkSMPTools
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkMultiBlockDataSet, vtkPolyData

from bravais import vtkRank1Lattice, vtkRank1TexturePyramid, vtkRank1TextureSampler
from checks import Errors, make_image

MODES = range(4)


def make_picture(width, height, components=1, dtype=np.float64, seed=2):
    values = np.random.default_rng(seed).integers(0, 100, (1, height, width, components))
    return (values[..., 0] if components == 1 else values).astype(dtype)


def make_pyramid(picture, spacing=(1, 1, 1), **properties):
    pyramid = vtkRank1TexturePyramid()
    pyramid.SetInputData(make_image(picture, spacing))
    for key, value in properties.items():
        getattr(pyramid, "Set" + key)(value)
    pyramid.Update()
    return pyramid.GetOutput()


def make_sampler(texture, **properties):
    sampler = vtkRank1TextureSampler()
    sampler.SetInputData(texture)
    for key, value in properties.items():
        getattr(sampler, "Set" + key)(value)
    return sampler


def sample(sampler, uv, footprints=None):
    uv = np.asarray(uv, float).reshape(-1, 2)
    result = vtkDoubleArray()
    if footprints is not None:
        footprints = numpy_to_vtk(np.asarray(footprints, float).reshape(-1, 4), deep=True)
    assert sampler.Sample(numpy_to_vtk(uv, deep=True), footprints, result)
    return vtk_to_numpy(result).copy()


def make_points(count=200, seed=4):
    return np.random.default_rng(seed).uniform(-1.5, 2.5, (count, 2))


def single(sampler, u, v, footprint):
    value = [0.0] * sampler.GetNumberOfComponents()
    assert sampler.Sample(u, v, *footprint, value)
    return value


class TestRank1TextureSampler(unittest.TestCase):
    def test_defaults(self):
        sampler = vtkRank1TextureSampler()
        self.assertEqual(sampler.GetInterpolationAsString(), "Barycentric")
        self.assertEqual(sampler.GetLevelFilterAsString(), "Trilinear")

    def test_texels_are_found_at_their_points(self):
        for components, tiles in (1, (1, 1)), (3, (3, 2)):
            texture = make_pyramid(make_picture(30, 20, components), Tiles=tiles)
            block = texture.GetBlock(0)
            n, g1, g2 = vtk_to_numpy(block.GetFieldData().GetArray("Rank1.Generator"))
            texels = vtk_to_numpy(block.GetPointData().GetScalars()).reshape(-1, components)
            i = np.arange(n)
            for mode in MODES[:3]:
                sampler = make_sampler(texture, Interpolation=mode)
                for y in range(tiles[1]):
                    for x in range(tiles[0]):
                        uv = np.stack(((x + i * g1 % n / n) / tiles[0],
                                       (y + i * g2 % n / n) / tiles[1]), -1)
                        first = n * (x + tiles[0] * y)
                        np.testing.assert_allclose(
                            sample(sampler, uv).reshape(-1, components), texels[first:first + n],
                            atol=1e-8)

    def test_levels_by_hand(self):
        # 4096 texels on a square are 64 spacings along each side.
        sampler = make_sampler(make_pyramid(make_picture(64, 64)))
        self.assertEqual(sampler.GetNumberOfLevels(), 7)
        for footprint, level in (
                ((1 / 64, 0, 0, 1 / 64), 0), ((2 / 64, 0, 0, 1 / 64), 1), ((0, 0, 0, -4 / 64), 2),
                ((3 / 64, 4 / 64, 1 / 64, 0), math.log2(5)), ((1 / 64, 1 / 64, 0, 0), 0.5),
                ((1 / 64, 1 / 64, 8 / 64, 10 / 64), math.log2(math.sqrt(164))),
                ((1 / 128, 0, 0, 1 / 256), -1)):
            self.assertAlmostEqual(sampler.GetLevel(*footprint), level)
            nearest = min(max(math.ceil(level - 0.5), 0), 6)
            self.assertEqual(sampler.GetNearestLevel(*footprint), nearest, footprint)
        self.assertEqual(sampler.GetLevel(0, 0, 0, 0), -math.inf)
        self.assertEqual(sampler.GetNearestLevel(1e9, 0, 0, 0), 6)
        self.assertEqual(sampler.GetNearestLevel(math.inf, 0, 0, 0), 6)
        self.assertEqual(sampler.GetNearestLevel(math.nan, 0, 0, 0), -1)
        # 2:1, and pixels that are not square: 128 x 32 spacings.
        sampler = make_sampler(make_pyramid(make_picture(64, 64), (4, 1, 1)))
        self.assertAlmostEqual(sampler.GetLevel(4 / 128, 0, 0, 0), 2)
        self.assertAlmostEqual(sampler.GetLevel(0, 4 / 32, 0, 0), 2)
        # Tiles count too.
        sampler = make_sampler(make_pyramid(make_picture(64, 64), Tiles=(4, 4), NumberOfPoints=64))
        self.assertAlmostEqual(sampler.GetLevel(2 / 32, 0, 0, 0), 1)

    def test_members_by_hand(self):
        texture = make_pyramid(make_picture(64, 64), Tiles=(8, 4), NumberOfPoints=128, Kind=1)
        sampler = make_sampler(texture)
        self.assertTrue(sampler.IsRSet())
        self.assertEqual(sampler.GetNumberOfLevels(), 12)
        counts, member, levels = [0, 0], [0, 0], [0.0, 0.0]
        sampler.GetNumberOfMembers(counts)
        self.assertEqual(counts, [4, 3])
        # 8 x 4 tiles of 128 texels are 64 spacings each way.
        for width, height, expected in (
                (1, 1, (0, 0)), (4, 2, (2, 1)), (1, 4, (0, 2)), (8, 1, (3, 0)), (3, 3, (2, 2)),
                (1.9, 0.9, (1, 0)), (2.1, 2.1, (2, 2)), (5, 1.5, (3, 1)), (0.1, 0.1, (0, 0)),
                (0.1, 3, (0, 2)), (99, 99, (3, 2)), (99, 1, (3, 0)), (0, 0, (0, 0))):
            footprint = width / 64, 0, 0, height / 64
            sampler.GetNearestMember(*footprint, member)
            self.assertEqual(tuple(member), expected, (width, height))
            if width and height:
                sampler.GetMemberLevels(*footprint, levels)
                self.assertAlmostEqual(levels[0], math.log2(width))
                self.assertAlmostEqual(levels[1], math.log2(height))
        # The same member whichever axis of the footprint is along u.
        sampler.GetNearestMember(0, 2 / 64, 4 / 64, 0, member)
        self.assertEqual(member, [2, 1])

    def test_nearest_level_is_a_look_up_in_that_level(self):
        uv = make_points()
        for kind in range(2):
            texture = make_pyramid(make_picture(32, 32, 3), Tiles=(4, 4), Kind=kind)
            for mode in MODES:
                sampler = make_sampler(texture, Interpolation=mode, LevelFilter=0)
                for footprint in (0, 0, 0, 0), (4 / 32, 0, 0, 1 / 32), (0.1, 0.2, 0.3, 0.4):
                    level = sampler.GetNearestLevel(*footprint)
                    alone = make_sampler(texture.GetBlock(level), Interpolation=mode)
                    np.testing.assert_array_equal(
                        sample(sampler, uv, footprint), sample(alone, uv))

    def test_trilinear_is_a_blend_of_levels(self):
        texture = make_pyramid(make_picture(32, 32))
        uv = make_points()
        levels = [sample(make_sampler(texture.GetBlock(n)), uv) for n in range(6)]
        sampler = make_sampler(texture)
        for level in -1, 0, 0.25, 1, 2.75, 4.5, 5, 6:
            lower = int(min(max(level, 0), 4))
            share = min(max(level - lower, 0), 1)
            np.testing.assert_allclose(
                sample(sampler, uv, (2 ** level / 32, 0, 0, 0)),
                (1 - share) * levels[lower] + share * levels[lower + 1], atol=1e-9)

    def test_blend_of_four_members(self):
        texture = make_pyramid(make_picture(32, 32), Tiles=(4, 4), Kind=1)
        uv = make_points()
        members = [sample(make_sampler(texture.GetBlock(n)), uv) for n in range(9)]
        sampler = make_sampler(texture)
        for a, b in (0, 0), (0.5, 0), (0.25, 1.5), (2, 1), (1.75, 1.25), (3, -2):
            i, j = (int(min(max(x, 0), 1)) for x in (a, b))
            f, g = (min(max(x - k, 0), 1) for x, k in ((a, i), (b, j)))
            expected = sum(
                (f if x else 1 - f) * (g if y else 1 - g) * members[i + x + 3 * (j + y)]
                for x in (0, 1) for y in (0, 1))
            np.testing.assert_allclose(
                sample(sampler, uv, (2.0 ** a / 32, 0, 0, 2.0 ** b / 32)), expected, atol=1e-9)

    def test_trilinear_has_no_jumps(self):
        sizes = 2.0 ** np.linspace(-8, 2, 4001)
        for kind in range(2):
            texture = make_pyramid(make_picture(32, 32), Tiles=(8, 8), NumberOfPoints=16, Kind=kind)
            for axis in 0, 3:
                footprints = np.zeros((len(sizes), 4))
                footprints[:, axis] = sizes
                uv = np.full((len(sizes), 2), 0.37)
                values = sample(make_sampler(texture), uv, footprints)
                self.assertLess(abs(np.diff(values)).max(), 1)
                jumps = sample(make_sampler(texture, LevelFilter=0), uv, footprints)
                self.assertGreater(abs(np.diff(jumps)).max(), 3)

    def test_a_constant_stays_and_weights_sum_to_one(self):
        for kind in range(2):
            texture = make_pyramid(np.full((1, 16, 24), 3.25), Tiles=(2, 4), Kind=kind)
            footprints = np.random.default_rng(1).normal(0, 0.1, (200, 4))
            for mode in MODES:
                for level_filter in range(2):
                    sampler = make_sampler(texture, Interpolation=mode, LevelFilter=level_filter)
                    np.testing.assert_allclose(
                        sample(sampler, make_points(), footprints), 3.25, atol=1e-12)

    def test_the_picture_repeats(self):
        sampler = make_sampler(make_pyramid(make_picture(16, 16), Tiles=(2, 2)))
        uv = make_points()
        for mode in MODES:
            sampler.SetInterpolation(mode)
            np.testing.assert_allclose(
                sample(sampler, uv), sample(sampler, uv + (3, -5)), atol=1e-9)

    def test_linear_interpolation_between_the_three_texels_round_a_point(self):
        # On a triangle of neighbours 0, b1, b2, by the lattice's own functions.
        texture = make_pyramid(make_picture(20, 20), NumberOfPoints=97)
        block = texture.GetBlock(0)
        texels = vtk_to_numpy(block.GetPointData().GetScalars())
        n, g1, g2 = (int(g) for g in vtk_to_numpy(block.GetFieldData().GetArray("Rank1.Generator")))
        lattice = vtkRank1Lattice()
        lattice.SetNumberOfPoints(n)
        lattice.SetGenerator(g1, g2)
        b1, b2, kl = [0.0, 0.0], [0.0, 0.0], [0, 0]
        lattice.GetBasis(b1, b2)
        lattice.GetBasisIndices(kl)
        b1, b2 = np.array(b1) / n, np.array(b2) / n
        sampler = make_sampler(block)
        for s, t in (0.2, 0.3), (0.9, 0.05), (0, 0.5):
            expected = (1 - s - t) * texels[0] + s * texels[kl[0]] + t * texels[kl[1]]
            self.assertAlmostEqual(sample(sampler, s * b1 + t * b2)[0], expected, 9)

    def test_all_types(self):
        for dtype in (np.int8, np.uint8, np.int16, np.uint16, np.int32, np.uint32, np.int64,
                      np.uint64, np.float32, np.float64):
            for components in 1, 2, 5:
                texture = make_pyramid(make_picture(12, 9, components, dtype))
                block = texture.GetBlock(0)
                texels = vtk_to_numpy(block.GetPointData().GetScalars()).reshape(-1, components)
                value = single(make_sampler(texture, Interpolation=0), 0, 0, (0, 0, 0, 0))
                self.assertEqual(value, texels[0].tolist())

    def test_single_and_many_are_the_same(self):
        texture = make_pyramid(make_picture(32, 32, 3), Tiles=(4, 2), Kind=1)
        uv = make_points(50)
        footprints = np.random.default_rng(3).normal(0, 0.1, (50, 4))
        for mode in MODES:
            for level_filter in range(2):
                sampler = make_sampler(texture, Interpolation=mode, LevelFilter=level_filter)
                values = sample(sampler, uv, footprints)
                for (u, v), footprint, value in zip(uv, footprints, values):
                    self.assertEqual(single(sampler, u, v, footprint), value.tolist())

    def test_arrays_of_other_types_and_shapes(self):
        sampler = make_sampler(make_pyramid(make_picture(16, 16, 3)))
        uv = np.round(make_points() * 64) / 64
        expected = sample(sampler, uv, (0.25, 0, 0, 0.5))
        coordinates = numpy_to_vtk(np.c_[uv, uv[:, 0]].astype(np.float32), deep=True)
        result = vtkFloatArray()
        result.SetName("colours")
        footprints = numpy_to_vtk(np.array([[0.25, 0, 0, 0.5]], np.float32), deep=True)
        self.assertTrue(sampler.Sample(coordinates, footprints, result))
        self.assertEqual(result.GetName(), "colours")
        np.testing.assert_allclose(vtk_to_numpy(result), expected, rtol=1e-6)
        self.assertTrue(sampler.Sample(coordinates, footprints, coordinates))  # in place
        np.testing.assert_array_equal(vtk_to_numpy(coordinates), vtk_to_numpy(result))
        empty = vtkDoubleArray()
        empty.SetNumberOfComponents(2)
        self.assertTrue(sampler.Sample(empty, None, result))
        self.assertEqual(result.GetNumberOfTuples(), 0)
        self.assertEqual(result.GetNumberOfComponents(), 3)

    def test_threads(self):
        texture = make_pyramid(make_picture(32, 32, 3), Kind=0)
        uv = make_points(20000)
        footprints = np.random.default_rng(3).normal(0, 0.1, (20000, 4))
        results = []
        for threads in 1, 2:
            vtkSMPTools.Initialize(threads)
            results.append(sample(make_sampler(texture), uv, footprints).tobytes())
        vtkSMPTools.Initialize(0)
        self.assertEqual(results[0], results[1])

    def test_changes_of_the_texture_are_seen(self):
        pyramid = vtkRank1TexturePyramid()
        pyramid.SetInputData(make_image(np.full((1, 8, 8), 1, np.uint8)))
        sampler = vtkRank1TextureSampler()
        sampler.SetInterpolationToNearest()
        sampler.SetInputConnection(pyramid.GetOutputPort())
        self.assertEqual(single(sampler, 0.1, 0.2, (0, 0, 0, 0)), [1])
        pyramid.SetInputData(make_image(np.full((1, 8, 8, 2), 2, np.uint8)))
        self.assertEqual(single(sampler, 0.1, 0.2, (0, 0, 0, 0)), [2, 2])
        block = pyramid.GetOutput().GetBlock(0)
        block.GetPointData().GetScalars().Fill(5)
        self.assertEqual(single(sampler, 0.1, 0.2, (0, 0, 0, 0)), [5, 5])

    def test_coordinates_and_footprints_that_are_no_numbers(self):
        sampler = make_sampler(make_pyramid(make_picture(8, 8, 2)))
        nan, inf = math.nan, math.inf
        for u, v, footprint in ((nan, 0, (0, 0, 0, 0)), (0, inf, (0, 0, 0, 0)),
                                (0, 0, (nan, 0, 0, 0)), (0, 0, (0, 0, 0, nan))):
            self.assertTrue(all(map(math.isnan, single(sampler, u, v, footprint))))
        mean = single(sampler, 0.3, 0.3, (9, 9, 9, 9))
        self.assertEqual(single(sampler, 0.3, 0.3, (inf, 0, 0, -inf)), mean)

    def test_texels_that_are_no_numbers_spoil_no_others(self):
        texture = make_pyramid(make_picture(16, 16), NumberOfLevels=1)
        block = texture.GetBlock(0)
        clean = sample(make_sampler(block, Interpolation=0), make_points(2000))
        block.GetPointData().GetScalars().SetValue(77, math.nan)
        values = sample(make_sampler(block, Interpolation=0), make_points(2000))
        self.assertTrue(np.isnan(values).any())
        np.testing.assert_array_equal(np.where(np.isnan(values), clean, values), clean)
        # Exactly on texel 0, the other corners of its triangle have no weight.
        for n in range(1, block.GetNumberOfPoints()):
            block.GetPointData().GetScalars().SetValue(n, math.inf)
        for mode in MODES[:3]:
            self.assertTrue(math.isfinite(
                sample(make_sampler(block, Interpolation=mode), (0, 0))[0]))


class TestRank1TextureSamplerBadInput(unittest.TestCase):
    def refuses(self, sampler, *words, coordinates=np.zeros((3, 2)), footprints=None):
        with Errors(sampler) as errors:
            result = vtkDoubleArray()
            wrapped = [None if a is None else numpy_to_vtk(a, deep=True)
                       for a in (coordinates, footprints)]
            self.assertFalse(sampler.Sample(*wrapped, result))
        self.assertEqual(len(errors.texts), 1, errors.texts)
        for word in words:
            self.assertIn(word, errors.texts[0])
        self.assertEqual(result.GetNumberOfTuples(), 0)

    def test_textures(self):
        self.refuses(vtkRank1TextureSampler(), "no texture")
        for texture in vtkPolyData(), vtkImageData(), make_image(make_picture(4, 4)):
            self.refuses(make_sampler(texture), "no rank-1 image", "Lattice")
        self.refuses(make_sampler(vtkMultiBlockDataSet()), "0 blocks")

    def test_blocks_that_make_no_pyramid(self):
        texture = make_pyramid(make_picture(16, 16))
        texture.GetBlock(2).GetFieldData().RemoveArray("Lattice")
        self.refuses(make_sampler(texture), "Block 2", "no rank-1 image")
        texture = make_pyramid(make_picture(16, 16))
        texture.SetBlock(1, texture.GetBlock(2))
        self.refuses(make_sampler(texture), "Block 1", "16 x 1 x 1", "64 x 1 x 1")
        texture = make_pyramid(make_picture(16, 16), Tiles=(4, 4), Kind=1)
        texture.RemoveBlock(8)
        self.refuses(make_sampler(texture), "8 members", "9 were expected")
        texture = make_pyramid(make_picture(16, 16))
        floats = make_pyramid(make_picture(16, 16, dtype=np.float32))
        texture.SetBlock(1, floats.GetBlock(1))
        self.refuses(make_sampler(texture), "Block 1", "float", "double")
        texture = make_pyramid(make_picture(16, 16))
        texture.GetBlock(1).GetFieldData().RemoveArray("Rank1.Generator")
        self.refuses(make_sampler(texture), "Rank1.Generator")

    def test_arrays(self):
        sampler = make_sampler(make_pyramid(make_picture(16, 16)))
        self.refuses(sampler, "The coordinates are 3 tuples of 1", coordinates=np.zeros((3, 1)))
        self.refuses(sampler, "The coordinates are no array", coordinates=None)
        self.refuses(sampler, "The footprints are 3 tuples of 3", footprints=np.zeros((3, 3)))
        self.refuses(sampler, "The footprints are 2 tuples of 4", "3 tuples, or one",
                     footprints=np.zeros((2, 4)))


if __name__ == "__main__":
    unittest.main()
