# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
import tempfile
import unittest

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkSMPTools
from vtkmodules.vtkCommonDataModel import (
    vtkCompositeDataSet, vtkImageData, vtkMultiBlockDataSet, vtkOverlappingAMR,
    vtkPartitionedDataSet, vtkPartitionedDataSetCollection, vtkPolyData)
from vtkmodules.vtkImagingCore import vtkImageShiftScale
from vtkmodules.vtkIOXML import vtkXMLMultiBlockDataReader, vtkXMLMultiBlockDataWriter

from bravais import (
    vtkBCCLattice, vtkRank1ImageResample, vtkRank1Lattice, vtkRank1TexturePyramid,
    vtkRank1TextureSampler)
from checks import Errors, PieceSource, make_image


def make_picture(width, height, components=1, dtype=np.float64, seed=2):
    values = np.random.default_rng(seed).integers(0, 100, (1, height, width, components))
    return (values[..., 0] if components == 1 else values).astype(dtype)


def make_pyramid(image, **properties):
    pyramid = vtkRank1TexturePyramid()
    pyramid.SetInputDataObject(make_image(image) if isinstance(image, np.ndarray) else image)
    for key, value in properties.items():
        getattr(pyramid, "Set" + key)(value)
    return pyramid


def get_blocks(pyramid):
    pyramid.Update()
    output = pyramid.GetOutputDataObject(0)
    return [output.GetBlock(n) for n in range(output.GetNumberOfBlocks())]


def get_texels(image):
    return vtk_to_numpy(image.GetPointData().GetScalars())


def get_generator(image):
    return tuple(int(g) for g in vtk_to_numpy(image.GetFieldData().GetArray("Rank1.Generator")))


class TestRank1TexturePyramid(unittest.TestCase):
    def test_mip_levels_have_a_fourth_of_the_texels(self):
        picture = make_picture(64, 64)
        for n, tiles in (4096, (1, 1)), (1000, (1, 1)), (256, (3, 2)), (7, (1, 1)):
            blocks = get_blocks(make_pyramid(picture, NumberOfPoints=n, Tiles=tiles))
            expected = []
            while n:
                expected.append((n, *tiles))
                n //= 4
            self.assertEqual([block.GetDimensions() for block in blocks], expected)
            texels = [block.GetNumberOfPoints() for block in blocks]
            self.assertLessEqual(3 * sum(texels), 4 * texels[0])

    def test_r_set_halves_tiles_independently(self):
        picture = make_picture(64, 64)
        for tiles, columns, rows in ((4, 4), [4, 2, 1], [4, 2, 1]), ((8, 1), [8, 4, 2, 1], [1]), \
                ((5, 3), [5, 2, 1], [3, 1]), ((1, 1), [1], [1]):
            pyramid = make_pyramid(picture, NumberOfPoints=32, Tiles=tiles)
            pyramid.SetKindToRSet()
            blocks = get_blocks(pyramid)
            self.assertEqual([block.GetDimensions() for block in blocks],
                             [(32, s, t) for t in rows for s in columns])
            self.assertEqual(len({get_generator(block) for block in blocks}), 1)
            texels = [block.GetNumberOfPoints() for block in blocks]
            self.assertLess(sum(texels), 4 * texels[0] + (len(texels) == 1))
            output = pyramid.GetOutputDataObject(0)
            names = [output.GetMetaData(n).Get(vtkCompositeDataSet.NAME())
                     for n in range(len(blocks))]
            self.assertEqual(names, [f"{s} x {t} tiles" for t in rows for s in columns])

    def test_each_level_is_resampled_from_the_picture(self):
        for components, dtype in (1, np.float64), (3, np.uint8), (2, np.float32):
            image = make_image(make_picture(40, 28, components, dtype), (0.5, 2, 1), (3, 4, 5))
            for kind in range(2):
                for filter in range(5):
                    pyramid = make_pyramid(image, Kind=kind, Tiles=(4, 2), NumberOfPoints=19,
                                           Filter=filter, BoundaryMode=filter % 3, Layout=1)
                    for level, block in enumerate(get_blocks(pyramid)):
                        single = vtkRank1ImageResample()
                        single.SetInputData(image)
                        single.SetFilter(filter)
                        single.SetBoundaryMode(filter % 3)
                        single.SetLayout(1)
                        single.SetNumberOfPoints(block.GetDimensions()[0])
                        single.SetTiles(block.GetDimensions()[1:])
                        single.SetGenerator(get_generator(block)[1:])
                        single.Update()
                        np.testing.assert_array_equal(
                            get_texels(block), get_texels(single.GetOutput()))
                        for name in "Rank1.Domain", "Rank1.Generator":
                            np.testing.assert_array_equal(
                                vtk_to_numpy(block.GetFieldData().GetArray(name)),
                                vtk_to_numpy(single.GetOutput().GetFieldData().GetArray(name)))
                        self.assertEqual(block.GetOrigin(), single.GetOutput().GetOrigin())

    def test_all_levels_have_the_pictures_mean(self):
        picture = make_picture(60, 44, 3)
        for properties in dict(NumberOfPoints=1024), dict(NumberOfPoints=97, Tiles=(5, 4), Kind=1):
            for block in get_blocks(make_pyramid(picture, **properties)):
                np.testing.assert_allclose(
                    get_texels(block).reshape(-1, 3).mean(0), picture.mean((0, 1, 2)), rtol=1e-12)

    def test_lattices_are_the_best_or_the_given_one(self):
        picture = make_picture(50, 30)
        blocks = get_blocks(make_pyramid(picture, NumberOfPoints=500, Generator=(1, 30)))
        self.assertEqual(get_generator(blocks[0]), (500, 1, 30))
        lattice = vtkRank1Lattice()
        lattice.SetAspect(50, 30)
        for block in blocks[1:]:
            lattice.SetNumberOfPoints(block.GetDimensions()[0])
            lattice.MaximizeMinimumDistance()
            self.assertEqual(get_generator(block)[1:], lattice.GetGenerator())

    def test_number_of_levels(self):
        picture = make_picture(64, 64)
        self.assertEqual(len(get_blocks(make_pyramid(picture))), 7)
        self.assertEqual(len(get_blocks(make_pyramid(picture, NumberOfLevels=3))), 3)
        self.assertEqual(len(get_blocks(make_pyramid(picture, NumberOfLevels=99))), 7)

    def test_a_picture_of_one_pixel_has_one_level_of_one_texel(self):
        for kind in range(2):
            blocks = get_blocks(make_pyramid(np.full((1, 1, 1), 7.5), Kind=kind))
            self.assertEqual([block.GetDimensions() for block in blocks], [(1, 1, 1)])
            self.assertEqual(get_texels(blocks[0]).tolist(), [7.5])
        # And so has a base of one texel, of any picture.
        picture = make_picture(9, 5)
        blocks = get_blocks(make_pyramid(picture, NumberOfPoints=1))
        self.assertEqual(len(blocks), 1)
        self.assertAlmostEqual(get_texels(blocks[0])[0], picture.mean())
        pyramid = make_pyramid(picture, NumberOfPoints=1, Tiles=(4, 2), Kind=1)
        self.assertEqual(len(get_blocks(pyramid)), 6)

    def test_the_whole_input_is_asked_for(self):
        source = PieceSource(make_image(make_picture(20, 10)))
        pyramid = vtkRank1TexturePyramid()
        pyramid.SetInputConnection(source.GetOutputPort())
        pyramid.Update()
        self.assertEqual(source.asked, [[0, 19, 0, 9, 0, 0]])

    def test_blocks_become_pyramids(self):
        pictures = [make_picture(9, 7), make_picture(20, 10, 3, np.uint8), make_picture(4, 4)]
        inner = vtkMultiBlockDataSet()
        inner.SetBlock(1, make_image(pictures[1]))
        inner.GetMetaData(1).Set(vtkCompositeDataSet.NAME(), "second")
        blocks = vtkMultiBlockDataSet()
        blocks.SetBlock(0, make_image(pictures[0]))
        blocks.SetBlock(1, inner)
        blocks.SetBlock(3, make_image(pictures[2]))
        for kind in range(2):
            pyramid = make_pyramid(blocks, Kind=kind, Tiles=(2, 1))
            amounts = []
            pyramid.AddObserver(
                "ProgressEvent", lambda *unused: amounts.append(pyramid.GetProgress()))
            pyramid.Update()
            self.assertEqual(amounts, sorted(amounts))
            self.assertEqual(amounts[-1], 1)
            output = pyramid.GetOutputDataObject(0)
            self.assertEqual(output.GetNumberOfBlocks(), 4)
            self.assertIsNone(output.GetBlock(2))
            self.assertEqual(output.GetBlock(1).GetNumberOfBlocks(), 2)
            self.assertIsNone(output.GetBlock(1).GetBlock(0))
            name = output.GetBlock(1).GetMetaData(1).Get(vtkCompositeDataSet.NAME())
            self.assertEqual(name, "second")
            found = output.GetBlock(0), output.GetBlock(1).GetBlock(1), output.GetBlock(3)
            for picture, levels in zip(pictures, found):
                alone = get_blocks(make_pyramid(picture, Kind=kind, Tiles=(2, 1)))
                self.assertEqual(levels.GetNumberOfBlocks(), len(alone))
                for number, level in enumerate(alone):
                    np.testing.assert_array_equal(
                        get_texels(levels.GetBlock(number)), get_texels(level))
            sampler = vtkRank1TextureSampler()
            sampler.SetInputData(found[1])
            self.assertTrue(sampler.Sample(0.3, 0.4, 0.02, 0, 0, 0.1, [0.0] * 3))

    def test_blocks_of_filters_and_partitions(self):
        parts = vtkPartitionedDataSetCollection()
        for number in range(2):
            part = vtkPartitionedDataSet()
            part.SetPartition(0, make_image(make_picture(8, 8 + number)))
            parts.SetPartitionedDataSet(number, part)
        shift = vtkImageShiftScale()  # takes the blocks one by one
        shift.SetInputDataObject(parts)
        shift.SetShift(1)
        pyramid = vtkRank1TexturePyramid()
        pyramid.SetInputConnection(shift.GetOutputPort())
        pyramid.Update()
        output = pyramid.GetOutputDataObject(0)
        for number in range(2):
            levels = output.GetBlock(number).GetBlock(0)
            alone = get_blocks(make_pyramid(make_picture(8, 8 + number) + 1))
            self.assertEqual(levels.GetNumberOfBlocks(), len(alone))
            np.testing.assert_array_equal(get_texels(levels.GetBlock(0)), get_texels(alone[0]))

    def test_threads_progress_and_abort(self):
        pyramid = make_pyramid(make_picture(90, 70, 3), Tiles=(4, 4), Kind=1)
        results = []
        for threads in 1, 2:
            vtkSMPTools.Initialize(threads)
            pyramid.Modified()
            results.append([get_texels(block).tobytes() for block in get_blocks(pyramid)])
        self.assertEqual(results[0], results[1])
        vtkSMPTools.Initialize(1)
        amounts = []
        tag = pyramid.AddObserver(
            "ProgressEvent", lambda *unused: amounts.append(pyramid.GetProgress()))
        pyramid.Modified()
        pyramid.Update()
        pyramid.RemoveObserver(tag)
        self.assertEqual(amounts, sorted(amounts))
        self.assertEqual(amounts[-1], 1)
        self.assertGreater(len(set(amounts)), 9)
        tag = pyramid.AddObserver(
            "ProgressEvent", lambda *unused: pyramid.SetAbortExecute(pyramid.GetProgress() > 0.5))
        pyramid.Modified()
        pyramid.Update()
        pyramid.RemoveObserver(tag)
        self.assertEqual(pyramid.GetOutputDataObject(0).GetNumberOfBlocks(), 0)
        vtkSMPTools.Initialize(0)
        pyramid.Modified()
        self.assertEqual(len(get_blocks(pyramid)), 9)

    def test_a_written_pyramid_is_one_when_it_is_read(self):
        for kind in range(2):
            pyramid = make_pyramid(make_picture(30, 30, 3), Kind=kind, Tiles=(4, 2))
            with tempfile.TemporaryDirectory() as folder:
                writer = vtkXMLMultiBlockDataWriter()
                writer.SetInputConnection(pyramid.GetOutputPort())
                writer.SetFileName(folder + "/p.vtm")
                writer.Write()
                reader = vtkXMLMultiBlockDataReader()
                reader.SetFileName(folder + "/p.vtm")
                reader.Update()
            values = []
            for texture in pyramid, reader:
                sampler = vtkRank1TextureSampler()
                sampler.SetInputConnection(texture.GetOutputPort())
                self.assertEqual(sampler.IsRSet(), kind == 1)
                value = [0.0] * 3
                self.assertTrue(sampler.Sample(0.3, 0.4, 0.02, 0, 0, 0.1, value))
                values.append(value)
            self.assertEqual(values[0], values[1])


class TestRank1TexturePyramidBadInput(unittest.TestCase):
    def refuses(self, pyramid, *words):
        """One error that has all these words in it, and an output without blocks."""
        with Errors(pyramid) as errors:
            pyramid.Update()
        self.assertEqual(len(errors.texts), 1, errors.texts)
        for word in words:
            self.assertIn(word, errors.texts[0])
        self.assertEqual(pyramid.GetOutputDataObject(0).GetNumberOfBlocks(), 0)

    def test_parameters(self):
        picture = make_picture(8, 8)
        for kind in range(2):
            def pyramid(**properties):
                return make_pyramid(picture, Kind=kind, **properties)
            self.refuses(pyramid(NumberOfPoints=-1), "NumberOfPoints is -1")
            self.refuses(pyramid(NumberOfPoints=2 ** 40), "NumberOfPoints is 1099511627776")
            self.refuses(pyramid(NumberOfPoints=2 ** 20, Tiles=(1000, 1000)), "bytes")
            self.refuses(pyramid(Tiles=(0, 1)), "Tiles are 0 x 1")
            self.refuses(pyramid(NumberOfPoints=12, Generator=(4, 6)), "(4, 6) makes 6 points")
            self.refuses(pyramid(NumberOfLevels=-2), "NumberOfLevels is -2")

    def test_images(self):
        self.refuses(make_pyramid(np.zeros((2, 8, 8))), "8 x 8 x 2")
        self.refuses(make_pyramid(vtkImageData()), "0 x 0 x 0")
        image = make_image(make_picture(8, 8))
        image.GetPointData().Initialize()
        self.refuses(make_pyramid(image), "point scalars")
        image = make_image(make_picture(8, 8))
        vtkBCCLattice.Tag(image)
        self.refuses(make_pyramid(image), "BCC")
        block = get_blocks(make_pyramid(make_picture(8, 8)))[0]
        self.refuses(make_pyramid(block), "Rank1")

    def test_blocks(self):
        blocks = vtkMultiBlockDataSet()
        for number in range(3):
            blocks.SetBlock(number, make_image(make_picture(8, 8)))
        pyramid = make_pyramid(blocks)
        self.assertEqual(len(get_blocks(pyramid)), 3)
        pyramid.SetTiles(0, 1)
        self.refuses(pyramid, "Tiles are 0 x 1")
        pyramid.SetTiles(1, 1)
        blocks.SetBlock(1, make_image(np.zeros((2, 8, 8))))
        self.refuses(make_pyramid(blocks), "picture 2 of 3", "8 x 8 x 2")
        blocks.SetBlock(1, vtkPolyData())
        self.refuses(make_pyramid(blocks), "vtkPolyData")
        grids = vtkOverlappingAMR()
        self.refuses(make_pyramid(grids), "vtkOverlappingAMR")

    def test_an_error_empties_an_earlier_output(self):
        pyramid = make_pyramid(make_picture(8, 8))
        self.assertEqual(len(get_blocks(pyramid)), 4)
        pyramid.SetTiles(-1, 1)
        self.refuses(pyramid, "Tiles are -1 x 1")
        pyramid.SetTiles(1, 1)
        self.assertEqual(len(get_blocks(pyramid)), 4)


if __name__ == "__main__":
    unittest.main()
