# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
"""Bad input gets one error that names it, however many frames, and an empty picture."""
import unittest

import numpy
from vtkmodules.vtkCommonCore import VTK_FLOAT, vtkFloatArray
from vtkmodules.vtkCommonDataModel import vtkImageData

import scenes
from bravais import vtkBCCLattice, vtkBCCVolumeMapper


def distance(x, y, z):
    return numpy.sqrt(x * x + y * y + z * z)


def make_tagged(dimensions):
    image = vtkImageData()
    image.SetDimensions(dimensions)
    image.AllocateScalars(VTK_FLOAT, 1)
    if image.GetNumberOfPoints():
        image.GetPointData().GetScalars().Fill(1)
    vtkBCCLattice.Tag(image)
    return image


class TestBCCVolumeMapperBadInput(unittest.TestCase):
    def render(self, image, size=64, iso=False, prepare=None):
        """The errors of three frames and the last picture."""
        mapper = vtkBCCVolumeMapper()
        errors = []

        def observe(caller, event, text):
            errors.append(text)
        observe.CallDataType = "string0"
        mapper.AddObserver("ErrorEvent", observe)
        if image:
            mapper.SetInputData(image)
        if iso:
            mapper.SetBlendModeToIsoSurface()
        if prepare:
            prepare(mapper)
        volume_property = scenes.make_property(0, 1.7, ((0, 1), (1.7, 0.2)), iso_values=(0.5,))
        scene = scenes.Scene(mapper, volume_property, size=size)
        for _ in range(3):
            picture = scene.render()
        return errors, picture

    def check_refused(self, image, words, **options):
        errors, picture = self.render(image, **options)
        self.assertEqual(len(errors), 1, errors)
        self.assertIn(words, errors[0])
        self.assertEqual(picture.std(axis=(0, 1)).max(), 0)

    def check_shown(self, image, **options):
        errors, picture = self.render(image, **options)
        self.assertEqual(errors, [])
        self.assertGreater(picture.std(axis=(0, 1)).max(), 5)

    def test_no_input(self):
        self.check_refused(None, "no input")

    def test_untagged_image(self):
        image = scenes.make_bcc(distance)
        image.GetFieldData().Initialize()
        self.check_refused(image, "not tagged")

    def test_dimensions(self):
        self.check_refused(make_tagged((0, 0, 0)), "dimensions")
        self.check_refused(make_tagged((8, 8, 1)), "8 x 8 x 1")
        self.check_shown(scenes.make_bcc(distance, (1, 1, 2)))

    def test_spacing(self):
        image = scenes.make_bcc(distance)
        image.SetSpacing(1, float("nan"), 1)
        self.check_refused(image, "spacing")

    def test_scalars(self):
        image = scenes.make_bcc(distance)
        image.GetPointData().Initialize()
        self.check_refused(image, "scalars")
        image = scenes.make_bcc(distance, (8, 8, 8))
        scalars = vtkFloatArray()
        scalars.SetNumberOfComponents(5)
        scalars.SetNumberOfTuples(512)
        scalars.Fill(1)
        image.GetPointData().SetScalars(scalars)
        self.check_refused(image, "5 components")

    def test_selected_arrays(self):
        image = scenes.make_bcc(distance, (8, 8, 8))

        def select(mode, array):
            def prepare(mapper):
                mapper.SetScalarMode(mode)
                mapper.SelectScalarArray(array)
            return prepare
        self.check_shown(image, prepare=select(3, 0))
        self.check_shown(image, prepare=select(3, "Scalars"))
        for mode in 3, 4, 5:  # point, cell and field data
            self.check_refused(image, "array Missing", prepare=select(mode, "Missing"))
            self.check_refused(image, "number 4", prepare=select(mode, 4))
        self.check_refused(image, "no point scalars", prepare=select(4, "Scalars"))

    def test_texture_larger_than_opengl_takes(self):
        self.check_refused(make_tagged((1, 1, 100000)), "texture")

    def test_kernel_without_prefilter(self):
        image = scenes.make_bcc(distance)
        self.check_refused(image, "Interpolation is not defined",
                           prepare=lambda mapper: mapper.SetPrefilterToInterpolation())

        def prepare(mapper):
            mapper.SetPrefilterToInterpolation()
            mapper.SetKernelToBCC8()
        self.check_shown(image, prepare=prepare)

    def test_nan(self):
        def hole(x, y, z):
            return numpy.where(x > 0.3, numpy.nan, distance(x, y, z))
        self.check_shown(scenes.make_bcc(hole))
        self.check_shown(scenes.make_bcc(hole), iso=True)
        self.check_refused(scenes.make_bcc(lambda x, y, z: x * numpy.nan), "no finite value")

    def test_values_beyond_floats(self):
        def make(factor):
            return scenes.make_bcc(lambda x, y, z: factor * distance(x, y, z), dtype=float)
        for factor in (1e37, -1e300):
            self.check_refused(make(factor), "can be rendered")
        pictures = []
        for factor in (1, 5e35):  # whose sums are finite
            mapper = vtkBCCVolumeMapper()
            mapper.SetInputData(make(factor))
            opacities = ((0, 1), (1.7 * factor, 0.2))
            scene = scenes.Scene(mapper, scenes.make_property(0, 1.7 * factor, opacities), size=64)
            pictures.append(scene.render().astype(int))
        self.assertGreater(pictures[0].std(axis=(0, 1)).max(), 5)
        self.assertLessEqual(abs(pictures[0] - pictures[1]).max(), 1)

    def test_window_of_one_pixel(self):
        for iso in (False, True):
            self.assertEqual(self.render(scenes.make_bcc(distance), size=1, iso=iso)[0], [])

    def test_unknown_kernel_and_prefilter(self):
        image = scenes.make_bcc(distance)
        self.check_refused(image, "Kernel is 5", prepare=lambda mapper: mapper.SetKernel(5))
        self.check_refused(image, "Prefilter is 4", prepare=lambda mapper: mapper.SetPrefilter(4))

    def test_what_knows_cartesian_grids_only(self):
        image = scenes.make_bcc(distance)
        self.check_refused(image, "UseDepthPass", prepare=lambda mapper: mapper.UseDepthPassOn())
        errors, _ = self.render(image, prepare=lambda mapper: mapper.SetPartitions(2, 1, 1))
        self.assertEqual(len(errors), 1)
        self.assertIn("Partitions", errors[0])

    def test_the_error_returns_when_something_changes(self):
        image = scenes.make_bcc(distance)
        image.GetFieldData().Initialize()
        mapper = vtkBCCVolumeMapper()
        errors = []
        mapper.AddObserver("ErrorEvent", lambda caller, event: errors.append(1))
        mapper.SetInputData(image)
        scene = scenes.Scene(mapper, scenes.make_property(0, 1.7, ((0, 1), (1.7, 1))), size=64)
        scene.render()
        image.Modified()
        scene.render()
        self.assertEqual(len(errors), 2)
        vtkBCCLattice.Tag(image)
        image.Modified()
        self.assertGreater(scene.render().std(axis=(0, 1)).max(), 5)
        self.assertEqual(len(errors), 2)


if __name__ == "__main__":
    unittest.main()
