# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
"""Masks of labels and binary ones, on Cartesian grids of their own and on the lattice."""
import unittest

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPiecewiseFunction, vtkPlane
from vtkmodules.vtkRenderingCore import vtkColorTransferFunction

import checks
import comparison
import scenes
from bravais import vtkBCCLattice, vtkBCCVolumeMapper

TYPES = ("i1", "u1", "i2", "u2", "i4", "u4", "i8", "u8", "f4", "f8")


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


def make_mask(labels):
    """Labels, [z, y, x], over the box."""
    mask = vtkImageData()
    mask.SetDimensions(labels.shape[::-1])
    mask.SetOrigin(-1, -1, -1)
    mask.SetSpacing([2 / (n - 1) for n in labels.shape[::-1]])
    mask.GetPointData().SetScalars(numpy_to_vtk(labels.ravel(), deep=True))
    return mask


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

    def make_labelled_scene(self, labels, components=1):
        """A box with a mask of its own geometry, [z, y, x]; labels 1 to 3 are red, green and blue."""
        mapper = vtkBCCVolumeMapper()
        mapper.SetInputData(scenes.make_bcc(
            lambda x, y, z: numpy.ones(x.shape + (components,)), (6, 6, 12)))
        mapper.SetMaskInput(make_mask(labels))
        mapper.SetMaskTypeToLabelMap()
        volume_property = scenes.make_property(0, 2, ((0, 1), (2, 1)), shade=False)
        opaque = vtkPiecewiseFunction()
        opaque.AddPoint(0, 1)
        for label, color in ((1, (1, 0, 0)), (2, (0, 1, 0)), (3, (0, 0, 1))):
            colors = vtkColorTransferFunction()
            colors.AddRGBPoint(0, *color)
            volume_property.SetLabelColor(label, colors)
            volume_property.SetLabelScalarOpacity(label, opaque)
        return scenes.Scene(mapper, volume_property, size=20)

    def test_labels_are_what_they_say(self):
        """Whatever other labels the mask has, and of every type; VTK stretches them over all."""
        scene = self.make_labelled_scene(numpy.zeros((5, 4, 7), "u1"))
        plain = scene.render()
        for dtype in TYPES:
            for label, others in ((1, ()), (3, (0,)), (2, (1, 9))):
                labels = numpy.full((5, 4, 7), label, dtype)
                labels[0, 0, :len(others)] = others  # far from the camera
                scene.volume.GetMapper().SetMaskInput(make_mask(labels))
                with self.subTest(dtype=dtype, label=label, others=others):
                    numpy.testing.assert_array_equal(
                        scene.render()[10, 10], 255 * numpy.eye(3)[label - 1])
        # One that has no functions of its own is as none.
        scene.volume.GetMapper().SetMaskInput(make_mask(numpy.full((5, 4, 7), 4, "u1")))
        numpy.testing.assert_array_equal(scene.render(), plain)

    def test_binary_masks_of_every_type(self):
        scene = self.make_labelled_scene(numpy.ones((5, 4, 7), "u1"))
        mapper = scene.volume.GetMapper()
        mapper.SetMaskTypeToBinary()
        shown = scene.render()
        self.assertGreater((shown != shown[0, 0]).any(axis=2).sum(), 50)
        for dtype in TYPES:
            mapper.SetMaskInput(make_mask(numpy.full((5, 4, 7), 2, dtype)))
            numpy.testing.assert_array_equal(scene.render(), shown, dtype)
            labels = mapper.GetMaskInput().GetPointData().GetScalars()
            vtk_to_numpy(labels)[:] = 0
            labels.Modified()
            self.assertEqual(scene.render().std(axis=(0, 1)).max(), 0, dtype)

    def test_functions_of_labels_may_change(self):
        scene = self.make_labelled_scene(numpy.full((5, 4, 7), 2, "u1"))
        numpy.testing.assert_array_equal(scene.render()[10, 10], (0, 255, 0))
        colors = scene.volume.GetProperty().GetLabelColor(2)
        colors.RemoveAllPoints()
        colors.AddRGBPoint(0, 1, 0, 1)
        numpy.testing.assert_array_equal(scene.render()[10, 10], (255, 0, 255))

    def test_a_mask_of_a_part(self):
        """What is further from a mask than half a spacing is not masked."""
        scene = self.make_labelled_scene(numpy.full((5, 4, 7), 2, "u1"))
        mapper = scene.volume.GetMapper()
        mask = mapper.GetMaskInput()
        half = 1 / 5.5
        mapper.SetMaskTypeToBinary()
        for tagged in False, True:
            if tagged:
                vtkBCCLattice.Tag(mask)
            mask.SetOrigin(-1, -1, -1)
            whole = (scene.render() != (26, 26, 51)).any(axis=2)
            mask.SetOrigin(-1, -1, -3 + half)
            parts = (scene.render() != (26, 26, 51)).any(axis=2)
            self.assertGreater(parts.sum(), 0)
            self.assertLess(parts.sum(), 0.9 * whole.sum())
            mask.SetOrigin(-1, -1, -3.3 - half)  # Points have half a spacing around them.
            self.assertEqual((scene.render() != (26, 26, 51)).any(axis=2).sum(), 0)

    def test_labels_are_for_one_component(self):
        """Those of dependent ones are left out, as by VTK."""
        scene = self.make_labelled_scene(numpy.full((5, 4, 7), 2, "u1"), components=2)
        mapper = scene.volume.GetMapper()
        with checks.Errors(mapper) as errors:
            scene.window.Render()
            self.assertEqual(scene.render().std(axis=(0, 1)).max(), 0)
        self.assertEqual(len(errors.texts), 1)
        self.assertIn("2 independent components", errors.texts[0])
        scene.volume.GetProperty().IndependentComponentsOff()
        labelled = scene.render()
        self.assertGreater(labelled.std(axis=(0, 1)).max(), 5)
        mapper.SetMaskInput(None)
        numpy.testing.assert_array_equal(scene.render(), labelled)

    def test_labels_are_for_composite_blending(self):
        """They change nothing in other modes, as with VTK, nor what depths an image has."""
        for mode in ("IsoSurface", "MaximumIntensity", "Slice"):
            scene = comparison.make_scenes(mode)[1]
            mapper = scene.volume.GetMapper()
            plane = vtkPlane()
            plane.SetNormal(0.5, 0.3, 1)
            scene.volume.GetProperty().SetSliceFunction(plane)
            mapper.RenderToImageOn()
            images = []
            for mask in None, make_points(thirds):
                mapper.SetMaskInput(mask)
                mapper.SetMaskTypeToLabelMap()
                set_labels(scene.volume.GetProperty())
                scene.window.Render()
                color, depth = vtkImageData(), vtkImageData()
                mapper.GetColorImage(color)
                mapper.GetDepthImage(depth)
                images.append([scenes.to_array(color), scenes.to_array(depth)])
            self.assertGreater(images[0][0].std(axis=(0, 1)).max(), 5)
            for plain, masked in zip(*images):
                numpy.testing.assert_array_equal(masked, plain, mode)

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
        scene.look_along_z()
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
