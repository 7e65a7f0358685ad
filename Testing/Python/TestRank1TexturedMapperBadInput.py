# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
"""Bad input gets one error that names it, however many frames, and an empty picture."""
import unittest

import numpy as np
from vtkmodules.vtkCommonCore import vtkFloatArray, vtkStringArray
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkMultiBlockDataSet, vtkPolyData

import bravais
import textures


class TestRank1TexturedMapperBadInput(unittest.TestCase):
    def check_refused(self, words, texture, quad=None, prepare=None):
        mapper = bravais.vtkRank1TexturedPolyDataMapper()
        if quad is not False:
            mapper.SetInputData(quad or textures.make_quad())
        if texture is not None:
            mapper.SetTextureData(texture)
        if prepare:
            prepare(mapper)
        errors = textures.observe_errors(mapper)
        scene = textures.Quad(mapper, 32)
        for _ in range(3):
            picture = scene.render()
            if quad is False:  # VTK does not ask actors without bounds to draw.
                mapper.Render(scene.renderer, scene.actor)
        self.assertEqual(len(errors), 1, errors)
        for word in words:
            self.assertIn(word, errors[0])
        self.assertEqual(picture.max(), 0)

    def test_mesh(self):
        texture = textures.make_texture()
        self.check_refused(["no mesh"], texture, False)
        quad = textures.make_quad()
        quad.GetPointData().SetTCoords(None)
        self.check_refused(["no texture coordinates"], texture, quad)
        line = vtkFloatArray()
        line.SetNumberOfTuples(4)
        line.Fill(0)
        quad.GetPointData().SetTCoords(line)
        self.check_refused(["1 component", "2"], texture, quad)

    def test_empty_mesh_is_nothing_to_draw(self):
        for mesh in vtkPolyData(), textures.make_quad():
            if mesh.GetNumberOfCells():
                mesh.GetPointData().SetTCoords(None)
                mesh.SetPolys(None)
            mapper = textures.make_mapper(textures.make_texture(), quad=mesh)
            errors = textures.observe_errors(mapper)
            self.assertEqual(textures.Quad(mapper).render().max(), 0)
            self.assertEqual(errors, [])

    def test_three_texture_coordinates(self):
        quad = textures.make_quad()
        flat = quad.GetPointData().GetTCoords()
        deep = vtkFloatArray()
        deep.SetNumberOfComponents(3)
        for point in range(4):
            deep.InsertNextTuple3(*flat.GetTuple2(point), 7)
        expected = textures.show(textures.make_texture())
        quad.GetPointData().SetTCoords(deep)
        mapper = textures.make_mapper(textures.make_texture(), quad=quad)
        np.testing.assert_array_equal(textures.Quad(mapper).render(), expected)

    def test_no_rank1_image(self):
        self.check_refused(["no texture", "rank-1"], None)
        self.check_refused(["rank-1 image"], textures.make_quad())
        self.check_refused(["rank-1 image"], vtkImageData())
        self.check_refused(["rank-1 image"], bravais.image_from_numpy(np.zeros((4, 4))))
        other = textures.make_texture()
        tag = vtkStringArray()
        tag.SetName("Lattice")
        tag.InsertNextValue("BCC")
        other.GetFieldData().AddArray(tag)
        self.check_refused(["rank-1 image"], other)
        self.check_refused(["0 blocks"], vtkMultiBlockDataSet())
        self.check_refused(["Block 1"], textures.make_pyramid([textures.make_texture(), None]))

    def test_marks_of_the_lattice(self):
        for change, words in (
                (lambda fields: fields.RemoveArray("Rank1.Generator"), ["Rank1.Generator"]),
                (lambda fields: fields.RemoveArray("Rank1.Domain"), ["Rank1.Domain"]),
                (lambda fields: fields.GetArray("Rank1.Generator").SetValue(0, 255), ["255"]),
                (lambda fields: fields.GetArray("Rank1.Generator").SetValue(1, 2), ["(2, 30)"]),
                (lambda fields: fields.GetArray("Rank1.Domain").SetValue(1, float("nan")),
                 ["nan"])):
            texture = textures.make_texture()
            change(texture.GetFieldData())
            self.check_refused(words, texture)

    def test_texels(self):
        texture = textures.make_texture()
        texture.GetPointData().Initialize()
        self.check_refused(["scalars"], texture)
        self.check_refused(["5 components"], textures.make_texture(components=5))
        for dtype, name in (np.int16, "short"), (np.int64, "long"), (np.int8, "char"):
            self.check_refused([name, "unsigned char"], textures.make_texture(dtype=dtype))

    def test_pyramids(self):
        base = textures.make_texture(256, (1, 30))
        self.check_refused(["65", "64"], textures.make_pyramid(
            [base, textures.make_texture(65, (1, 14))]))
        self.check_refused(["Block 1"], textures.make_pyramid(
            [base, textures.make_texture(64, (1, 14), 1)]))
        self.check_refused(["Block 1"], textures.make_pyramid(
            [base, textures.make_texture(64, (1, 14), dtype=np.float32)]))

    def test_more_texels_than_can_be(self):
        many = np.zeros(2 ** 24 + 1, np.uint8)
        self.check_refused(["16777217", "16777216"], bravais.rank1_from_numpy(many, (1, 4)))
        # Tiles that only pretend to hold texels: nobody looks at them.
        texture = bravais.rank1_from_numpy(np.zeros(2 ** 24, np.uint8), (1, 4))
        one = texture.GetPointData().GetScalars()
        more = one.NewInstance()
        count = 17 * 2 ** 24
        more.SetVoidArray(np.zeros(1, np.uint8), count, 1)
        texture.SetDimensions(2 ** 24, 17, 1)
        texture.GetPointData().SetScalars(more)
        self.check_refused([str(count), "texels"], texture)

    def test_unknown_modes(self):
        texture = textures.make_texture()
        for number in -1, 4:
            self.check_refused(["Interpolation", str(number)], texture,
                               prepare=lambda mapper: mapper.SetInterpolation(number))
        for number in -1, 2:
            self.check_refused(["LevelFilter", str(number)], texture,
                               prepare=lambda mapper: mapper.SetLevelFilter(number))
        mapper = bravais.vtkRank1TexturedPolyDataMapper()
        mapper.SetInterpolation(4)
        mapper.SetLevelFilter(-1)
        self.assertEqual(mapper.GetInterpolationAsString(), "Unknown")
        self.assertEqual(mapper.GetLevelFilterAsString(), "Unknown")

    def test_tiny_lattices_are_drawn(self):
        for n, generator in (1, (0, 0)), (2, (1, 1)), (3, (1, 2)):
            for mode in textures.MODES:
                color = 10, 200, 90
                texture = textures.make_constant(color, n=n, generator=generator)
                picture = textures.show(texture, mode)
                self.assertLessEqual(np.abs(picture - color).max(), 1)

    def test_nan_texels_leave_others_as_they_are(self):
        texture = textures.make_texture(256, (1, 30), 3, np.float32)
        expected = textures.show(texture, "Nearest")
        bravais.rank1_to_numpy(texture)[0][..., 5, :] = np.nan
        texture.GetPointData().GetScalars().Modified()
        differs = (textures.show(texture, "Nearest") != expected).any(-1)
        self.assertLess(differs.mean(), 2 / 256)

    def test_the_error_returns_when_something_changes(self):
        texture = textures.make_texture(components=5)
        mapper = textures.make_mapper(texture)
        errors = textures.observe_errors(mapper)
        scene = textures.Quad(mapper)
        scene.render()
        texture.Modified()
        scene.render()
        self.assertEqual(len(errors), 2)
        mapper.SetTextureData(textures.make_texture())
        self.assertGreater(scene.render().std(), 5)
        self.assertEqual(len(errors), 2)


if __name__ == "__main__":
    unittest.main()
