# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
"""Leaping over empty bricks leaves out samples, and changes no bit of a picture."""
import unittest

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPiecewiseFunction, vtkPlane
from vtkmodules.vtkFiltersSources import vtkPlaneSource
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper, vtkVolumeProperty
from vtkmodules.vtkRenderingVolume import vtkGPUVolumeRayCastMapper

import scenes
from bravais import vtkBCCVolumeMapper

LOOP_TAG = "//VTK::Cropping::Impl"


def shell(x, y, z):
    """1 on a bumpy sphere, 0 far from it."""
    radius = numpy.sqrt(x * x + y * y + z * z) + 0.05 * numpy.sin(9 * x) * numpy.sin(8 * y)
    return numpy.exp(-(((radius - 0.55) / 0.12) ** 2))


def make_scene(mode="Composite", image=None, kernel=4, opacities=((0, 0), (0.2, 0), (1, 0.6)),
               iso_values=(0.4, 0.8), **options):
    mapper = vtkBCCVolumeMapper()
    mapper.SetKernel(kernel)
    mapper.SetInputData(image or scenes.make_bcc(shell))
    getattr(mapper, "SetBlendModeTo" + mode)()
    shade = mode in ("Composite", "IsoSurface")
    return scenes.Scene(mapper, scenes.make_property(
        0, 1, opacities, shade=shade, iso_values=iso_values), size=64, **options)


class TestBCCVolumeMapperSkipping(unittest.TestCase):
    def compare(self, scene, message=""):
        """The picture, which is the same without skipping."""
        mapper = scene.volume.GetMapper()
        mapper.EmptySpaceSkippingOff()
        expected, depth = scene.render(), scene.get_depth()
        mapper.EmptySpaceSkippingOn()
        picture = scene.render()
        self.assertGreater(picture.std(axis=(0, 1)).max(), 5, f"nothing to see {message}")
        numpy.testing.assert_array_equal(picture, expected, message)
        numpy.testing.assert_array_equal(scene.get_depth(), depth, message)
        return picture

    def count(self, scene):
        """The mean number of samples, or of surfaces and rests of rays, that a pixel computes."""
        shader = scene.volume.GetShaderProperty()
        shader.AddFragmentShaderReplacement(
            "//VTK::CustomUniforms::Dec", True,
            "//VTK::CustomUniforms::Dec\nfloat g_count = 0.0;", False)
        shader.AddFragmentShaderReplacement(
            LOOP_TAG, True, LOOP_TAG + "\n g_count += 1.0;", False)
        shader.AddFragmentShaderReplacement(
            "//VTK::Base::Exit", True,
            "//VTK::Base::Exit\n g_fragColor = vec4(vec3(g_count / 255.0), 1.0);", False)
        scene.renderer.SetBackground(0, 0, 0)
        counts = []
        for skip in (False, True):
            scene.volume.GetMapper().SetEmptySpaceSkipping(skip)
            counts.append(scene.render()[..., 0].mean())
        shader.ClearAllFragmentShaderReplacements()
        return counts

    def test_is_on_by_default(self):
        self.assertTrue(vtkBCCVolumeMapper().GetEmptySpaceSkipping())
        self.assertIn("EmptySpaceSkipping: On", str(vtkBCCVolumeMapper()))

    def test_pictures_are_equal(self):
        for mode in ("Composite", "MaximumIntensity", "MinimumIntensity", "AverageIntensity",
                     "Additive", "IsoSurface"):
            scene = make_scene(mode, opacities=(
                (0, 0), (0.2, 0), (1, 0.02 if mode == "Additive" else 0.6)))
            if mode == "MinimumIntensity":
                scene.volume.GetMapper().SetInputData(scenes.make_bcc(lambda *x: 1 - shell(*x)))
            kernels = {"Composite": (4, 12), "IsoSurface": (4, 7)}.get(mode, (4,))
            for kernel in kernels:
                scene.volume.GetMapper().SetKernel(kernel)
                self.compare(scene, f"{mode}, bcc{kernel}")

    def test_samples_are_left_out(self):
        opaque = ((0, 0), (0.2, 0), (1, 0.1))
        for mode, least in (("Composite", 1.8), ("Additive", 1.8), ("MaximumIntensity", 1.15)):
            every, some = self.count(make_scene(mode, opacities=opaque,
                                                image=scenes.make_bcc(shell, (48, 48, 96))))
            self.assertGreater(every, least * some, mode)
            self.assertGreater(some, 1, mode)

    def test_nothing_seen_is_left_out_whole(self):
        every, some = self.count(make_scene(opacities=((0, 0), (2, 0))))
        self.assertGreater(every, 20)
        self.assertEqual(some, 0)

    def test_changes_are_seen(self):
        scene = make_scene()
        first = self.compare(scene)
        opacity = scene.volume.GetProperty().GetScalarOpacity()
        opacity.RemoveAllPoints()
        for scalar, value in ((0, 0), (0.05, 0.3), (0.2, 0), (1, 0)):
            opacity.AddPoint(scalar, value)
        second = self.compare(scene)
        self.assertGreater(numpy.abs(second - first).mean(), 2)
        image = scene.volume.GetMapper().GetInput()
        values = vtk_to_numpy(image.GetPointData().GetScalars())
        values[:] = scenes.vtk_to_numpy(
            scenes.make_bcc(lambda x, y, z: shell(x - 0.3, y, z)).GetPointData().GetScalars())
        image.GetPointData().GetScalars().Modified()
        third = self.compare(scene)
        self.assertGreater(numpy.abs(third - second).mean(), 2)
        scene.volume.ReleaseGraphicsResources(scene.window)
        self.compare(scene)

    def test_blend_modes_may_change(self):
        # Bricks have a byte for what is seen, or one for each component's bound.
        image = scenes.make_bcc(lambda x, y, z: numpy.stack(
            [shell(x - 0.15 * c, y, z) for c in range(3)], axis=3))
        scene = make_scene(image=image)
        for mode in ("Composite", "MaximumIntensity", "Composite"):
            getattr(scene.volume.GetMapper(), "SetBlendModeTo" + mode)()
            self.compare(scene, mode)

    def test_gradients_where_rays_end(self):
        # VTK multiplies an extremum's opacity by that of the gradient there.
        for mode in ("MaximumIntensity", "MinimumIntensity"):
            scene = make_scene(mode, opacities=((0, 0.3), (1, 0.9)))
            function = vtkPiecewiseFunction()
            function.AddPoint(0, 0.2)
            function.AddPoint(0.02, 1)
            scene.volume.GetProperty().SetGradientOpacity(function)
            self.compare(scene, mode)

    def test_isovalues_may_change(self):
        scene = make_scene("IsoSurface")
        first = self.compare(scene)
        scene.volume.GetProperty().GetIsoSurfaceValues().SetValue(0, 0.1)
        second = self.compare(scene)
        self.assertGreater(numpy.abs(second - first).mean(), 1)
        scene.volume.GetProperty().GetIsoSurfaceValues().SetNumberOfContours(1)
        scene.volume.GetProperty().GetIsoSurfaceValues().SetValue(0, 0.5)
        self.compare(scene)

    def test_steps_of_any_length(self):
        for mode in ("Composite", "IsoSurface"):
            scene = make_scene(mode)
            for distance in (0.004, 0.05, 0.2):
                scene.volume.GetMapper().SetSampleDistance(distance)
                self.compare(scene, f"{mode}, {distance}")

    def test_jitter_cropping_clipping_and_masks(self):
        for mode in ("Composite", "IsoSurface", "MaximumIntensity"):
            scene = make_scene(mode)
            mapper = scene.volume.GetMapper()
            mapper.SetJitterPattern(2 if mode == "Composite" else 1)
            mapper.CroppingOn()
            mapper.SetCroppingRegionPlanes(-0.3, 0.4, -0.5, 0.6, -0.2, 0.3)
            mapper.SetCroppingRegionFlagsToFence()
            plane = vtkPlane()
            plane.SetNormal(-0.5, 0.3, -1)
            mapper.AddClippingPlane(plane)
            mapper.SetMaskInput(scenes.make_cartesian(
                lambda x, y, z: (x > -0.2) * 255, (24, 24, 24), dtype=numpy.uint8))
            mapper.SetMaskTypeToBinary()
            self.compare(scene, mode)

    def test_labels_are_seen_where_scalars_are_not(self):
        scene = make_scene()
        mapper = scene.volume.GetMapper()
        mapper.SetMaskInput(scenes.make_cartesian(
            lambda x, y, z: (x > -0.2) * 1, (24, 24, 24), dtype=numpy.uint8))
        mapper.SetMaskTypeToLabelMap()
        mapper.SetMaskBlendFactor(1)
        label = vtkPiecewiseFunction()
        label.AddPoint(0, 0.2)
        label.AddPoint(1, 0.2)
        scene.volume.GetProperty().SetLabelScalarOpacity(1, label)
        scene.volume.GetProperty().SetLabelColor(
            1, scene.volume.GetProperty().GetRGBTransferFunction())
        self.compare(scene)

    def test_transfer_functions_of_every_kind(self):
        scene = make_scene()
        volume_property = scene.volume.GetProperty()
        volume_property.SetInterpolationTypeToNearest()
        self.compare(scene, "nearest")
        scene.volume.GetMapper().SetScalarOpacityRangeType(vtkGPUVolumeRayCastMapper.NATIVE)
        volume_property.GetScalarOpacity().AddPoint(1.5, 1)
        self.compare(scene, "native range")
        scene = make_scene()
        table = vtkImageData()
        table.SetDimensions(64, 64, 1)
        values = numpy.zeros((64, 64, 4), numpy.float32)
        values[:, 20:50] = (1, 0.8, 0.5, 0.5)
        table = scenes.make_image(values.reshape(1, 64, 64, 4), (64, 64, 1), (0, 0, 0), (1, 1, 1))
        scene.volume.GetProperty().SetTransferFunctionMode(vtkVolumeProperty.TF_2D)
        scene.volume.GetProperty().SetTransferFunction2D(table)
        self.compare(scene, "2D")
        scene.volume.GetMapper().SetBlendModeToIsoSurface()
        self.compare(scene, "2D, isosurfaces")

    def test_components(self):
        for count, modes in ((2, ("Composite",)), (2, ("MaximumIntensity", "MinimumIntensity")),
                             (3, ("MaximumIntensity", "MinimumIntensity")), (4, ("Composite",)),
                             (4, ("MaximumIntensity",))):
            for independent in (True, False) if modes == ("Composite",) else (True,):
                for mode in modes:
                    image = scenes.make_bcc(lambda x, y, z: numpy.stack(
                        [shell(x - 0.15 * c, y + 0.1 * c, z) * 255 for c in range(count)], axis=3),
                        dtype=numpy.uint8)
                    if mode == "MinimumIntensity":
                        values = vtk_to_numpy(image.GetPointData().GetScalars())
                        values[:] = 255 - values
                    scene = make_scene(mode, image)
                    volume_property = scenes.make_property(
                        0, 255, ((0, 0), (60, 0), (255, 0.03 if mode == "Additive" else 0.6)), shade=False, iso_values=(130,))
                    for c in range(1, count):
                        other = scenes.make_property(0, 255, ((0, 0), (120, 0), (255, 0.4)))
                        volume_property.SetColor(c, other.GetRGBTransferFunction())
                        volume_property.SetScalarOpacity(c, other.GetScalarOpacity())
                        volume_property.SetScalarOpacityUnitDistance(c, 0.1)
                    volume_property.SetIndependentComponents(independent)
                    scene.volume.SetProperty(volume_property)
                    self.compare(scene, f"{mode}, {count} components, independent {independent}")

    def test_holes_and_pieces(self):
        image = scenes.make_bcc(shell)
        values = vtk_to_numpy(image.GetPointData().GetScalars())
        values[14000:14010] = numpy.nan
        values[20000] = numpy.inf
        self.compare(make_scene("Composite", image), "holes")
        self.compare(make_scene("IsoSurface", image), "holes")
        whole = scenes.make_bcc(shell)
        piece = vtkImageData()
        piece.ShallowCopy(whole)
        piece.Crop((3, 19, 2, 20, 5, 40))
        self.compare(make_scene("IsoSurface", piece), "piece")

    def test_extrema_behind_surfaces_and_holes(self):
        # What a ray looks ahead for has to be where the ray gets to.
        image = scenes.make_bcc(lambda x, y, z: shell(x, y, z) + numpy.exp(-9 * (z + 0.8) ** 2))
        values = vtk_to_numpy(image.GetPointData().GetScalars())
        values[20000] = numpy.inf
        values[14000:14010] = numpy.nan
        for mode in ("MaximumIntensity", "MinimumIntensity"):
            scene = make_scene(mode, image, kernel=7, opacities=((0, 0.1), (1, 0.9)))
            open_picture = self.compare(scene, mode)
            wall = vtkPlaneSource()
            wall.SetOrigin(-2, -2, -0.1)
            wall.SetPoint1(2, -2, -0.1)
            wall.SetPoint2(-2, 2, -0.1)
            mapper = vtkPolyDataMapper()
            mapper.SetInputConnection(wall.GetOutputPort())
            actor = vtkActor()
            actor.SetMapper(mapper)
            scene.renderer.AddActor(actor)
            picture = self.compare(scene, mode + " behind a wall")
            self.assertGreater(numpy.abs(picture - open_picture).mean(), 2, mode)

    def test_bounds_beyond_the_range_of_the_samples(self):
        # What is above the range of the samples looks like its end, so it may be left out too.
        image = scenes.make_bcc(lambda x, y, z: (shell(x, y, z) > 0.5) * 1.0)
        scene = make_scene("MaximumIntensity", image)
        for prefilter in (0, 1, 3):
            scene.volume.GetMapper().SetPrefilter(prefilter)
            self.compare(scene, f"prefilter {prefilter}")


if __name__ == "__main__":
    unittest.main()
