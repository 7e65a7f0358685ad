# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
"""Isosurfaces lie on the true roots: depths, silhouettes and orders do not depend on the step."""
import unittest

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPlane
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper, vtkPropPicker

import scenes
from bravais import vtkBCCVolumeMapper

KERNELS = (4, 7, 8, 12)
RADIUS = 0.6


def paraboloid(x, y, z):
    """Reproduced by the splines of order 4, whose isosurfaces so are true spheres."""
    return x * x + y * y + z * z


def make_mapper(kernel=7, image=None):
    mapper = vtkBCCVolumeMapper()
    mapper.SetKernel(kernel)
    mapper.SetInputData(image or scenes.make_bcc(paraboloid, (20, 20, 40)))
    mapper.SetBlendModeToIsoSurface()
    return mapper


def opaque(*iso_values):
    return scenes.make_property(0, 3, ((0, 1), (3, 1)), iso_values=iso_values)


def get_radii(scene, depth):
    y, x = numpy.nonzero(depth < 1)
    return numpy.sqrt((scene.to_world(x, y, depth[y, x]) ** 2).sum(axis=0))


class TestBCCVolumeMapperIsoSurface(unittest.TestCase):
    def check_sphere(self, kernel, step, parallel):
        mapper = make_mapper(kernel)
        scene = scenes.Scene(mapper, opaque(RADIUS ** 2), sample_distance=step)
        scene.renderer.GetActiveCamera().SetParallelProjection(parallel)
        scene.render()
        depth = scene.get_depth()
        radii = get_radii(scene, depth)
        self.assertGreater(len(radii), 1000)
        # bcc4 interpolates the paraboloid linearly over tetrahedra of edges up to 0.1.
        tolerance = 4e-3 if kernel == 4 else 2e-5
        self.assertLess(numpy.abs(radii - RADIUS).max(), tolerance, f"bcc{kernel}, step {step}")

        mapper.RenderToImageOn()
        scene.window.Render()
        image = vtkImageData()
        mapper.GetDepthImage(image)
        reported = vtk_to_numpy(image.GetPointData().GetScalars()).reshape(depth.shape)
        self.assertLess(numpy.abs(reported - depth)[depth < 1].max(), 1e-6)
        return depth < 1

    def test_depth_is_the_spheres_for_any_step(self):
        for kernel in KERNELS:
            for parallel in (False, True) if kernel == 7 else (False,):
                fine = self.check_sphere(kernel, 0.03, parallel)
                seen = self.check_sphere(kernel, 0.11, parallel)
                numpy.testing.assert_array_equal(seen, fine, f"bcc{kernel}")

    def test_silhouettes_do_not_depend_on_the_step(self):
        # Waves of twelve layers, and steps up to two layers, the edge of the lattice's cubes.
        def waves(x, y, z):
            return numpy.cos(5 * x + 1) * numpy.cos(5 * y + 2) * numpy.cos(5 * z)
        image = scenes.make_bcc(waves, (10, 10, 20))
        layer = image.GetSpacing()[2]
        for iso_value in (0.6, -0.6):
            seen = []
            for step in (0.1 * layer, layer, 2 * layer):
                scene = scenes.Scene(make_mapper(image=image), opaque(iso_value),
                                     sample_distance=step)
                scene.render()
                seen.append(scene.get_depth() < 1)
            count = seen[0].sum()
            self.assertGreater(count, 3000)
            self.assertLessEqual((seen[1] != seen[0]).sum(), 0.001 * count)
            self.assertLessEqual((seen[2] != seen[0]).sum(), 0.005 * count)

    def test_picture_does_not_depend_on_the_step(self):
        pictures = [scenes.Scene(make_mapper(), opaque(0.2, 0.7), sample_distance=step).render()
                    for step in (0.02, 0.09)]
        self.assertLess(numpy.abs(pictures[1] - pictures[0]).mean(), 0.3)

    def test_without_refinement_the_surface_lies_behind(self):
        mapper = make_mapper()
        mapper.IsoSurfaceRefinementOff()
        mapper.RenderToImageOn()
        scene = scenes.Scene(mapper, opaque(RADIUS ** 2), sample_distance=0.1)
        scene.window.Render()
        image = vtkImageData()
        mapper.GetDepthImage(image)
        depth = vtk_to_numpy(image.GetPointData().GetScalars()).reshape(scene.size, scene.size)
        self.assertGreater(numpy.abs(get_radii(scene, depth) - RADIUS).max(), 0.01)

    def test_surfaces_blend_front_to_back(self):
        # Seen along z through the centre: the outer and the inner sphere, twice each.
        volume_property = opaque(0.7, 0.2)
        volume_property.GetScalarOpacity().RemoveAllPoints()
        for scalar, opacity in ((0, 0.5), (0.45, 0.5), (0.5, 0.25), (3, 0.25)):
            volume_property.GetScalarOpacity().AddPoint(scalar, opacity)
        volume_property.ShadeOff()
        for step in (0.03, 0.5):
            scene = scenes.Scene(make_mapper(), volume_property, sample_distance=step)
            scene.renderer.SetBackground(0, 0, 0)
            picture = scene.render()
            red, color = numpy.zeros(3), [0.0] * 3
            alpha = 0.0
            for value, opacity in ((0.7, 0.25), (0.2, 0.5), (0.2, 0.5), (0.7, 0.25)):
                volume_property.GetRGBTransferFunction().GetColor(value, color)
                red += (1 - alpha) * opacity * numpy.array(color)
                alpha += (1 - alpha) * opacity
            middle = scene.size // 2
            numpy.testing.assert_allclose(picture[middle, middle], 255 * red, atol=3)

    def test_opaque_geometry_hides_and_is_hidden(self):
        source = vtkSphereSource()
        source.SetRadius(0.2)
        source.SetPhiResolution(60)
        source.SetThetaResolution(60)
        mapper = vtkPolyDataMapper()
        mapper.SetInputConnection(source.GetOutputPort())
        actor = vtkActor()
        actor.SetMapper(mapper)
        actor.GetProperty().SetColor(0, 1, 0)
        actor.GetProperty().LightingOff()
        for position, shown in (((0, 0, 0), False), ((0.7, 0.56, 1.12), True)):
            scene = scenes.Scene(make_mapper(), opaque(RADIUS ** 2), sample_distance=0.08)
            scene.renderer.AddActor(actor)
            actor.SetPosition(position)
            picture = scene.render()
            middle = scene.size // 2
            self.assertEqual(tuple(picture[middle, middle]) == (0, 255, 0), shown)

    def test_depth_peels_show_all_surfaces_once(self):
        source = vtkSphereSource()
        source.SetRadius(0.5)
        source.SetCenter(0.3, 0.2, 0.5)
        source.SetThetaResolution(40)
        source.SetPhiResolution(40)
        mapper = vtkPolyDataMapper()
        mapper.SetInputConnection(source.GetOutputPort())
        actor = vtkActor()
        actor.SetMapper(mapper)
        actor.GetProperty().SetOpacity(0.004)  # next to invisible
        volume_property = scenes.make_property(
            0, 3, ((0, 0.4), (3, 0.4)), shade=False, iso_values=(0.1, 0.3, 0.6))
        pictures = []
        for peel in (False, True):
            scene = scenes.Scene(make_mapper(), volume_property, sample_distance=0.05)
            if peel:
                scene.renderer.AddActor(actor)
                scene.window.SetAlphaBitPlanes(1)
                scene.renderer.UseDepthPeelingOn()
                scene.renderer.UseDepthPeelingForVolumesOn()
                scene.renderer.SetMaximumNumberOfPeels(8)
                scene.renderer.SetOcclusionRatio(0)
            pictures.append(scene.render())
        wrong = (numpy.abs(pictures[1] - pictures[0]) > 12).any(axis=2)
        # VTK drops segments of a ray that are shorter than a step.
        self.assertLess(wrong.mean(), 0.01)

    def test_picks_are_on_the_surface(self):
        scene = scenes.Scene(make_mapper(), opaque(RADIUS ** 2), sample_distance=0.08)
        scene.window.Render()
        picker = vtkPropPicker()
        for place in (75, 60, 90):
            self.assertEqual(picker.Pick(place, 75, 0, scene.renderer), 1)
            self.assertIs(picker.GetViewProp(), scene.volume)
            # VTK picks at the corner of a pixel, half a pixel from where its ray is.
            radius = numpy.linalg.norm(picker.GetPickPosition())
            self.assertAlmostEqual(radius, RADIUS, delta=0.02)

    def test_cropping_and_clipping_cut_surfaces(self):
        for cut in ("crop", "clip"):
            mapper = make_mapper()
            if cut == "crop":
                mapper.CroppingOn()
                mapper.SetCroppingRegionPlanes(-1, 0.21, -1, 1, -1, 1)
                mapper.SetCroppingRegionFlagsToSubVolume()
            else:
                plane = vtkPlane()
                plane.SetOrigin(0.21, 0, 0)
                plane.SetNormal(-1, 0, 0)
                mapper.AddClippingPlane(plane)
            scene = scenes.Scene(mapper, opaque(RADIUS ** 2), sample_distance=0.09)
            scene.render()
            depth = scene.get_depth()
            y, x = numpy.nonzero(depth < 1)
            world = scene.to_world(x, y, depth[y, x])
            self.assertLess(numpy.abs(numpy.sqrt((world ** 2).sum(axis=0)) - RADIUS).max(), 2e-5)
            self.assertLess(world[0].max(), 0.21 + 1e-4, cut)
            self.assertGreater(world[0].max(), 0.2, cut)

    def test_iso_values_outside_the_range_show_nothing(self):
        scene = scenes.Scene(make_mapper(), opaque(-5, 17))
        self.assertEqual(scene.render().std(axis=(0, 1)).max(), 0)

    def test_baseline(self):
        def gyroid(x, y, z):
            return (numpy.sin(5 * x) * numpy.cos(5 * y) + numpy.sin(5 * y) * numpy.cos(5 * z)
                    + numpy.sin(5 * z) * numpy.cos(5 * x))
        scene = scenes.Scene(make_mapper(image=scenes.make_bcc(gyroid)), scenes.make_property(
            -1.5, 1.5, ((-2, 1), (0, 1), (0.1, 0.4), (2, 0.4)), iso_values=(-0.6, 0.6)),
            size=240, sample_distance=0.04)
        scene.window.Render()
        scenes.check_baseline(self, scene.window)


if __name__ == "__main__":
    unittest.main()
