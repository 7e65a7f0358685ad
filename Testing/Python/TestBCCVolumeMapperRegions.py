# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
"""The whole box is rendered, where it lies, and cropped and clipped where it is asked to be."""
import math
import unittest

import numpy
from vtkmodules.vtkCommonDataModel import vtkPlane
from vtkmodules.vtkRenderingVolumeOpenGL2 import vtkOpenGLGPUVolumeRayCastMapper

import scenes
from bravais import vtkBCCLattice, vtkBCCVolumeMapper

SIZE = 200
OPACITIES = ((-1, 0), (0, 0), (0.3, 0.8), (0.5, 0.1), (1, 0.9))


def wave(x, y, z):
    return numpy.cos(2.5 * x + 0.3) * numpy.cos(3 * y) * numpy.cos(2 * z - 0.4 + x)


def look_along(scene, axis, scale):
    camera = scene.renderer.GetActiveCamera()
    camera.ParallelProjectionOn()
    camera.SetParallelScale(scale)
    camera.SetFocalPoint(0, 0, 0)
    camera.SetPosition(*(10 if a == axis else 0 for a in range(3)))
    camera.SetViewUp(*(1 if a == (axis + 1) % 3 else 0 for a in range(3)))
    scene.renderer.ResetCameraClippingRange()


def get_covered(picture):
    """Rectangle of pixels that are not background: left, right, bottom, top."""
    y, x = numpy.nonzero((picture != picture[0, 0]).any(axis=2))
    return x.min(), x.max() + 1, y.min(), y.max() + 1


def crop_some(mapper):
    mapper.CroppingOn()
    mapper.SetCroppingRegionPlanes(-0.4, 0.3, -0.5, 0.6, -0.2, 0.7)
    mapper.SetCroppingRegionFlags(0x2a5c31b)


def crop_middle(mapper):
    crop_some(mapper)
    mapper.SetCroppingRegionFlagsToSubVolume()


def clip_middle(mapper):
    """The same by clipping planes."""
    for axis, (low, high) in enumerate(((-0.4, 0.3), (-0.5, 0.6), (-0.2, 0.7))):
        for position, sign in ((low, 1), (high, -1)):
            plane = vtkPlane()
            plane.SetOrigin(*(position if a == axis else 0 for a in range(3)))
            plane.SetNormal(*(sign if a == axis else 0 for a in range(3)))
            mapper.AddClippingPlane(plane)


class TestBCCVolumeMapperRegions(unittest.TestCase):
    def make_scene(self, image, mode="Composite"):
        mapper = vtkBCCVolumeMapper()
        mapper.SetInputData(image)
        getattr(mapper, "SetBlendModeTo" + mode)()
        volume_property = scenes.make_property(
            0, 3, ((0, 1), (3, 1)), shade=False, iso_values=(0.5,))
        return scenes.Scene(mapper, volume_property, size=SIZE)

    def test_bounds_are_the_box(self):
        image = scenes.make_bcc(wave, (3, 4, 6))
        mapper = vtkBCCVolumeMapper()
        mapper.SetInputData(image)
        numpy.testing.assert_allclose(mapper.GetBounds(), scenes.BOX, atol=1e-12)
        self.assertLess(image.GetBounds()[1], 0.7)
        self.assertFalse(vtkBCCVolumeMapper().GetBounds()[0] <= vtkBCCVolumeMapper().GetBounds()[1])

    def test_rays_cover_the_whole_box(self):
        # With three points a row half a spacing is a fifth of the box.
        image = scenes.make_bcc(lambda x, y, z: 1 + 0 * x, (3, 3, 5))
        for mode in ("Composite", "MaximumIntensity"):
            scene = self.make_scene(image, mode)
            for axis in range(3):
                look_along(scene, axis, 2.0)  # four units high: the box is half of the window
                left, right, bottom, top = get_covered(scene.render())
                self.assertEqual((left, right, bottom, top), (50, 150, 50, 150), f"axis {axis}")

    def test_isosurfaces_reach_the_faces(self):
        # A plane across the box, seen from its two ends.
        scene = self.make_scene(scenes.make_bcc(lambda x, y, z: 1 + z, (4, 4, 8)), "IsoSurface")
        look_along(scene, 2, 2.0)
        self.assertEqual(get_covered(scene.render()), (50, 150, 50, 150))

    def test_the_mirrors_hold_at_the_faces(self):
        # Shaded by its gradient, which has no part across a face, a constant is one colour.
        for kernel in (4, 7, 8, 12):
            image = scenes.make_bcc(lambda x, y, z: 1 + 0 * x, (2, 3, 4))
            scene = self.make_scene(image, "MaximumIntensity")
            scene.volume.GetMapper().SetKernel(kernel)
            look_along(scene, 0, 2.0)
            covered = scene.render()[55:145, 55:145]
            self.assertEqual(covered.std(axis=(0, 1)).max(), 0)

    def test_piece_that_starts_at_an_odd_layer(self):
        whole = scenes.make_bcc(wave, (12, 12, 24))
        piece = whole.NewInstance()
        piece.DeepCopy(whole)
        piece.Crop((0, 11, 0, 11, 7, 23))
        vtkBCCLattice.Tag(piece)
        pictures = []
        for image in (whole, piece):
            mapper = vtkBCCVolumeMapper()
            mapper.SetPrefilter(0)
            mapper.SetInputData(image)
            mapper.SetBlendModeToSlice()
            plane = vtkPlane()
            plane.SetOrigin(0, 0, 0.3)
            plane.SetNormal(0.1, 0.2, 1)
            volume_property = scenes.make_property(-1, 1, ((-1, 1), (1, 1)), shade=False)
            volume_property.SetSliceFunction(plane)
            mapper.SetColorRangeType(1)
            mapper.SetScalarOpacityRangeType(1)
            pictures.append(scenes.Scene(mapper, volume_property, size=SIZE).render())
        # The slice cuts the piece well inside. Colours are of tables over the volumes' ranges.
        self.assertGreater(pictures[0].std(axis=(0, 1)).max(), 10)
        self.assertLess(numpy.abs(pictures[1] - pictures[0]).mean(), 0.5)

    def test_direction_matrix_and_transformation(self):
        image = scenes.make_bcc(wave)
        reference = self.render(image)
        turned = image.NewInstance()
        turned.DeepCopy(image)
        cosine, sine = math.cos(0.4), math.sin(0.4)
        turned.SetDirectionMatrix(cosine, -sine, 0, sine, cosine, 0, 0, 0, 1)
        x, y = -1, -1
        turned.SetOrigin(cosine * x - sine * y, sine * x + cosine * y, -1)
        picture = self.render(turned, turn=-math.degrees(0.4))
        self.assertLess(numpy.abs(picture - reference).mean(), 0.3)

    def test_mirrored_images_around_the_camera(self):
        """No ray is drawn twice, for the cut before the camera and the far faces."""
        pictures = []
        for sign in 1, -1:
            image = scenes.make_bcc(lambda x, y, z: wave(sign * x, y, z))
            image.SetDirectionMatrix(sign, 0, 0, 0, 1, 0, 0, 0, 1)
            image.SetOrigin(-sign, -1, -1)
            mapper = vtkBCCVolumeMapper()
            mapper.SetInputData(image)
            scene = scenes.Scene(mapper, scenes.make_property(
                -1, 1, ((-1, 0.02), (1, 0.1)), shade=False), size=64)
            camera = scene.renderer.GetActiveCamera()
            camera.SetPosition(0.1, 0.2, 0.3)
            camera.SetFocalPoint(0, 0, -1)
            camera.SetClippingRange(0.05, 4)
            pictures.append(scene.render())
        self.assertGreater(pictures[0].std(axis=(0, 1)).max(), 5)
        self.assertLess(numpy.abs(pictures[1] - pictures[0]).mean(), 0.5)

    def test_cropping_of_turned_images(self):
        """Its planes lie along the volume's axes, however the image's own are turned."""
        for turn in (numpy.diag((-1, 1, -1)), numpy.array(((0, 0, 1), (1, 0, 0), (0, 1, 0))),
                     numpy.array(((0.6, -0.8, 0), (0.8, 0.6, 0), (0, 0, 1)))):
            image = scenes.make_bcc(
                lambda x, y, z: wave(*numpy.tensordot(turn, (x, y, z), 1)), (30, 30, 60))
            image.SetDirectionMatrix(*turn.ravel())
            image.SetOrigin(*turn @ (-1, -1, -1))
            if numpy.count_nonzero(turn) == 3:
                reference = self.render(scenes.make_bcc(wave, (30, 30, 60)), prepare=crop_some)
                picture = self.render(image, prepare=crop_some)
                self.assertLess(numpy.abs(picture - reference).mean(), 0.5)
            else:
                reference = self.render(image, prepare=clip_middle)
                picture = self.render(image, prepare=crop_middle)
                self.assertGreater(reference.std(axis=(0, 1)).max(), 10)
                self.assertLess(numpy.abs(picture - reference).mean(), 0.7)

    def test_more_clipping_planes_than_vtk_has_room_for(self):
        def clip(count):
            def prepare(mapper):
                for number in range(count):
                    plane = vtkPlane()  # that cuts nothing, but the last
                    plane.SetOrigin(0.1 if number == count - 1 else -3 - number, 0, 0)
                    plane.SetNormal(1, 0.2 * (number == count - 1), 0)
                    mapper.AddClippingPlane(plane)
            return prepare
        image = scenes.make_bcc(wave)
        reference = self.render(image, prepare=clip(1))
        self.assertGreater(numpy.abs(reference - self.render(image)).mean(), 2)
        for count in 8, 9, 20:
            numpy.testing.assert_array_equal(self.render(image, prepare=clip(count)), reference)

    def test_slices_of_volumes_that_are_not_scaled_evenly(self):
        """The plane is where it is in the world, as for a volume that has that shape itself."""
        plane = vtkPlane()
        plane.SetOrigin(0.1, 0, 0.2)
        plane.SetNormal(0.5, 0.3, 1)
        pictures = []
        for z in (1, 2):
            image = scenes.make_bcc(lambda x, y, z: x + z, (6, 6, 12))
            image.SetSpacing(*(s / (z if a == 2 else 1) for a, s in enumerate(image.GetSpacing())))
            image.SetOrigin(-1, -1, -1 / z)
            scene = self.make_scene(image, "Slice")
            scene.volume.GetProperty().SetSliceFunction(plane)
            scene.volume.SetScale(1, 1, z)
            pictures.append(scene.render())
        self.assertGreater(pictures[0].std(axis=(0, 1)).max(), 10)
        self.assertLess(numpy.abs(pictures[1] - pictures[0]).mean(), 0.1)

    def render(self, image, turn=0, prepare=None):
        tagged = vtkBCCLattice.IsBCC(image)
        mapper = vtkBCCVolumeMapper() if tagged else vtkOpenGLGPUVolumeRayCastMapper()
        mapper.SetInputData(image)
        if prepare:
            prepare(mapper)
        scene = scenes.Scene(mapper, scenes.make_property(-1, 1, OPACITIES, shade=False))
        scene.volume.RotateZ(turn)
        return scene.render()

    def test_cropping_and_clipping(self):
        def crop(flags):
            def prepare(mapper):
                mapper.CroppingOn()
                mapper.SetCroppingRegionPlanes(-0.4, 0.3, -0.5, 0.6, -0.2, 0.7)
                mapper.SetCroppingRegionFlags(flags)
            return prepare

        def clip(mapper):
            for normal in ((-1, -0.3, -0.5), (0.2, 1, 0)):
                plane = vtkPlane()
                plane.SetOrigin(0.1, -0.2, 0.3)
                plane.SetNormal(normal)
                mapper.AddClippingPlane(plane)

        bcc, cartesian = scenes.make_bcc(wave), scenes.make_cartesian(wave)
        for prepare in (crop(0x0002000), crop(0x2ebfeba), clip):
            reference = self.render(cartesian, prepare=prepare)
            self.assertGreater(reference.std(axis=(0, 1)).max(), 10)
            picture = self.render(bcc, prepare=prepare)
            self.assertLess(numpy.abs(picture - reference).mean(), 0.7)


if __name__ == "__main__":
    unittest.main()
