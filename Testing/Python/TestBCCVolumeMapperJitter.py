# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
"""Where along its ray the first sample of a pixel lies."""
import unittest

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkIdTypeArray
from vtkmodules.vtkCommonDataModel import vtkPiecewiseFunction, vtkPlane
from vtkmodules.vtkRenderingCore import vtkColorTransferFunction
from vtkmodules.vtkRenderingVolumeOpenGL2 import vtkOpenGLGPUVolumeRayCastMapper

import checks
import scenes
from bravais import vtkBayerPattern, vtkBCCVolumeMapper


def depth(x, y, z):
    """The distance from the front of the box, in boxes."""
    return (1 - z) / 2


def make_flat_scene(mapper, volume_property, size=40):
    """Rays along z through the whole window, a quarter of the box from sample to sample."""
    scene = scenes.Scene(mapper, volume_property, size, sample_distance=0.5)
    camera = scene.renderer.GetActiveCamera()
    camera.ParallelProjectionOn()
    camera.SetPosition(0, 0, 5)
    camera.SetFocalPoint(0, 0, 0)
    camera.SetParallelScale(0.8)
    return scene


def make_first_sample_property():
    """Opaque everywhere, so that a pixel has the scalar of its first sample as its colour."""
    colors = vtkColorTransferFunction()
    colors.AddRGBPoint(0, 0, 0, 0)
    colors.AddRGBPoint(0.25, 1, 1, 1)
    opacity = vtkPiecewiseFunction()
    opacity.AddPoint(0, 1)
    opacity.AddPoint(1, 1)
    volume_property = scenes.make_property(0, 1, ((0, 1), (1, 1)), shade=False)
    volume_property.SetColor(colors)
    volume_property.SetScalarOpacity(opacity)
    return volume_property


def get_first_samples(scene):
    """Of each pixel, in sample distances from where its ray enters."""
    return scene.render()[:, :, 0] / 255


def get_thresholds(shape):
    ranks = vtkIdTypeArray()
    vtkBayerPattern().GetThresholds(2, 3, ranks)
    square = (vtk_to_numpy(ranks).reshape(8, 8) + 0.5) / 64
    return numpy.tile(square, (shape[0] // 8 + 1, shape[1] // 8 + 1))[:shape[0], :shape[1]]


def make_bcc_mapper():
    mapper = vtkBCCVolumeMapper()
    # Many layers: the mirror at the box's front makes the spline flat there.
    mapper.SetInputData(scenes.make_bcc(depth, (4, 4, 400)))
    return mapper


class TestBCCVolumeMapperJitter(unittest.TestCase):
    def test_without_a_pattern_all_rays_start_alike(self):
        scene = make_flat_scene(make_bcc_mapper(), make_first_sample_property())
        numpy.testing.assert_allclose(get_first_samples(scene), 1, atol=0.01)

    def test_bayer_is_the_threshold_of_the_viewports_pixel(self):
        mapper = make_bcc_mapper()
        mapper.SetJitterPatternToBayer()
        scene = make_flat_scene(mapper, make_first_sample_property(), 43)
        samples = get_first_samples(scene)
        numpy.testing.assert_allclose(samples, get_thresholds(samples.shape), atol=0.006)
        numpy.testing.assert_array_equal(samples, get_first_samples(scene))

        # A viewport that starts elsewhere starts the pattern there.
        scene.renderer.SetViewport(0.5, 0.4, 1, 1)
        samples = get_first_samples(scene)
        left, bottom = scene.renderer.GetOrigin()
        self.assertNotEqual((left % 8, bottom % 8), (0, 0))
        part = samples[bottom:, left:]
        numpy.testing.assert_allclose(part, get_thresholds(part.shape), atol=0.006)

    def test_vtks_noise_is_that_of_its_own_mapper(self):
        pictures = []
        for mapper in (make_bcc_mapper(), vtkOpenGLGPUVolumeRayCastMapper()):
            if not mapper.GetInput():
                mapper.SetInputData(scenes.make_cartesian(depth, (24, 24, 48)))
            mapper.UseJitteringOn()
            scene = make_flat_scene(mapper, make_first_sample_property())
            pictures.append(get_first_samples(scene))
        numpy.testing.assert_allclose(pictures[0], pictures[1], atol=0.03)
        self.assertGreater(pictures[0].std(), 0.2)

    def test_bayer_in_vtks_own_mapper(self):
        mapper = vtkOpenGLGPUVolumeRayCastMapper()
        mapper.SetInputData(scenes.make_cartesian(depth, (24, 24, 48)))
        scene = make_flat_scene(mapper, make_first_sample_property())
        plain = get_first_samples(scene)
        shader = scene.volume.GetShaderProperty()
        vtkBCCVolumeMapper.AddBayerJitter(shader)
        samples = get_first_samples(scene)
        numpy.testing.assert_allclose(samples, get_thresholds(samples.shape), atol=0.03)
        vtkBCCVolumeMapper.RemoveBayerJitter(shader)
        numpy.testing.assert_array_equal(get_first_samples(scene), plain)

    def test_pattern_and_use_jittering_are_one(self):
        mapper = vtkBCCVolumeMapper()
        state = lambda: (mapper.GetJitterPatternAsString(), mapper.GetUseJittering())
        self.assertEqual(state(), ("None", 0))
        mapper.UseJitteringOn()
        self.assertEqual(state(), ("VTK", 1))
        mapper.SetJitterPatternToBayer()
        self.assertEqual(state(), ("Bayer", 0))
        mapper.UseJitteringOff()  # It is.
        self.assertEqual(state(), ("Bayer", 0))
        mapper.SetUseJittering(1)
        self.assertEqual(state(), ("VTK", 1))
        mapper.UseJitteringOff()
        self.assertEqual(state(), ("None", 0))
        time = mapper.GetMTime()
        mapper.SetJitterPatternToNone()
        self.assertEqual(mapper.GetMTime(), time)
        mapper.SetJitterPatternToVTK()
        self.assertGreater(mapper.GetMTime(), time)

    def test_bayer_breaks_up_the_rings_of_far_samples(self):
        # The error of the means of 8 x 8 pixels, against a picture of many samples.
        def render(pattern, distance):
            mapper = vtkBCCVolumeMapper()
            mapper.SetInputData(scenes.make_bcc(
                lambda x, y, z: numpy.sqrt(x * x + y * y + z * z)))
            mapper.SetJitterPattern(pattern)
            mapper.SetBlendModeToAverageIntensity()
            picture = scenes.Scene(mapper, scenes.make_property(
                0, 1.8, ((0, 0), (0.9, 1), (1, 0), (1.8, 0)), shade=False),
                sample_distance=distance).render()[:, :, 0].astype(float)
            cells = picture[3:147, 3:147].reshape(18, 8, 18, 8)
            return cells.mean(axis=(1, 3))

        exact = render(0, 0.01)
        errors = [numpy.sqrt(((render(pattern, 0.25) - exact) ** 2).mean()) for pattern in (0, 2)]
        self.assertLess(errors[1], 0.5 * errors[0])

    def test_jitter_leaves_slices_and_refined_surfaces_alone(self):
        for blend in ("Slice", "IsoSurface"):
            pictures = []
            for pattern in (0, 2):
                mapper = make_bcc_mapper()
                mapper.SetJitterPattern(pattern)
                getattr(mapper, f"SetBlendModeTo{blend}")()
                volume_property = scenes.make_property(0, 1, ((0, 1), (1, 1)), iso_values=(0.4,))
                plane = vtkPlane()
                plane.SetNormal(0.3, 0.2, 1)
                volume_property.SetSliceFunction(plane)
                pictures.append(scenes.Scene(mapper, volume_property).render())
            self.assertGreater(pictures[0].std(), 5)
            numpy.testing.assert_allclose(pictures[0], pictures[1], atol=1)

    def test_unknown_patterns_are_refused(self):
        mapper = make_bcc_mapper()
        scene = make_flat_scene(mapper, make_first_sample_property())
        for pattern in (-1, 3):
            mapper.SetJitterPattern(pattern)
            self.assertEqual(mapper.GetJitterPatternAsString(), "Unknown")
            with checks.Errors(mapper) as errors:
                self.assertEqual(scene.render().std(axis=(0, 1)).max(), 0)
            self.assertEqual(len(errors.texts), 1)
            self.assertIn(f"JitterPattern is {pattern}", errors.texts[0])
        mapper.SetJitterPatternToBayer()
        self.assertGreater(scene.render().max(), 200)


if __name__ == "__main__":
    unittest.main()
