# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
"""Geometry before and behind, several volumes and renderers, and images of colours and depths."""
import unittest

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPlane
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper

import comparison
import scenes
from bravais import vtkBCCVolumeMapper


def add_ball(scene, radius, center, opacity=1, color=(0, 1, 0)):
    source = vtkSphereSource()
    source.SetRadius(radius)
    source.SetCenter(center)
    source.SetThetaResolution(30)
    source.SetPhiResolution(30)
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(source.GetOutputPort())
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetOpacity(opacity)
    actor.GetProperty().SetColor(color)
    scene.renderer.AddActor(actor)


def peel(scene):
    scene.window.SetAlphaBitPlanes(1)
    scene.renderer.UseDepthPeelingOn()
    scene.renderer.UseDepthPeelingForVolumesOn()
    scene.renderer.SetMaximumNumberOfPeels(8)
    scene.renderer.SetOcclusionRatio(0)


def get_image(mapper, name):
    image = vtkImageData()
    getattr(mapper, f"Get{name}Image")(image)
    return scenes.to_array(image) if name == "Color" else vtk_to_numpy(
        image.GetPointData().GetScalars()).reshape(image.GetDimensions()[1::-1])


class TestBCCVolumeMapperScene(unittest.TestCase):
    def test_opaque_geometry(self):
        def prepare(scene, mapper, volume_property):
            add_ball(scene, 0.2, (0.7, 0.56, 1.12))
            add_ball(scene, 0.5, (-0.5, -0.3, 0))
            add_ball(scene, 0.4, (-1.4, -1.1, -2))
        for mode in "Composite", "MaximumIntensity", "Additive":
            with self.subTest(mode):
                comparison.compare(self, mode, 1.0, prepare, shade=False)

    def test_translucent_geometry(self):
        """Drawn before the volume without depth peeling, in its place with it."""
        def add(scene, mapper, volume_property):
            add_ball(scene, 0.9, (0.7, 0.5, 1.3), 0.4)
            add_ball(scene, 0.5, (-0.3, -0.2, 0), 0.6, (1, 0, 1))

        def add_and_peel(*scene):
            add(*scene)
            peel(scene[0])
        for prepare in add, add_and_peel:
            with self.subTest(prepare=prepare):
                comparison.compare(self, "Composite", 1.0, prepare, shade=False)

    def test_slices_in_depth_peeling(self):
        def prepare(scene, mapper, volume_property):
            plane = vtkPlane()
            plane.SetNormal(0.2, 0.3, 1)
            volume_property.SetSliceFunction(plane)
            add_ball(scene, 0.4, (0.3, 0.2, 0.6), 0.4)
            peel(scene)
        comparison.compare(self, "Slice", 1.0, prepare, change=False)

    def test_sample_distances(self):
        settings = {
            "auto": lambda mapper: mapper.AutoAdjustSampleDistancesOn(),
            "locked": lambda mapper: mapper.LockSampleDistanceToInputSpacingOn(),
            "coarse": lambda mapper: mapper.SetSampleDistance(0.08),
            "pixels": lambda mapper: mapper.SetImageSampleDistance(2),
            "jitter": lambda mapper: mapper.UseJitteringOn()}
        for name, setting in settings.items():
            with self.subTest(name):
                comparison.compare(self, "Composite", 1.5, lambda scene, mapper, _: setting(mapper),
                                   change=name in ("pixels", "coarse"), shade=False)

    def test_automatic_distance_is_that_of_layers(self):
        pictures = []
        for automatic in True, False:
            scene = comparison.make_scenes("Composite")[1]
            scene.volume.GetMapper().SetAutoAdjustSampleDistances(automatic)
            scene.volume.GetMapper().SetSampleDistance(comparison.BCC.GetSpacing()[2])
            pictures.append(scene.render())
        self.assertLess(numpy.abs(pictures[1] - pictures[0]).max(), 2)

    def test_views(self):
        def parallel(scene, mapper, volume_property):
            scene.renderer.GetActiveCamera().ParallelProjectionOn()

        def inside(scene, mapper, volume_property):
            scene.renderer.GetActiveCamera().SetPosition(0.2, 0.1, 0.5)
            scene.renderer.GetActiveCamera().SetFocalPoint(0, 0, -1)
            scene.renderer.ResetCameraClippingRange()

        def transformed(scene, mapper, volume_property):
            scene.volume.SetScale(0.8, 0.5, 1.1)
            scene.volume.RotateWXYZ(30, 1, 2, 0)
        for prepare in parallel, inside, transformed:
            for mode in "Composite", "IsoSurface":
                with self.subTest(prepare=prepare, mode=mode):
                    comparison.compare(self, mode, 1.6, prepare)

    def test_render_to_image(self):
        def prepare(scene, mapper, volume_property):
            mapper.RenderToImageOn()
            mapper.SetDepthImageScalarTypeToFloat()
        for mode in "Composite", "IsoSurface", "MaximumIntensity":
            pair = comparison.make_scenes(mode, prepare, shade=False)
            colors, depths = [], []
            for scene in pair:
                scene.window.Render()
                colors.append(get_image(scene.volume.GetMapper(), "Color"))
                depths.append(get_image(scene.volume.GetMapper(), "Depth"))
            self.assertGreater(colors[0].std(axis=(0, 1)).max(), 5)
            self.assertLess(numpy.abs(colors[1] - colors[0]).mean(), 1.6, mode)
            if mode == "MaximumIntensity":
                continue  # VTK tells no depths of these
            both = (depths[0] < 1) & (depths[1] < 1)
            self.assertGreater(both.sum(), 500)
            self.assertLess((both != (depths[0] < 1)).mean(), 0.02, mode)
            # Depths differ by up to a step, 0.04, of a view some 6 deep.
            self.assertLess(numpy.median(numpy.abs(depths[1] - depths[0])[both]), 0.01, mode)

    def test_depth_images(self):
        depths = {}
        for name in "UnsignedChar", "UnsignedShort", "Float":
            for clamp in False, True:
                scene = comparison.make_scenes("Composite")[1]
                mapper = scene.volume.GetMapper()
                mapper.RenderToImageOn()
                getattr(mapper, "SetDepthImageScalarTypeTo" + name)()
                mapper.SetClampDepthToBackface(clamp)
                scene.window.Render()
                depths[name, clamp] = get_image(mapper, "Depth").astype(float)
        for clamp in False, True:
            exact = depths["Float", clamp]
            for name, levels in ("UnsignedChar", 255), ("UnsignedShort", 65535):
                numpy.testing.assert_allclose(
                    depths[name, clamp] / levels, exact, atol=0.6 / levels)
        # Rays that meet nothing end at the far faces of the box.
        clear = (depths["Float", True] < 1) & (depths["Float", False] == 1)
        self.assertGreater(clear.sum(), 100)
        self.assertEqual((depths["Float", False] < depths["Float", True]).sum(), 0)

    def test_two_volumes_and_two_renderers(self):
        """Each volume in a half of one window looks as by itself, and both in one as VTK's do."""
        window = scenes.make_window(128, 64)
        alone = []
        for number, mode in enumerate(("Composite", "MaximumIntensity")):
            scene = comparison.make_scenes(mode, shade=False)[1]
            alone.append(scene.render())
            scene.window.RemoveRenderer(scene.renderer)
            scene.renderer.SetViewport(number / 2, 0, (number + 1) / 2, 1)
            window.AddRenderer(scene.renderer)
        window.Render()
        numpy.testing.assert_allclose(
            scenes.get_picture(window), numpy.concatenate(alone, axis=1), atol=1)

        def add_volume(scene, mapper, volume_property):
            image = mapper.GetInput()
            other = type(mapper)()
            other.SetInputData(image)
            other_scene = scenes.Scene(other, volume_property, size=64, sample_distance=0.04)
            other_scene.volume.SetPosition(1.5, 0, -1.5)
            scene.renderer.AddVolume(other_scene.volume)
        comparison.compare(self, "Composite", 1.0, add_volume, shade=False)

    def test_a_mapper_of_more_volumes(self):
        scene = comparison.make_scenes("Composite")[1]
        first = scene.render()
        other = comparison.make_scenes("Composite")[1]
        other.volume.SetMapper(scene.volume.GetMapper())
        self.assertIsInstance(other.volume.GetMapper(), vtkBCCVolumeMapper)
        for _ in range(2):
            numpy.testing.assert_array_equal(other.render(), first)
            numpy.testing.assert_array_equal(scene.render(), first)


if __name__ == "__main__":
    unittest.main()
