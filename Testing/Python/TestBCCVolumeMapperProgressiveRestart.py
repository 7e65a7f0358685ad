# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
"""What starts a progressive picture anew, and what does not."""
import unittest

import numpy
from vtkmodules.vtkCommonDataModel import vtkPlane
from vtkmodules.vtkRenderingCore import vtkHardwareSelector, vtkLight, vtkRenderer, vtkVolume

import scenes
from progressive import SIZE, add_sphere, completes, make_scene, refine, wave


class TestBCCVolumeMapperProgressiveRestart(unittest.TestCase):
    def start_anew(self, scene, changes):
        mapper = scene.volume.GetMapper()
        mapper.ProgressiveRefinementOn()
        mapper.SetProgressivePatternSize(2)
        self.assertEqual(refine(scene), 4)
        for name, change in changes.items():
            with self.subTest(name):
                scene.window.Render()
                self.assertTrue(mapper.GetProgressComplete())
                change()
                scene.window.Render()  # the first of the new passes
                self.assertFalse(mapper.GetProgressComplete())
                self.assertEqual(refine(scene), mapper.GetProgressivePatternSize() ** 2 - 1)

    def test_every_change_starts_anew(self):
        scene = make_scene()
        scene.window.SetSize(20, 20)
        mapper, camera = scene.volume.GetMapper(), scene.renderer.GetActiveCamera()
        actor = add_sphere(scene)
        plane = vtkPlane()
        plane.SetOrigin(0, 0, -0.9)
        self.start_anew(scene, {
            "camera": lambda: camera.Azimuth(3),
            "zoom": lambda: camera.Zoom(1.01),
            "window": lambda: scene.window.SetSize(21, 20),
            "viewport": lambda: scene.renderer.SetViewport(0.1, 0, 1, 1),
            "data": lambda: mapper.GetInput().Modified(),
            "other data": lambda: mapper.SetInputData(scenes.make_bcc(wave, (12, 12, 24))),
            "prefilter": mapper.SetPrefilterToNone,
            "sample distance": lambda: mapper.SetSampleDistance(0.05),
            "clipping plane": lambda: mapper.AddClippingPlane(plane),
            "clipping plane moves": lambda: plane.SetOrigin(0, 0, -0.8),
            "jitter": mapper.SetJitterPatternToBayer,
            "pattern": lambda: mapper.SetProgressivePatternSize(4),
            "smaller pattern": lambda: mapper.SetProgressivePatternSize(2),
            "volume moves": lambda: scene.volume.SetPosition(0.1, 0, 0),
            "actor moves": lambda: actor.AddPosition(0.1, 0, 0),
            "actor gone": lambda: scene.renderer.RemoveActor(actor),
            "actor back": lambda: scene.renderer.AddActor(actor),
            "shader": lambda: scene.volume.GetShaderProperty().AddFragmentShaderReplacement(
                "//VTK::Base::Exit", True, "//VTK::Base::Exit\n g_fragColor.r *= 0.5;", False),
            "shader cleared": scene.volume.GetShaderProperty().ClearAllFragmentShaderReplacements,
        })

    def test_appearance_and_lights_start_anew(self):
        scene = make_scene("IsoSurface")
        scene.window.SetSize(20, 20)
        volume_property, light = scene.volume.GetProperty(), vtkLight()
        light.SetPosition(0, 3, 0)
        scene.renderer.AddLight(light)
        self.start_anew(scene, {
            "isovalue": lambda: volume_property.GetIsoSurfaceValues().SetValue(0, 0.1),
            "opacity": lambda: volume_property.GetScalarOpacity().AddPoint(0, 0.6),
            "color": lambda: volume_property.GetRGBTransferFunction().AddRGBPoint(0, 0, 1, 0),
            "shininess": lambda: volume_property.SetSpecularPower(5),
            "light moves": lambda: light.SetPosition(0, 5, 0),
            "light colour": lambda: light.SetDiffuseColor(1, 0, 0),
            "light off": light.SwitchOff,
        })
        slices = make_scene("Slice")
        plane = slices.volume.GetProperty().GetSliceFunction()
        self.start_anew(slices, {"slice plane": lambda: plane.SetNormal(0, 1, 1)})

    def test_what_matters_of_actors_are_their_depths(self):
        scene = make_scene()
        mapper = scene.volume.GetMapper()
        actor = add_sphere(scene)
        mapper.ProgressiveRefinementOn()
        self.assertEqual(refine(scene), 16)
        for change in (lambda: actor.GetProperty().SetColor(1, 0, 0),
                       lambda: add_sphere(scene).SetPosition(-0.3, 0, -9),  # behind
                       lambda: add_sphere(scene, -0.5, 0.3)):  # translucent
            change()
            scene.window.Render()
            self.assertTrue(mapper.GetProgressComplete())
        picture = scene.render()
        mapper.ProgressiveRefinementOff()
        numpy.testing.assert_array_equal(scene.render(), picture)

    def test_a_change_between_passes(self):
        scene = make_scene()
        mapper = scene.volume.GetMapper()
        mapper.ProgressiveRefinementOn()
        for _ in range(7):
            scene.window.Render()
        scene.window.SetSize(90, 47)
        scene.window.Render()
        self.assertFalse(mapper.GetProgressComplete())
        self.assertEqual(refine(scene), 15)
        picture = scene.render()
        self.assertEqual(picture.shape, (47, 90, 3))
        mapper.ProgressiveRefinementOff()
        numpy.testing.assert_array_equal(picture, scene.render())

    def test_two_renderers_in_one_window(self):
        scene = make_scene(size=80)
        mapper = scene.volume.GetMapper()
        scene.renderer.SetViewport(0, 0, 0.55, 1)
        other = vtkRenderer()
        other.SetViewport(0.55, 0.2, 1, 1)
        other.AddVolume(scene.volume)  # the same volume and mapper
        other.GetActiveCamera().SetPosition(-3, 1, 3)
        other.ResetCamera(scenes.BOX)
        scene.window.AddRenderer(other)
        completes(self, scene)

        # Each viewport has its own passes, and all have to be complete.
        other.GetActiveCamera().Azimuth(20)
        scene.window.Render()
        self.assertFalse(mapper.GetProgressComplete())
        for _ in range(7):
            scene.window.Render()
        scene.renderer.GetActiveCamera().Azimuth(20)
        self.assertEqual(refine(scene), 16)
        picture = scene.render()

        # A viewport that is not drawn does not count.
        other.GetActiveCamera().Azimuth(20)
        scene.window.Render()
        other.DrawOff()
        self.assertLessEqual(refine(scene), 2)
        other.DrawOn()
        other.GetActiveCamera().Azimuth(-20)
        refine(scene)
        numpy.testing.assert_array_equal(scene.render(), picture)

    def test_stereo(self):
        for kind in ("RedBlue", "SplitViewportHorizontal", "Interlaced"):
            for mode in ("Composite", "IsoSurface"):
                with self.subTest(kind, mode=mode):
                    scene = make_scene(mode)
                    getattr(scene.window, "SetStereoTypeTo" + kind)()
                    scene.window.StereoRenderOn()
                    completes(self, scene)

    def test_one_mapper_for_two_volumes(self):
        scene = make_scene()
        other = vtkVolume()
        other.SetMapper(scene.volume.GetMapper())
        other.SetProperty(scene.volume.GetProperty())
        other.SetPosition(1.2, 0, 0)
        scene.renderer.AddVolume(other)
        scene.renderer.ResetCamera()
        completes(self, scene)

    def test_selections_leave_the_passes_alone(self):
        scene = make_scene()
        mapper = scene.volume.GetMapper()
        plain = scene.render()
        mapper.ProgressiveRefinementOn()
        for _ in range(9):
            scene.window.Render()
        selector = vtkHardwareSelector()
        selector.SetRenderer(scene.renderer)
        selector.SetArea(0, 0, SIZE - 1, SIZE - 1)
        self.assertEqual(selector.Select().GetNumberOfNodes(), 1)
        self.assertFalse(mapper.GetProgressComplete())
        self.assertEqual(refine(scene), 7)
        numpy.testing.assert_array_equal(scene.render(), plain)

    def test_resources(self):
        scene = make_scene()
        mapper = scene.volume.GetMapper()
        plain = scene.render()
        mapper.ProgressiveRefinementOn()
        refine(scene)
        mapper.ReleaseGraphicsResources(scene.window)
        self.assertEqual(refine(scene), 16)
        numpy.testing.assert_array_equal(scene.render(), plain)

        # Another window, and the first one gone.
        other = scenes.make_window(SIZE, SIZE)
        scene.window.RemoveRenderer(scene.renderer)
        scene.window.Finalize()
        scene.window = other
        other.AddRenderer(scene.renderer)
        self.assertEqual(refine(scene), 16)
        numpy.testing.assert_array_equal(scene.render(), plain)
        other.Finalize()
        self.assertEqual(refine(scene), 16)

    def test_switching_off_shows_the_plain_picture_at_once(self):
        scene = make_scene()
        mapper = scene.volume.GetMapper()
        self.assertFalse(mapper.GetProgressiveRefinement())
        self.assertFalse(mapper.GetProgressComplete())
        plain = scene.render()
        mapper.ProgressiveRefinementOn()
        scene.window.Render()
        mapper.ProgressiveRefinementOff()
        numpy.testing.assert_array_equal(scene.render(), plain)
        self.assertTrue(mapper.GetProgressComplete())


if __name__ == "__main__":
    unittest.main()
