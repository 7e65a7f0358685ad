# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
"""Masks of labels and binary ones, on Cartesian grids of their own and on the lattice."""
import unittest

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPiecewiseFunction, vtkPlane
from vtkmodules.vtkRenderingCore import vtkColorTransferFunction

import comparison
import scenes
from bravais import vtkBCCLattice, vtkBCCVolumeMapper


def cylinder(x, y, z):
    return 255 * (x * x + y * y < 0.5)


def thirds(x, y, z):
    return 1 * (x + 0.3 * y > 0) + (z > 0.4)


def make_points(function):
    return scenes.make_cartesian(function, comparison.CARTESIAN.GetDimensions(), dtype=numpy.uint8)


def make_cells(function, count):
    """An image of a function at the centres of its cells."""
    points = scenes.make_cartesian(
        function, (count,) * 3, box=[side * (1 - 1 / count) for side in scenes.BOX],
        dtype=numpy.uint8)
    image = vtkImageData()
    image.SetDimensions(count + 1, count + 1, count + 1)
    image.SetOrigin(-1, -1, -1)
    image.SetSpacing(2 / count, 2 / count, 2 / count)
    image.GetCellData().SetScalars(points.GetPointData().GetScalars())
    return image


def set_labels(volume_property):
    for label, color in ((1, (1, 0, 0)), (2, (0, 0, 1))):
        colors = vtkColorTransferFunction()
        colors.AddRGBPoint(-1, *color)
        colors.AddRGBPoint(1, 1, 1, 0)
        volume_property.SetLabelColor(label, colors)
        opacity = vtkPiecewiseFunction()
        opacity.AddPoint(-1, 0)
        opacity.AddPoint(1, 0.5 * label)
        volume_property.SetLabelScalarOpacity(label, opacity)


class TestBCCVolumeMapperMasks(unittest.TestCase):
    def make_preparation(self, function, make_mask, factor=1.0, gradient=False):
        """VTK's mask has as many points as its volume, as it has to have."""
        def prepare(scene, mapper, volume_property):
            if isinstance(mapper, vtkBCCVolumeMapper):
                mapper.SetMaskInput(make_mask(function))
            else:
                mapper.SetMaskInput(make_points(function))
            if function is thirds:
                mapper.SetMaskTypeToLabelMap()
                set_labels(volume_property)
                mapper.SetMaskBlendFactor(factor)
            else:
                mapper.SetMaskTypeToBinary()
            if gradient:
                opacity = vtkPiecewiseFunction()
                opacity.AddPoint(0, 0)
                opacity.AddPoint(2.5 * comparison.get_edge(mapper), 1)
                volume_property.SetLabelGradientOpacity(1, opacity)
        return prepare

    def test_cartesian_masks(self):
        makers = {
            "points": make_points,
            "cells": lambda f: make_cells(f, 75),
            "a box of its own": lambda f: scenes.make_cartesian(
                f, (95, 85, 75), (-1.5, 1.2, -1, 1.4, -1.1, 1), dtype=numpy.uint8)}
        for name, make_mask in makers.items():
            for function in cylinder, thirds:
                with self.subTest(name, function=function):
                    comparison.compare(
                        self, "Composite", 1.2, self.make_preparation(function, make_mask),
                        shade=False)

    def test_blend_factor_and_gradients_of_labels(self):
        for factor in 0.0, 0.6:
            prepare = self.make_preparation(thirds, make_points, factor)
            comparison.compare(self, "Composite", 1.2, prepare, change=factor > 0)
        comparison.compare(
            self, "Composite", 1.5, self.make_preparation(thirds, make_points, gradient=True))

    def test_binary_masks_in_other_modes(self):
        prepare = self.make_preparation(cylinder, make_points)
        for mode in "MaximumIntensity", "MinimumIntensity", "AverageIntensity", "Additive":
            with self.subTest(mode):
                comparison.compare(self, mode, 1.2, prepare, shade=False,
                                   opacities=((-1, 0.1), (1, 0.04)))

    def test_labels_of_samples(self):
        """A slice shows the Voronoi cells of the lattice points that a mask leaves."""
        dimensions = (5, 4, 9)
        image = scenes.make_bcc(lambda x, y, z: 1 + 0 * x, dimensions)
        labels = numpy.random.default_rng(5).integers(0, 2, image.GetNumberOfPoints())
        points = numpy.array([self.get_point(image, n) for n in range(len(labels))])
        y, x = ((n + 0.5) / 30 - 1 for n in numpy.indices((60, 60)))
        world = numpy.stack((x, y, 0.07 - 0.1 * x - 0.2 * y), axis=-1)
        distances = numpy.linalg.norm(world[:, :, None] - points, axis=3)
        nearest, second = numpy.partition(distances, 1, axis=2)[:, :, :2].transpose(2, 0, 1)
        clear = second - nearest > 0.01  # not between two cells
        self.assertGreater(clear.mean(), 0.9)
        expected = labels[distances.argmin(axis=2)] > 0
        for tagged in True, False:
            mask = vtkImageData()
            if tagged:
                mask.CopyStructure(image)
                vtkBCCLattice.Tag(mask)
            else:
                mask.SetDimensions(dimensions)  # with a geometry of its own
            mask.GetPointData().SetScalars(numpy_to_vtk(labels.astype(numpy.uint8), deep=True))
            shown = self.show_slice(image, mask)
            numpy.testing.assert_array_equal(shown[clear], expected[clear])

    def show_slice(self, image, mask):
        """Which pixels of a slice of a slanted plane the mask leaves, seen along z."""
        mapper = vtkBCCVolumeMapper()
        mapper.SetInputData(image)
        mapper.SetBlendModeToSlice()
        mapper.SetMaskInput(mask)
        mapper.SetMaskTypeToBinary()
        plane = vtkPlane()
        plane.SetOrigin(0, 0, 0.07)
        plane.SetNormal(0.1, 0.2, 1)
        volume_property = scenes.make_property(0, 2, ((0, 1), (2, 1)), shade=False)
        volume_property.SetSliceFunction(plane)
        scene = scenes.Scene(mapper, volume_property, size=60, sample_distance=0.02)
        camera = scene.renderer.GetActiveCamera()
        camera.ParallelProjectionOn()
        camera.SetPosition(0, 0, 5)
        camera.SetParallelScale(1)
        scene.renderer.ResetCameraClippingRange()
        picture = scene.render()
        return (picture != (26, 26, 51)).any(axis=2)

    def get_point(self, image, number):
        nx, ny, _ = image.GetDimensions()
        x = [0.0, 0.0, 0.0]
        vtkBCCLattice.GetPoint(
            image, (number % nx, number // nx % ny, number // (nx * ny)), x)
        return x


if __name__ == "__main__":
    unittest.main()
