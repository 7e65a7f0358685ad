# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
"""Texels are put on the GPU when they must be, and pictures outlive windows."""
import unittest

import numpy as np
from vtkmodules.vtkCommonExecutionModel import vtkTrivialProducer
from vtkmodules.vtkRenderingCore import vtkRenderer

import bravais
import scenes
import textures


class TestRank1TexturedMapperResources(unittest.TestCase):
    def setUp(self):
        self.texture = textures.make_texture()
        self.mapper = textures.make_mapper(self.texture)
        self.quad = textures.Quad(self.mapper)

    def same(self, first, second):
        np.testing.assert_array_equal(first, second)

    def test_texels_are_kept_until_they_or_their_precision_change(self):
        self.assertEqual(self.mapper.GetTexelTime(), 0)
        self.quad.render()
        time = self.mapper.GetTexelTime()
        self.assertGreater(time, 0)

        # What has nothing to do with them.
        self.mapper.SetInterpolationToBoxSpline()
        self.mapper.SetLevelFilterToNearestLevel()
        self.quad.actor.SetPosition(0.1, 0, 0)
        self.quad.actor.GetProperty().SetColor(1, 0, 0)
        self.quad.window.SetSize(80, 70)
        self.mapper.SetInputData(textures.make_quad(0, 2))
        self.quad.render()
        self.assertEqual(self.mapper.GetTexelTime(), time)

        other = textures.make_texture(seed=2)
        for change in (self.texture.Modified, self.texture.GetPointData().GetScalars().Modified,
                       lambda: self.texture.GetFieldData().GetArray("Rank1.Generator").Modified(),
                       self.mapper.HalfPrecisionOn, lambda: self.mapper.SetTextureData(other),
                       lambda: self.mapper.SetTextureData(self.texture)):
            change()
            self.quad.render()
            self.assertGreater(self.mapper.GetTexelTime(), time)
            time = self.mapper.GetTexelTime()
            self.quad.render()
            self.assertEqual(self.mapper.GetTexelTime(), time)

    def test_changed_texels_are_shown(self):
        first = self.quad.render()
        values = bravais.rank1_to_numpy(self.texture)[0]
        values[:] = 255 - values
        self.texture.GetPointData().GetScalars().Modified()
        self.assertLessEqual(np.abs(255 - self.quad.render() - first).max(), 1)

    def test_textures_of_other_sizes_types_components_and_levels(self):
        """Each is drawn as by a mapper of its own."""
        small = textures.make_texture(64, (1, 14))
        for texture in (textures.make_texture(97, (5, 31), 1),
                        textures.make_texture(97, (5, 31), 4),
                        textures.make_texture(20000, (1, 137), 3, np.float32),
                        textures.make_texture(64, (1, 14), 2, np.uint16, (3, 2)),
                        textures.make_pyramid([self.texture, small]), self.texture):
            self.mapper.SetTextureData(texture)
            self.same(self.quad.render(), textures.show(texture))

    def test_a_changed_level_is_shown(self):
        small = textures.make_texture(64, (1, 14))
        self.mapper.SetTextureData(textures.make_pyramid([self.texture, small]))
        self.mapper.SetInputData(textures.make_quad(0, 16))
        self.quad.render()
        bravais.rank1_to_numpy(small)[0][:] = 77
        small.GetPointData().GetScalars().Modified()
        self.same(self.quad.render(), np.full((96, 96, 3), 77))

    def test_a_connection(self):
        producer = vtkTrivialProducer()
        producer.SetOutput(self.texture)
        first = self.quad.render()
        for connect in (self.mapper.SetTextureConnection,
                        lambda port: self.mapper.SetInputConnection(1, port)):
            self.mapper.SetTextureData(None)
            self.assertIsNone(self.mapper.GetTextureData())
            connect(producer.GetOutputPort())
            self.assertIs(self.mapper.GetTextureData(), self.texture)
            self.same(self.quad.render(), first)

    def test_released_window_shows_the_same_again(self):
        first = self.quad.render()
        for release in (lambda: self.quad.actor.ReleaseGraphicsResources(self.quad.window),
                        self.quad.window.Finalize):
            time = self.mapper.GetTexelTime()
            release()
            self.same(self.quad.render(), first)
            self.assertGreater(self.mapper.GetTexelTime(), time)

    def test_one_mapper_in_two_windows(self):
        first = self.quad.render()
        other = scenes.make_window(96, 96)
        renderer = vtkRenderer()
        renderer.AddActor(self.quad.actor)
        renderer.SetActiveCamera(self.quad.renderer.GetActiveCamera())
        other.AddRenderer(renderer)
        for _ in range(2):
            other.Render()
            self.same(scenes.get_picture(other), first)
            self.same(self.quad.render(), first)

    def test_a_mapper_goes_before_its_window(self):
        self.quad.render()
        self.quad.renderer.RemoveActor(self.quad.actor)
        self.quad.actor = self.quad.mapper = self.mapper = None
        self.same(self.quad.render(), np.zeros((96, 96, 3)))

    def test_a_mapper_outlives_its_window(self):
        first = self.quad.render()
        self.quad = None
        self.same(textures.Quad(self.mapper).render(), first)


if __name__ == "__main__":
    unittest.main()
