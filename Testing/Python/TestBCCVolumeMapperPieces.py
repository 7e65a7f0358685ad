# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
"""Pieces of a volume, each with its ghosts and its own mapper, make up the whole's picture."""
import unittest

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkDataObject, vtkImageData, vtkPlane
from vtkmodules.vtkRenderingCore import vtkColorTransferFunction, vtkVolume
from vtkmodules.vtkRenderingOpenGL2 import vtkOpenGLHardwareSelector

import pieces
import scenes
from bravais import vtkBCCLattice, vtkBCCVolumeMapper, vtkBCCVolumeSource

OPACITIES = ((-1, 0), (0, 0), (0.3, 0.3), (0.5, 0), (1, 0.3))
LEVELS = 7  # of ghosts, more than most kernels need


def wave(x, y, z):
    return numpy.cos(2.5 * x + 0.3) * numpy.cos(3 * y) * numpy.cos(2 * z - 0.4 + x)


WHOLE = scenes.make_bcc(wave, (18, 17, 35))


def make_property(mode, opacity=0.3):
    iso = mode == "IsoSurface"
    result = scenes.make_property(-1, 1, ((-1, opacity), (1, opacity)) if iso else OPACITIES,
                                  iso_values=(-0.5, 0.3, 0.7))
    plane = vtkPlane()
    plane.SetNormal(0.3, 1, 0.2)
    plane.SetOrigin(0.02, 0.03, 0.01)
    result.SetSliceFunction(plane)
    return result


def gray():
    """The larger, the brighter."""
    colors = vtkColorTransferFunction()
    colors.AddRGBPoint(-1, 0.1, 0.1, 0.1)
    colors.AddRGBPoint(1, 1, 1, 1)
    return colors


class TestBCCVolumeMapperPieces(unittest.TestCase):
    def compare(self, mode, counts, tolerance, prepare=None, whole=WHOLE, opacity=0.3, ghosts=LEVELS,
                **options):
        """The largest difference of 8-bit values is not more than the tolerance."""
        volume_property = make_property(mode, opacity)
        scene = pieces.make_scene(whole, mode, volume_property, prepare, **options)
        expected = pieces.take(scene)
        self.assertGreater(expected.max(), 60)
        eye = scene.renderer.GetActiveCamera().GetPosition()
        extents = pieces.sort(pieces.split(whole.GetExtent(), counts), whole, eye)
        pictures = []
        for own in extents:
            scene.volume.GetMapper().SetInputData(pieces.cut(whole, own, ghosts))
            pictures.append(pieces.take(scene))
        for picture in pictures:
            self.assertGreater(numpy.abs(picture - expected).max(), 20, "a part is not all")
        difference = numpy.abs(pieces.blend(pictures) - expected)
        self.assertLessEqual(difference.max(), tolerance)
        return pictures

    def test_composite(self):
        # Up to four pictures are added, with half a level of rounding in each and in the whole's.
        for kernel in 4, 7, 8, 12:
            with self.subTest(kernel):
                self.compare("Composite", (2, 1, 2), 2.5,
                             lambda scene, mapper: mapper.SetKernel(kernel))
        self.compare("Composite", (1, 3, 3), 3.5)

    def test_opaque_surfaces_are_the_same(self):
        for kernel in 4, 7, 8:
            with self.subTest(kernel):
                self.compare("IsoSurface", (2, 1, 2), 0,
                             lambda scene, mapper: mapper.SetKernel(kernel), opacity=1)
        # Where texels lie in the texture decides how its filter rounds.
        self.compare("IsoSurface", (2, 1, 2), 1, lambda scene, mapper: mapper.SetKernel(12), opacity=1)
        self.compare("IsoSurface", (3, 1, 3), 0, opacity=1)

    def test_translucent_surfaces(self):
        self.compare("IsoSurface", (1, 2, 2), 2.5)

    def test_surfaces_that_VTK_finds(self):
        self.compare("IsoSurface", (1, 2, 2), 0,
                     lambda scene, mapper: mapper.IsoSurfaceRefinementOff(), opacity=1)

    def test_slice(self):
        self.compare("Slice", (2, 1, 2), 0)

    def test_extrema_are_those_of_the_parts(self):
        """The brightest of the parts' maxima is the whole's, the darkest of the minima likewise."""
        for mode, choose in ("MaximumIntensity", numpy.max), ("MinimumIntensity", numpy.min):
            volume_property = scenes.make_property(-1, 1, ((-1, 1), (1, 1)), shade=False)
            volume_property.SetColor(gray())
            scene = pieces.make_scene(WHOLE, mode, volume_property)
            expected = pieces.take(scene)
            pictures = []
            for own in pieces.split(WHOLE.GetExtent(), (1, 2, 2)):
                scene.volume.GetMapper().SetInputData(pieces.cut(WHOLE, own, LEVELS))
                picture = pieces.take(scene)
                picture[picture[..., 3] == 0] = numpy.nan if mode == "MaximumIntensity" else 255
                pictures.append(numpy.nan_to_num(picture))
            shown = expected[..., 3] > 0
            self.assertGreater(expected[shown].std(), 10)
            numpy.testing.assert_array_equal(choose(pictures, axis=0)[shown], expected[shown])

    def test_settings(self):
        def crop(scene, mapper):
            mapper.CroppingOn()
            mapper.SetCroppingRegionPlanes(-0.5, 0.5, -0.4, 0.6, -0.5, 0.5)
            mapper.SetCroppingRegionFlagsToFence()

        def enter(scene, mapper):
            scene.renderer.GetActiveCamera().SetPosition(0.1, 0.2, 0.9)

        for prepare in (
                enter,
                lambda scene, mapper: mapper.LockSampleDistanceToInputSpacingOn(),
                lambda scene, mapper: mapper.AutoAdjustSampleDistancesOn(),
                lambda scene, mapper: mapper.SetJitterPatternToBayer(),
                lambda scene, mapper: mapper.HalfFloatCoefficientsOn()):
            self.compare("Composite", (1, 1, 2), 2, prepare)
        for prepare in (
                crop,
                lambda scene, mapper: mapper.AutoAdjustSampleDistancesOn(),
                lambda scene, mapper: mapper.AnalyticGradientsOff(),
                lambda scene, mapper: mapper.EmptySpaceSkippingOff(),
                lambda scene, mapper: mapper.SetPrefilterToNone()):
            self.compare("IsoSurface", (1, 1, 2), 0, prepare, opacity=1)

    def test_gradient_opacity(self):
        def prepare(scene, mapper):
            scene.volume.GetProperty().GetGradientOpacity().RemoveAllPoints()
            scene.volume.GetProperty().GetGradientOpacity().AddPoint(0, 0)
            scene.volume.GetProperty().GetGradientOpacity().AddPoint(0.3, 1)
        self.compare("Composite", (1, 1, 2), 2, prepare)

    def test_long_steps_need_more_ghosts(self):
        self.compare("IsoSurface", (1, 1, 2), 0, opacity=1, ghosts=14, sample_distance=0.2)

    def test_components(self):
        whole = scenes.make_bcc(
            lambda x, y, z: numpy.stack([wave(x, y, z), wave(y, z, x)], axis=-1), (18, 17, 35))
        self.compare("Composite", (1, 1, 2), 2, whole=whole)

    def test_in_one_window(self):
        scene = pieces.make_scene(WHOLE, "Composite", make_property("Composite"))
        expected = pieces.take(scene)
        extents = pieces.sort(pieces.split(WHOLE.GetExtent(), (1, 2, 2)), WHOLE,
                              scene.renderer.GetActiveCamera().GetPosition())
        scene.renderer.RemoveVolume(scene.volume)
        for own in reversed(extents):  # VTK blends in the order of volumes
            mapper = vtkBCCVolumeMapper()
            mapper.SetInputData(pieces.cut(WHOLE, own, LEVELS))
            mapper.AutoAdjustSampleDistancesOff()
            mapper.SetSampleDistance(0.06)
            volume = vtkVolume()
            volume.SetMapper(mapper)
            volume.SetProperty(scene.volume.GetProperty())
            scene.renderer.AddVolume(volume)
        self.assertLessEqual(numpy.abs(pieces.take(scene) - expected).max(), 2.5)

    def test_pieces_of_the_pipeline(self):
        """As a source hands them out by numbers, with ghosts that VTK marks."""
        source = vtkBCCVolumeSource()
        source.SetDimensions(18, 18, 36)
        source.Update()
        whole = source.GetOutput().NewInstance()
        whole.DeepCopy(source.GetOutput())
        levels = vtkBCCVolumeMapper().GetNumberOfGhostLevels(whole.GetSpacing())
        self.assertEqual(levels, 6)
        volume_property = scenes.make_property(0, 1, ((0, 1), (1, 1)), iso_values=(0.5,))
        scene = pieces.make_scene(whole, "IsoSurface", volume_property)
        expected = pieces.take(scene)
        differences = []
        for piece in range(4):
            source.UpdatePiece(piece, 4, levels)
            image = source.GetOutput().NewInstance()
            image.DeepCopy(source.GetOutput())
            self.assertLess(image.GetNumberOfPoints(), whole.GetNumberOfPoints())
            vtkBCCLattice.MarkPiece(image, whole.GetExtent(),
                                    pieces.split_as_pipeline(whole.GetExtent(), piece, 4))
            vtkBCCLattice.MarkWholeRange(
                image, "Scalars", 0, whole.GetPointData().GetScalars().GetRange())
            scene.volume.GetMapper().SetInputData(image)
            differences.append(numpy.abs(pieces.take(scene) - expected).max(axis=2))
            self.assertGreater(differences[-1].max(), 20)
        # Of opaque surfaces every pixel is one piece's.
        self.assertEqual(numpy.min(differences, axis=0).max(), 0)

    def test_masks_on_the_lattice(self):
        mask = scenes.make_bcc(lambda x, y, z: 255 * (x * x + y * y < 0.5), (18, 17, 35),
                               dtype=numpy.uint8)

        def prepare(scene, mapper):
            mapper.SetMaskInput(mask)
            mapper.SetMaskTypeToBinary()
        pictures = self.compare("IsoSurface", (1, 1, 2), 0, prepare, opacity=1)
        plain = pieces.take(pieces.make_scene(WHOLE, "IsoSurface", make_property("IsoSurface", 1)))
        self.assertGreater(numpy.abs(pieces.blend(pictures) - plain).mean(), 5)

    def test_selected_samples_are_those_of_the_piece(self):
        function = lambda x, y, z: x * x + y * y + z * z
        whole = scenes.make_bcc(function, (16, 16, 32))
        volume_property = scenes.make_property(0, 3, ((0, 1), (3, 1)), iso_values=(0.36,))
        own = pieces.split(whole.GetExtent(), (2, 1, 2))[3]  # the one that is seen
        piece = pieces.cut(whole, own, LEVELS)
        found = []
        for image in whole, piece:
            scene = pieces.make_scene(image, "IsoSurface", volume_property, size=60)
            scene.window.Render()
            selector = vtkOpenGLHardwareSelector()
            selector.SetRenderer(scene.renderer)
            selector.SetFieldAssociation(vtkDataObject.FIELD_ASSOCIATION_CELLS)
            selector.SetArea(34, 32, 34, 32)
            node = selector.Select().GetNode(0)
            number, = vtk_to_numpy(node.GetSelectionList())
            extent = image.GetExtent()
            nx, ny, _ = image.GetDimensions()
            found.append((number % nx + extent[0], number // nx % ny + extent[2],
                          number // (nx * ny) + extent[4]))
        self.assertEqual(found[0], found[1])

    def test_colours_are_those_of_the_whole_range(self):
        own = 0, 17, 0, 16, 0, 17
        volume_property = make_property("Composite")
        scalars = WHOLE.GetPointData().GetScalars()
        self.assertLess(numpy.ptp(vtk_to_numpy(scalars)[:18 * 17 * 12]),
                        numpy.ptp(vtk_to_numpy(scalars)))
        piece = pieces.cut(WHOLE, own, LEVELS)
        limits = [0.0, 0.0]
        self.assertTrue(vtkBCCLattice.GetWholeRange(piece, "Scalars", 0, limits))
        self.assertEqual(tuple(limits), scalars.GetRange())
        self.assertFalse(vtkBCCLattice.GetWholeRange(piece, "Scalars", 1, limits))
        self.assertFalse(vtkBCCLattice.GetWholeRange(piece, "Other", 0, limits))
        picture = pieces.take(pieces.make_scene(piece, "Composite", volume_property))
        # A piece without any finite value of its own is looked up like the others.
        vtk_to_numpy(piece.GetPointData().GetScalars())[:] = numpy.nan
        piece.GetPointData().GetScalars().Modified()
        piece.Modified()
        empty = pieces.take(pieces.make_scene(piece, "Composite", volume_property))
        self.assertGreater(picture.max(), 60)
        self.assertFalse(numpy.array_equal(picture, empty))

    def test_bounds_meet(self):
        total = 0
        for own in pieces.split(WHOLE.GetExtent(), (3, 2, 2)):
            mapper = vtkBCCVolumeMapper()
            mapper.SetInputData(pieces.cut(WHOLE, own, LEVELS))
            box = mapper.GetBounds()
            total += numpy.prod(numpy.diff(numpy.reshape(box, (3, 2))))
            for axis in range(3):
                for side in 0, 1:
                    n = 2 * axis + side
                    if own[n] == WHOLE.GetExtent()[n]:
                        self.assertAlmostEqual(box[n], scenes.BOX[n])
                    else:
                        self.assertAlmostEqual(
                            box[n], -1 + WHOLE.GetSpacing()[axis] * own[n])
        self.assertAlmostEqual(total, 8)

    def check_refused(self, image, prepare, *words):
        mapper = vtkBCCVolumeMapper()
        errors = []

        def observe(caller, event, text):
            errors.append(text)
        observe.CallDataType = "string0"
        mapper.AddObserver("ErrorEvent", observe)
        mapper.SetInputData(image)
        scene = scenes.Scene(mapper, make_property("Composite"), size=40)
        prepare(mapper)
        for _ in range(2):
            self.assertEqual(scene.render().std(axis=(0, 1)).max(), 0)
        self.assertEqual(len(errors), 1 if words else 0, errors)
        for word in words:
            self.assertIn(word, errors[0])

    def test_bad_pieces(self):
        own = 0, 17, 0, 16, 10, 20
        self.check_refused(pieces.cut(WHOLE, own, 2), lambda mapper: None,
                           "2 layers of ghost points at the beginning of its z axis", "need 3")
        self.check_refused(pieces.cut(WHOLE, own, 4),
                           lambda mapper: (mapper.SetBlendModeToIsoSurface(),
                                           mapper.SetSampleDistance(0.1)), "4 layers", "need 7")
        for method in "Interpolation", "Projection":
            def prepare(mapper):
                mapper.SetKernelToBCC8()
                getattr(mapper, "SetPrefilterTo" + method)()
            self.check_refused(pieces.cut(WHOLE, own, 8), prepare, method, "whole",
                               "(0, 17, 0, 16, 2, 28)")
        # Where all samples are held, any prefilter does.
        self.compare("Composite", (1, 1, 2), 2, lambda scene, mapper: (
            mapper.SetKernelToBCC8(), mapper.SetPrefilterToInterpolation()), ghosts=50)
        mask = pieces.hold(WHOLE, own, 0)
        self.check_refused(WHOLE, lambda mapper: mapper.SetMaskInput(mask), "mask", "begin at 0")
        stale = pieces.hold(WHOLE, (0, 17, 0, 16, 12, 20), 0)
        vtkBCCLattice.MarkPiece(stale, WHOLE.GetExtent(), own)
        self.check_refused(stale, lambda mapper: None, "(0, 17, 0, 16, 10, 20)",
                           "(0, 17, 0, 16, 12, 20)")

    def test_empty_pieces_show_nothing(self):
        image = vtkImageData()
        vtkBCCLattice.Tag(image)
        vtkBCCLattice.MarkPiece(image, WHOLE.GetExtent(), (0, -1, 0, -1, 0, -1))
        self.check_refused(image, lambda mapper: None)
        flat = pieces.cut(WHOLE, (0, 17, 0, 16, 10, 10), LEVELS)
        self.check_refused(flat, lambda mapper: None)


if __name__ == "__main__":
    unittest.main()
