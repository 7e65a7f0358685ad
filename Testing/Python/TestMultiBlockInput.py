# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
"""What all filters make of a vtkMultiBlockDataSet, whose blocks VTK gives them one by one."""
import math
import unittest

import numpy as np
from vtkmodules.vtkCommonCore import VTK_BIT, VTK_STRING
from vtkmodules.vtkCommonDataModel import (
    vtkMultiBlockDataSet, vtkPlane, vtkPolyData, vtkSphere, vtkTable)
from vtkmodules.vtkCommonExecutionModel import vtkTrivialProducer
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkImagingCore import vtkImageChangeInformation
from vtkmodules.vtkRenderingCore import vtkCamera

from bravais import (
    vtkBCCInterpolator, vtkBCCPrefilter, vtkBCCVolumeSource, vtkBCCVolumeToImage,
    vtkGeometryImageLocalityMask, vtkGeometryImageSource, vtkGeometryImageToPolyData,
    vtkImageToBCCVolume, vtkOrderedDither, vtkPolyDataToGeometryImage, vtkRank1ImageReconstruct,
    vtkRank1ImageResample, vtkRank1ImageToPolyData, vtkRank1TexturePyramid)
from checks import Errors, make_image

NAN = math.nan


def run(algorithm, port=0):
    algorithm.Update()
    return algorithm.GetOutputDataObject(port)


def make_volume(number):
    source = vtkBCCVolumeSource()
    source.SetDimensions(4 + number, 3, 6)
    return run(source)


def make_picture(number):
    return make_image(np.random.default_rng(number).normal(size=(1, 6, 5 + number)))


def make_cube(number):
    return make_image(np.random.default_rng(number).normal(size=(5, 6, 5 + number)))


def make_rank1(number):
    resample = vtkRank1ImageResample()
    resample.SetInputData(make_picture(number))
    return run(resample)


def make_geometry(number):
    source = vtkGeometryImageSource()
    source.SetDimensions(9, 9 + 2 * number)
    return run(source)


def make_mesh(number):
    source = vtkSphereSource()
    source.SetThetaResolution(5 + number)
    return run(source)


def make_cull_plane():
    plane = vtkPlane()
    plane.SetNormal(NAN, 0, 0)
    return plane


def make_cull_sphere():
    sphere = vtkSphere()
    sphere.SetRadius(NAN)
    return sphere


# A filter, what makes its blocks, and parameters that it has to refuse.
FILTERS = [
    (vtkBCCPrefilter, make_volume, [
        dict(Method=-1), dict(Method=4), dict(Kernel=5), dict(Kernel=7, Method=2)]),
    (vtkBCCVolumeToImage, make_volume, [
        dict(Prefilter=9), dict(Kernel=0), dict(OutputDimensions=(-1, 5, 5)),
        dict(OutputDimensions=(2 ** 30, 2 ** 30, 2 ** 30)), dict(OutputDimensions=(0, 2 ** 30, 0)),
        dict(OutputDimensions=(10 ** 5, 10 ** 5, 10 ** 5)),
        dict(OutputScalarType=VTK_STRING), dict(OutputScalarType=VTK_BIT)]),
    (vtkImageToBCCVolume, make_cube, [
        dict(SampleRatio=0.0), dict(SampleRatio=-1.0), dict(SampleRatio=NAN),
        dict(SampleRatio=math.inf), dict(Dimensions=(1, 1, 1)), dict(Dimensions=(0, 4, 4)),
        dict(Dimensions=(2 ** 30, 2 ** 30, 2 ** 30)), dict(Dimensions=(10 ** 5, 10 ** 5, 10 ** 5)),
        dict(Interpolator=None),
        dict(Interpolator=vtkBCCInterpolator())]),
    (vtkOrderedDither, make_cube, [
        dict(NumberOfLevels=1), dict(Dimensionality=4), dict(PatternLog2Size=-1),
        dict(InputRange=(1.0, NAN)), dict(InputRange=(2.0, 1.0))]),
    (vtkRank1ImageResample, make_picture, [
        dict(NumberOfPoints=-1), dict(NumberOfPoints=2 ** 40), dict(Tiles=(0, 1)),
        dict(Tiles=(2 ** 20, 2 ** 20)), dict(NumberOfPoints=2 ** 29, Tiles=(2 ** 14, 2 ** 14)),
        dict(NumberOfPoints=12, Generator=(4, 6))]),
    (vtkRank1ImageReconstruct, make_rank1, [
        dict(SamplesPerAxis=0), dict(SamplesPerAxis=257), dict(OutputDimensions=(-1, 4)),
        dict(OutputDimensions=(2 ** 30, 2 ** 30)), dict(OutputDimensions=(2 ** 29, 2 ** 29)),
        dict(OutputDimensions=(0, 2 ** 31 - 1))]),
    (vtkRank1TexturePyramid, make_picture, [
        dict(NumberOfPoints=-1), dict(Tiles=(0, 1)), dict(NumberOfLevels=-1),
        dict(NumberOfPoints=12, Generator=(4, 6)),
        dict(NumberOfPoints=2 ** 29, Tiles=(2 ** 14, 2 ** 14))]),
    (vtkPolyDataToGeometryImage, make_mesh, [
        dict(Dimensions=(1, 5)), dict(Dimensions=(-3, 5)), dict(Dimensions=(2 ** 30, 2 ** 30))]),
    (vtkGeometryImageToPolyData, make_geometry, [dict(LevelOfDetail=-1), dict(LevelOfDetail=31)]),
    (vtkGeometryImageLocalityMask, make_geometry, [
        dict(MaximumDepth=-1), dict(MaximumDepth=11), dict(RootCube=(0.0, 0.0, 0.0, -1.0)),
        dict(RootCube=(0.0, NAN, 0.0, 1.0)), dict(CullFunction=make_cull_sphere()),
        dict(CullFunction=make_cull_plane()), dict(Camera=vtkCamera(), AspectRatio=0.0)]),
    (vtkRank1ImageToPolyData, make_rank1, [])]


def make_blocks(make, count=3):
    blocks = vtkMultiBlockDataSet()
    for number in range(count):
        blocks.SetBlock(number, make(number))
    return blocks


def make_filter(kind, blocks):
    algorithm = kind()
    algorithm.SetInputDataObject(blocks)
    if kind == vtkPolyDataToGeometryImage:
        algorithm.SetDimensions(9, 9)
    return algorithm


def count_points(data):
    """Of a data set, or of all that are in a tree."""
    if isinstance(data, vtkMultiBlockDataSet):
        return sum(count_points(data.GetBlock(n)) for n in range(data.GetNumberOfBlocks()))
    return data.GetNumberOfPoints() if data else 0


class TestMultiBlockInput(unittest.TestCase):
    def test_a_bad_parameter_is_told_once(self):
        for kind, make, settings in FILTERS:
            blocks = make_blocks(make)
            for setting in settings:
                with self.subTest(kind=kind.__name__, setting=str(setting)):
                    algorithm = make_filter(kind, blocks)
                    self.assertGreater(count_points(run(algorithm)), 0)
                    for name, value in setting.items():
                        getattr(algorithm, "Set" + name)(value)
                    with Errors(algorithm) as errors:
                        algorithm.Update()
                    self.assertEqual(len(errors.texts), 1, errors.texts)
                    self.assertEqual(count_points(algorithm.GetOutputDataObject(0)), 0)

    def test_a_block_that_is_no_image_is_told_once(self):
        for kind, make, _ in FILTERS:
            if kind == vtkRank1TexturePyramid:
                continue  # has a test of its own
            for other in vtkPolyData(), vtkTable():
                with self.subTest(kind=kind.__name__, other=other.GetClassName()):
                    blocks = make_blocks(make)
                    expected = [count_points(run(make_filter(kind, make(n)))) for n in range(3)]
                    blocks.SetBlock(1, other)
                    algorithm = make_filter(kind, blocks)
                    with Errors(algorithm) as errors:
                        algorithm.Update()
                    self.assertEqual(len(errors.texts), 1, errors.texts)
                    output = algorithm.GetOutputDataObject(0)
                    expected[1] = 0
                    self.assertEqual([count_points(output.GetBlock(n)) for n in range(3)], expected)

    def test_a_bad_block_is_told_once(self):
        for kind, make, _ in FILTERS:
            if kind in (vtkPolyDataToGeometryImage, vtkRank1TexturePyramid):
                continue  # takes no images, has a test of its own
            with self.subTest(kind=kind.__name__):
                blocks = make_blocks(make)
                blocks.GetBlock(1).GetPointData().Initialize()
                blocks.GetBlock(1).SetSpacing(math.inf, 1, 1)
                algorithm = make_filter(kind, blocks)
                with Errors(algorithm) as errors:
                    algorithm.Update()
                self.assertEqual(len(errors.texts), 1, errors.texts)
                output = algorithm.GetOutputDataObject(0)
                for number in range(3):
                    alone = run(make_filter(kind, make(number))) if number != 1 else None
                    self.assertEqual(count_points(output.GetBlock(number)), count_points(alone))

    def test_blocks_of_another_filter(self):
        for kind, make, _ in FILTERS:
            if kind in (vtkPolyDataToGeometryImage, vtkRank1TexturePyramid):
                continue  # takes no images, has a test of its own
            with self.subTest(kind=kind.__name__):
                producer = vtkTrivialProducer()
                producer.SetOutput(make_blocks(make))
                change = vtkImageChangeInformation()  # takes the blocks one by one itself
                change.SetInputConnection(producer.GetOutputPort())
                algorithm = kind()
                algorithm.SetInputConnection(change.GetOutputPort())
                output = run(algorithm)
                for number in range(3):
                    change = vtkImageChangeInformation()
                    change.SetInputData(make(number))
                    alone = run(make_filter(kind, run(change)))
                    self.assertGreater(count_points(alone), 0)
                    self.assertEqual(count_points(output.GetBlock(number)), count_points(alone))


if __name__ == "__main__":
    unittest.main()
