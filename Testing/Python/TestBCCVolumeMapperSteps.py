# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
"""Colours do not depend on the step, nor on which of all 27 regions are cut out, nor on borders."""
import unittest

import numpy
from vtkmodules.vtkRenderingCore import vtkRenderer

import comparison
import scenes
from bravais import vtkBCCVolumeMapper

HAZE = ((-1, 0), (0, 0.02), (0.4, 0.1), (1, 0.3))


class TestBCCVolumeMapperSteps(unittest.TestCase):
    def test_colors_do_not_depend_on_the_step(self):
        layer = comparison.BCC.GetSpacing()[2]
        for mode, opacities in (("Composite", HAZE), ("Additive", ((-1, 0), (1, 0.02))),
                                ("AverageIntensity", HAZE)):
            pictures = [comparison.make_scenes(
                mode, sample_distance=step, opacities=opacities, shade=False)[1].render()
                for step in (0.1 * layer, 0.5 * layer, layer)]
            self.assertGreater(pictures[0].std(axis=(0, 1)).max(), 5, mode)
            # Rays end within a step of the box: VTK adds whole steps only.
            for picture, bound in zip(pictures[1:], (1.0, 2.0)):
                self.assertLess(numpy.abs(picture - pictures[0]).mean(), bound, mode)

    def test_opacity_of_a_constant_is_that_of_its_length(self):
        """Through a cube of edge 2, of opacity 0.3 a unit distance of 0.5: 1 - 0.7^4."""
        image = scenes.make_bcc(lambda x, y, z: 1 + 0 * x, (8, 8, 16))
        for step in 0.01, 0.05, 0.13:
            mapper = vtkBCCVolumeMapper()
            mapper.SetInputData(image)
            volume_property = scenes.make_property(0, 2, ((0, 0.3), (2, 0.3)), shade=False)
            volume_property.SetScalarOpacityUnitDistance(0.5)
            colors = volume_property.GetRGBTransferFunction()
            colors.RemoveAllPoints()
            colors.AddRGBPoint(1, 1, 1, 1)
            scene = scenes.Scene(mapper, volume_property, size=40, sample_distance=step)
            scene.renderer.SetBackground(0, 0, 0)
            camera = scene.renderer.GetActiveCamera()
            camera.SetPosition(0, 0, 6)
            camera.ParallelProjectionOn()
            camera.SetParallelScale(2)
            scene.renderer.ResetCameraClippingRange()
            picture = scene.render()
            # As many steps as fit, give or take one.
            edge = 0.7 ** (numpy.array((2 - step, 2 + step)) / 0.5)
            low, high = 255 * (1 - edge)
            middle = picture[12:28, 12:28]
            self.assertGreaterEqual(middle.min(), low - 1.5)
            self.assertLessEqual(middle.max(), high + 1.5)

    def test_all_regions_of_cropping(self):
        """Five sets of regions, in each of which a region is if that bit of its number is set."""
        for bit in range(5):
            flags = sum(1 << region for region in range(27) if region + 1 >> bit & 1)

            def prepare(scene, mapper, volume_property):
                mapper.CroppingOn()
                mapper.SetCroppingRegionPlanes(-0.4, 0.3, -0.5, 0.6, -0.2, 0.7)
                mapper.SetCroppingRegionFlags(flags)
            with self.subTest(bit=bit):
                comparison.compare(self, "Composite", 1.0, prepare, shade=False)

    def test_pieces_side_by_side_have_no_seam(self):
        whole = scenes.make_bcc(lambda x, y, z: 1 + z, (10, 10, 21))
        pictures = []
        for parts in ((whole,), self.cut(whole)):
            renderer = vtkRenderer()
            window = scenes.make_window(64, 64)
            window.AddRenderer(renderer)
            for part in parts:
                mapper = vtkBCCVolumeMapper()
                mapper.SetKernelToBCC4()  # whose spline is the same in both
                mapper.SetInputData(part)
                mapper.SetBlendModeToMaximumIntensity()
                scene = scenes.Scene(mapper, scenes.make_property(
                    0, 2, ((0, 1), (2, 1)), shade=False), sample_distance=0.03)
                renderer.AddVolume(scene.volume)
            camera = renderer.GetActiveCamera()
            camera.SetPosition(6, 0, 0)
            camera.SetFocalPoint(0, 0, 0)
            camera.SetViewUp(0, 1, 0)
            camera.ParallelProjectionOn()
            camera.SetParallelScale(1.5)
            renderer.ResetCameraClippingRange()
            window.Render()
            pictures.append(scenes.get_picture(window))
        self.assertGreater(pictures[0].std(axis=(0, 1)).max(), 10)
        # Neighbouring pixels differ by up to 12 along z; where there is nothing, by hundreds.
        difference = numpy.abs(pictures[1] - pictures[0])
        self.assertLessEqual(difference.max(), 16)
        self.assertLess(difference.mean(), 0.5)

    def cut(self, whole):
        parts = []
        for extent in ((0, 9, 0, 9, 0, 10), (0, 9, 0, 9, 10, 20)):
            part = whole.NewInstance()
            part.DeepCopy(whole)
            part.Crop(extent)
            parts.append(part)
        return parts


if __name__ == "__main__":
    unittest.main()
