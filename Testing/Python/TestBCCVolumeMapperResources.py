# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
"""Coefficients are computed when they must be, and pictures outlive windows."""
import unittest

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkRenderingCore import vtkRenderer

import scenes
from bravais import vtkBCCVolumeMapper


def distance(x, y, z):
    return numpy.sqrt(x * x + y * y + z * z)


def make_scene(blend="Composite", size=100):
    mapper = vtkBCCVolumeMapper()
    mapper.SetInputData(scenes.make_bcc(distance))
    getattr(mapper, "SetBlendModeTo" + blend)()
    return scenes.Scene(mapper, scenes.make_property(
        0, 1.7, ((0, 1), (0.6, 0.9), (0.8, 0.2), (1.7, 0)), iso_values=(0.5, 0.9)), size=size)


class TestBCCVolumeMapperResources(unittest.TestCase):
    def test_coefficients_are_kept_until_data_kernel_or_prefilter_change(self):
        scene = make_scene()
        mapper = scene.volume.GetMapper()
        self.assertEqual(mapper.GetCoefficientTime(), 0)
        first = scene.render()
        time = mapper.GetCoefficientTime()
        self.assertGreater(time, 0)

        # What has nothing to do with them.
        scene.renderer.GetActiveCamera().Azimuth(30)
        scene.render()
        scene.volume.GetProperty().ShadeOff()
        scene.window.SetSize(120, 90)
        mapper.SetSampleDistance(0.03)
        mapper.SetBlendModeToMaximumIntensity()
        mapper.AnalyticGradientsOff()
        scene.volume.SetPosition(0.1, 0, 0)
        scene.render()
        self.assertEqual(mapper.GetCoefficientTime(), time)

        image = mapper.GetInput()
        for change in (lambda: mapper.SetKernelToBCC8(), lambda: mapper.SetPrefilterToNone(),
                       lambda: image.Modified(),
                       lambda: mapper.SetInputData(scenes.make_bcc(distance))):
            change()
            scene.render()
            self.assertGreater(mapper.GetCoefficientTime(), time)
            time = mapper.GetCoefficientTime()
            scene.render()
            self.assertEqual(mapper.GetCoefficientTime(), time)
        self.assertEqual(first.shape, (100, 100, 3))

    def test_changed_values_are_shown(self):
        scene = make_scene()
        first = scene.render()
        image = scene.volume.GetMapper().GetInput()
        values = vtk_to_numpy(image.GetPointData().GetScalars())
        values[:] = 1.7 - values
        image.GetPointData().GetScalars().Modified()
        self.assertGreater(numpy.abs(scene.render() - first).mean(), 5)
        values[:] = 1.7 - values
        image.GetPointData().GetScalars().Modified()
        numpy.testing.assert_allclose(scene.render(), first, atol=1)

    def test_released_window_shows_the_same_again(self):
        for blend in ("Composite", "MaximumIntensity", "IsoSurface"):
            scene = make_scene(blend)
            first = scene.render()
            time = scene.volume.GetMapper().GetCoefficientTime()
            scene.volume.ReleaseGraphicsResources(scene.window)
            numpy.testing.assert_array_equal(scene.render(), first)
            scene.window.Finalize()
            numpy.testing.assert_array_equal(scene.render(), first)
            self.assertEqual(scene.volume.GetMapper().GetCoefficientTime(), time)

    def test_one_mapper_in_two_windows(self):
        scene = make_scene()
        first = scene.render()
        other = scenes.make_window(100, 100)
        renderer = vtkRenderer()
        renderer.SetBackground(scene.renderer.GetBackground())
        renderer.AddVolume(scene.volume)
        renderer.SetActiveCamera(scene.renderer.GetActiveCamera())
        other.AddRenderer(renderer)
        for _ in range(2):
            other.Render()
            numpy.testing.assert_array_equal(scenes.get_picture(other), first)
            numpy.testing.assert_array_equal(scene.render(), first)

    def test_volumes_of_two_mappers_in_one_scene(self):
        scene, other = make_scene("IsoSurface"), make_scene("IsoSurface")
        for volume in (scene.volume, other.volume):
            volume.SetProperty(scenes.make_property(0, 1, ((0, 1), (1, 1)), iso_values=(0.5, 0.9)))
        alone = scene.render()
        other.volume.SetScale(0.2)
        other.volume.GetMapper().SetKernelToBCC12()
        scene.renderer.AddVolume(other.volume)
        # The small one is hidden by the first one's outer surface.
        numpy.testing.assert_allclose(scene.render(), alone, atol=1)
        other.volume.SetPosition(0.65, 0.5, 1)
        self.assertGreater(numpy.abs(scene.render() - alone).mean(), 0.5)

    def test_the_volume_is_left_as_it_was(self):
        scene = make_scene("IsoSurface")
        scene.render()
        time = scene.volume.GetMTime()
        scene.render()
        self.assertEqual(scene.volume.GetMTime(), time)
        shader = scene.volume.GetShaderProperty()
        self.assertEqual(shader.GetNumberOfShaderReplacements(), 0)

    def test_user_shader_replacements_are_applied(self):
        scene = make_scene()
        scene.volume.GetShaderProperty().AddFragmentShaderReplacement(
            "//VTK::Base::Exit", True, "//VTK::Base::Exit\n g_fragColor = vec4(0, 1, 0, 1);", False)
        picture = scene.render()
        self.assertEqual(tuple(picture[50, 50]), (0, 255, 0))


if __name__ == "__main__":
    unittest.main()
