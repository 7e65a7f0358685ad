# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
"""Colours are those of VTK's own textures: components, types, light, opacity, and all else that a
mapper of VTK does."""
import unittest

import numpy as np
from vtkmodules.vtkCommonCore import vtkUnsignedCharArray
from vtkmodules.vtkCommonDataModel import vtkDataObject
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkFiltersTexture import vtkTextureMapToSphere
from vtkmodules.vtkRenderingCore import (
    vtkActor, vtkHardwareSelector, vtkPolyDataMapper, vtkTexture)

import bravais
import textures

TYPES = np.uint8, np.uint16, np.float32, np.float64


def make_picture(color, dtype=np.uint8):
    """A Cartesian image of four pixels of one colour."""
    return bravais.image_from_numpy(np.tile(np.array(color, dtype), (2, 2, 1)), components=True)


def find_nearest(texture, places, generator, n):
    """The texel nearest to each place, by looking at all of them."""
    points = np.outer(np.arange(n), generator) % n / n
    away = np.abs(places[:, :, None, :] - points)
    away = np.minimum(away, 1 - away)
    return bravais.rank1_to_numpy(texture)[0].reshape(n, -1)[(away ** 2).sum(-1).argmin(-1)]


class TestRank1TexturedMapperColors(unittest.TestCase):
    def check_close(self, first, second, tolerance=1):
        self.assertLessEqual(np.abs(first - second).max(), tolerance)

    def test_defaults(self):
        mapper = bravais.vtkRank1TexturedPolyDataMapper()
        self.assertEqual(mapper.GetInterpolationAsString(), "Barycentric")
        self.assertEqual(mapper.GetLevelFilterAsString(), "Trilinear")
        self.assertFalse(mapper.GetHalfPrecision())
        for number, mode in enumerate(textures.MODES):
            getattr(mapper, "SetInterpolationTo" + mode)()
            self.assertEqual((mapper.GetInterpolation(), mapper.GetInterpolationAsString()),
                             (number, mode))
        for number, name in enumerate(("NearestLevel", "Trilinear")):
            getattr(mapper, "SetLevelFilterTo" + name)()
            self.assertEqual((mapper.GetLevelFilter(), mapper.GetLevelFilterAsString()),
                             (number, name))
        for word in ("Interpolation: BoxSpline", "LevelFilter: Trilinear", "HalfPrecision: Off",
                     "TexelTime: 0"):
            self.assertIn(word, str(mapper))

    def test_components_and_types(self):
        places = textures.get_places(64)
        for dtype in TYPES:
            for components in 1, 2, 3, 4:
                texture = textures.make_texture(97, (5, 31), components, dtype)
                expected = find_nearest(texture, places, (5, 31), 97).astype(float)
                expected *= 255 / textures.ONE.get(np.dtype(dtype), 1)
                rgb = expected[..., :3] if components > 2 else expected[..., :1]
                if components % 2 == 0:
                    rgb = rgb * expected[..., -1:] / 255  # over black
                for half in (False, True) if dtype in (np.float32, np.float64) else (False,):
                    mapper = textures.make_mapper(texture, "Nearest")
                    mapper.SetHalfPrecision(half)
                    with self.subTest(dtype=dtype, components=components, half=half):
                        difference = np.abs(textures.Quad(mapper, 64).render() - rgb).max(-1)
                        # Where two texels are equally near, either may be taken. Blending rounds
                        # once more.
                        tolerance = 1.01 if components % 2 else 2.01
                        self.assertLess((difference > tolerance).mean(), 0.002)

    def test_float_colours_beyond_one_and_half_ones_beyond_their_range(self):
        values = np.zeros((8, 3), np.float32)
        values[:] = 4.0, 0.25, -1.0
        light = bravais.rank1_from_numpy(values, (1, 3))
        mapper = textures.make_mapper(light)
        quad = textures.Quad(mapper)
        quad.actor.GetProperty().SetColor(0.125, 1, 1)  # 4 times that is a half
        self.check_close(quad.render(), [127.5, 63.75, 0])
        values[:] = 1e30, 0.25, -1e30
        light.Modified()
        mapper.HalfPrecisionOn()
        quad.actor.GetProperty().SetColor(0.5 / 65504, 1, 1)
        self.check_close(quad.render(), [127.5, 63.75, 0])

    def test_light_as_on_vtk_textures(self):
        color = 200, 120, 40
        source = vtkTextureMapToSphere()
        sphere = vtkSphereSource()
        sphere.SetCenter(0.5, 0.5, 0)
        source.SetInputConnection(sphere.GetOutputPort())
        source.Update()
        for change in (lambda actor: None, lambda actor: actor.GetProperty().SetSpecular(0.7),
                       lambda actor: actor.GetProperty().SetInterpolationToPBR(),
                       lambda actor: actor.GetProperty().EdgeVisibilityOn(),
                       lambda actor: actor.GetProperty().SetRepresentationToWireframe(),
                       lambda actor: actor.GetProperty().SetOpacity(0.5),
                       lambda actor: actor.GetProperty().FrontfaceCullingOn(),
                       lambda actor: (actor.GetProperty().FrontfaceCullingOn(),
                                      actor.GetProperty().ShowTexturesOnBackfaceOff())):
            ours = textures.make_mapper(textures.make_constant(color), quad=source.GetOutput())
            theirs = vtkPolyDataMapper()
            theirs.SetInputData(source.GetOutput())
            pictures = []
            for mapper in ours, theirs:
                quad = textures.Quad(mapper, lighting=True)
                change(quad.actor)
                if mapper is theirs:
                    texture = vtkTexture()
                    texture.SetInputData(make_picture(color))
                    quad.actor.SetTexture(texture)
                pictures.append(quad.render())
            self.assertGreater(pictures[0].std(), 5)
            self.check_close(*pictures)

    def test_scalars_and_textures_multiply(self):
        quad = textures.make_quad()
        colors = vtkUnsignedCharArray()
        colors.SetNumberOfComponents(3)
        for color in (255, 0, 0), (0, 255, 0), (255, 255, 255), (0, 0, 255):
            colors.InsertNextTuple(color)
        quad.GetPointData().SetScalars(colors)
        plain = vtkPolyDataMapper()
        plain.SetInputData(quad)
        ours = textures.make_mapper(textures.make_constant((102, 204, 51)), quad=quad)
        expected = textures.Quad(plain).render() * [0.4, 0.8, 0.2]
        self.check_close(textures.Quad(ours).render(), expected)

    def test_scalars_that_are_coloured_by_vtk_s_own_texture(self):
        quad = textures.make_quad()
        heights = quad.GetPointData().GetTCoords().NewInstance()
        heights.SetName("heights")
        for height in 0, 1, 0, 1:
            heights.InsertNextTuple1(height)
        quad.GetPointData().SetScalars(heights)
        plain = vtkPolyDataMapper()
        plain.SetInputData(quad)
        ours = textures.make_mapper(textures.make_texture(56, (4, 7), 1), quad=quad)
        pictures = []
        for mapper in plain, ours:
            mapper.InterpolateScalarsBeforeMappingOn()
            pictures.append(textures.Quad(mapper).render())
        alone = textures.show(textures.make_texture(56, (4, 7), 1)) / 255
        self.check_close(pictures[1], pictures[0] * alone, 1.5)

    def test_with_a_texture_of_the_actor(self):
        quad = textures.Quad(textures.make_mapper(textures.make_texture(56, (4, 7))))
        alone = quad.render()
        texture = vtkTexture()
        texture.SetInputData(make_picture((51, 102, 204)))
        quad.actor.SetTexture(texture)
        self.check_close(quad.render(), alone * [0.2, 0.4, 0.8])

    def test_translucent_texels(self):
        for color, opaque in ((200, 100, 0, 255), True), ((200, 100, 0, 64), False):
            texture = textures.make_constant(color)
            mapper = textures.make_mapper(texture)
            self.assertEqual(mapper.HasOpaqueGeometry(), opaque)
            self.assertEqual(mapper.HasTranslucentPolygonalGeometry(), not opaque)
        behind = textures.Quad(mapper, background=(0, 0, 1))
        mixed = np.array([50.2, 25.1, 255 * 191 / 255])
        self.check_close(behind.render(), mixed)
        # Two of them, the nearer one drawn first, with and without depth peeling.
        nearer = vtkActor()
        nearer.SetMapper(textures.make_mapper(textures.make_constant((0, 255, 0, 128))))
        nearer.SetPosition(0, 0, 0.5)
        nearer.GetProperty().LightingOff()
        behind.renderer.RemoveActor(behind.actor)
        behind.renderer.AddActor(nearer)
        behind.renderer.AddActor(behind.actor)
        behind.window.SetAlphaBitPlanes(1)
        behind.renderer.SetUseDepthPeeling(True)
        behind.renderer.SetMaximumNumberOfPeels(4)
        self.check_close(behind.render(), mixed * 127 / 255 + np.array([0, 128, 0]), 2)

    def test_several_actors_of_one_and_several_mappers(self):
        red, green = (textures.make_mapper(textures.make_constant(color))
                      for color in ((255, 0, 0), (0, 255, 0)))
        quad = textures.Quad(red)
        for x, mapper in (0.25, green), (0.5, red), (0.75, green):
            actor = vtkActor()
            actor.SetMapper(mapper)
            actor.GetProperty().LightingOff()
            actor.SetPosition(x, 0, 0.1 + x)
            quad.renderer.AddActor(actor)
        for _ in range(2):
            picture = quad.render()
            for x, color in (10, (255, 0, 0)), (30, (0, 255, 0)), (60, (255, 0, 0)), \
                    (90, (0, 255, 0)):
                self.assertEqual(tuple(picture[50, x]), color)

    def test_texture_coordinates_are_periodic_and_may_be_transformed(self):
        texture = textures.make_texture(56, (4, 7))
        once = textures.show(texture, size=32)
        mapper = textures.make_mapper(texture, quad=textures.make_quad(-1, 2))
        self.check_close(textures.Quad(mapper, 96).render(), np.tile(once, (3, 3, 1)))
        quad = textures.Quad(textures.make_mapper(texture), 32)
        transform = vtkTransform()
        transform.Translate(1 / 4, 1 / 2, 0)
        transform.Scale(-1, 1, 1)
        plain = vtkTexture()
        plain.SetInputData(make_picture((255, 255, 255)))
        plain.SetTransform(transform)
        quad.actor.SetTexture(plain)
        moved = np.roll(np.roll(once, -16, axis=0)[:, ::-1], 8, axis=1)
        self.check_close(quad.render(), moved)

    def test_picking(self):
        quad = textures.Quad(textures.make_mapper(textures.make_texture(56, (4, 7), 4)))
        before = quad.render()
        selector = vtkHardwareSelector()
        selector.SetRenderer(quad.renderer)
        selector.SetArea(40, 40, 50, 50)
        for association in (vtkDataObject.FIELD_ASSOCIATION_CELLS,
                            vtkDataObject.FIELD_ASSOCIATION_POINTS):
            selector.SetFieldAssociation(association)
            selection = selector.Select()
            if association == vtkDataObject.FIELD_ASSOCIATION_CELLS:
                self.assertEqual(selection.GetNumberOfNodes(), 1)
                self.assertEqual(selection.GetNode(0).GetSelectionList().GetValue(0), 0)
        self.check_close(quad.render(), before, 0)

    def test_user_shader_replacements_are_applied(self):
        quad = textures.Quad(textures.make_mapper(textures.make_texture(56, (4, 7))))
        before = quad.render()
        shader = quad.actor.GetShaderProperty()
        shader.AddFragmentShaderReplacement(
            "//VTK::TCoord::Impl", True,
            "//VTK::TCoord::Impl\n gl_FragData[0].rgb = gl_FragData[0].bgr;", False)
        self.check_close(quad.render(), before[..., ::-1], 0)
        shader.ClearAllFragmentShaderReplacements()
        self.check_close(quad.render(), before, 0)

    def test_copies(self):
        mapper = textures.make_mapper(textures.make_texture(), "BoxSpline")
        mapper.HalfPrecisionOn()
        copy = bravais.vtkRank1TexturedPolyDataMapper()
        copy.ShallowCopy(mapper)
        self.check_close(textures.Quad(copy).render(), textures.Quad(mapper).render(), 0)
        self.assertEqual(copy.GetInterpolationAsString(), "BoxSpline")
        self.assertTrue(copy.GetHalfPrecision())


if __name__ == "__main__":
    unittest.main()
