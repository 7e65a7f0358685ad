# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
"""Progressive pictures: their passes, and the plain picture at the end."""
import unittest

import numpy
from vtkmodules.vtkCommonCore import vtkIdTypeArray

import checks
import scenes
from bravais import vtkBayerPattern
from progressive import add_sphere, completes, make_scene, refine


class TestBCCVolumeMapperProgressive(unittest.TestCase):
    def test_ends_with_the_plain_picture(self):
        for blend, pattern, sphere in (("Composite", "VTK", True), ("Slice", "None", False),
                                       ("MaximumIntensity", "Bayer", True),
                                       ("AverageIntensity", "None", False)):
            with self.subTest(blend):
                scene = make_scene(blend, pattern)
                if sphere:
                    add_sphere(scene)
                completes(self, scene)

    def test_surfaces_and_their_depths(self):
        scene = make_scene("IsoSurface", "Bayer")
        add_sphere(scene)
        scene.window.Render()
        depth = scene.get_depth().copy()
        completes(self, scene)
        numpy.testing.assert_array_equal(scene.get_depth(), depth)

    def test_pattern_sizes(self):
        scene = make_scene()
        self.assertEqual(scene.volume.GetMapper().GetProgressivePatternSize(), 4)
        for size in (2, 4, 8):
            completes(self, scene, size)

    def test_cameras(self):
        scene = make_scene()
        camera = scene.renderer.GetActiveCamera()
        camera.ParallelProjectionOn()
        scene.renderer.ResetCamera(scenes.BOX)
        completes(self, scene)
        camera.ParallelProjectionOff()
        camera.SetPosition(0.3, 0.2, 0.5)  # in the volume
        camera.SetClippingRange(0.05, 5)
        completes(self, scene)
        camera.SetPosition(300, 200, 500)
        camera.SetViewAngle(0.25)
        scene.renderer.ResetCameraClippingRange(scenes.BOX)
        completes(self, scene)

    def test_multisampling_translucency_and_transforms(self):
        scene = make_scene()
        scene.window.SetMultiSamples(4)
        add_sphere(scene)
        add_sphere(scene, -0.5, 0.4)
        scene.volume.SetScale(1, 0.7, -0.9)
        scene.volume.RotateZ(25)
        completes(self, scene)

    def test_the_passes_are_in_bayers_order(self):
        scene = make_scene(size=64)
        plain = scene.render()
        scene.volume.GetMapper().ProgressiveRefinementOn()
        order = vtkIdTypeArray()
        vtkBayerPattern().GetOrder(2, 2, order)
        for number in range(16):
            picture = scene.render()
            for rank in range(number + 1):
                x, y = order.GetValue(rank) % 4, order.GetValue(rank) // 4
                numpy.testing.assert_array_equal(picture[y::4, x::4], plain[y::4, x::4])
            if number == 0:
                # The rest of the volume shows the nearest: the next column the first of a block.
                inside = (plain != plain[0, 0]).any(axis=2)
                both = inside[:, 0::4] & inside[:, 1::4]
                self.assertGreater(both.mean(), 0.2)
                rows = numpy.arange(64) // 4 * 4
                below = both & both[rows] & (numpy.arange(64) % 4 < 2)[:, None]
                numpy.testing.assert_array_equal(picture[:, 1::4][below],
                                                 picture[rows][:, 0::4][below])

    def test_first_passes_show_a_coarse_picture(self):
        for blend in ("MaximumIntensity", "IsoSurface"):
            scene = make_scene(blend, size=120)
            add_sphere(scene)
            plain = scene.render().astype(float)
            scene.volume.GetMapper().ProgressiveRefinementOn()
            errors = [numpy.abs(scene.render() - plain).mean() for _ in range(16)]
            self.assertLess(errors[0], 0.35 * plain.std(axis=(0, 1)).max())
            self.assertLess(errors[3], 0.8 * errors[0])
            self.assertEqual(errors[15], 0)

    def test_two_volumes(self):
        # The one that writes depths comes first: the other's rays end at them.
        scene, other = make_scene("IsoSurface"), make_scene()
        other.volume.SetPosition(0.8, 0.6, 0.7)
        other.volume.SetScale(0.6)
        scene.renderer.AddVolume(other.volume)
        plain = scene.render()
        mappers = [scene.volume.GetMapper(), other.volume.GetMapper()]
        for mapper in mappers:
            mapper.ProgressiveRefinementOn()
        self.assertIsNotNone(refine(scene, mappers))
        numpy.testing.assert_array_equal(scene.render(), plain)

    def test_what_cannot_be_traced_in_passes_is_drawn_at_once(self):
        scene = make_scene()
        mapper = scene.volume.GetMapper()
        mapper.ProgressiveRefinementOn()
        mapper.SetImageSampleDistance(2)
        first = scene.render()
        self.assertTrue(mapper.GetProgressComplete())
        numpy.testing.assert_array_equal(scene.render(), first)
        mapper.SetImageSampleDistance(1)
        scene.window.Render()
        self.assertFalse(mapper.GetProgressComplete())

        mapper.RenderToImageOn()
        scene.window.Render()
        self.assertTrue(mapper.GetProgressComplete())
        mapper.RenderToImageOff()
        scene.window.Render()
        self.assertFalse(mapper.GetProgressComplete())
        self.assertEqual(refine(scene), 16 - 1)

        scene.renderer.SetUseDepthPeeling(True)
        scene.renderer.SetUseDepthPeelingForVolumes(True)
        add_sphere(scene, -0.5, 0.4)
        first = scene.render()
        self.assertTrue(mapper.GetProgressComplete())
        numpy.testing.assert_array_equal(scene.render(), first)
        mapper.ProgressiveRefinementOff()
        numpy.testing.assert_array_equal(scene.render(), first)

    def test_other_sizes_are_refused(self):
        scene = make_scene()
        mapper = scene.volume.GetMapper()
        mapper.ProgressiveRefinementOn()
        for size in (-4, 0, 1, 3, 16):
            mapper.SetProgressivePatternSize(size)
            with checks.Errors(mapper) as errors:
                scene.window.Render()
                self.assertEqual(scene.render().std(axis=(0, 1)).max(), 0)
            self.assertEqual(len(errors.texts), 1)
            self.assertIn(f"ProgressivePatternSize is {size}", errors.texts[0])
        mapper.SetProgressivePatternSize(2)
        self.assertEqual(refine(scene), 4)


if __name__ == "__main__":
    unittest.main()
