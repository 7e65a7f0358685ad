# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures are those of the CPU, vtkRank1ImageReconstruct and vtkRank1TextureSampler, within 1/255:
every interpolation and level filter, sizes, tiles, pyramids and r-sets, face on and receding."""
import unittest

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkDoubleArray

import bravais
import textures

# n, generator, tiles: powers of two and not, Korobov and not, tiny ones, one tile and several.
LATTICES = ((256, (1, 30), (1, 1)), (97, (5, 31), (1, 1)), (56, (4, 7), (3, 2)),
            (64, (1, 14), (2, 2)), (2048, (31, 39), (1, 1)), (3, (1, 2), (2, 1)),
            (1, (0, 0), (3, 3)))


def sample(texture, places, footprints=None, mode="Barycentric", level_filter="Trilinear"):
    """The CPU's values as colours from 0 to 255."""
    sampler = bravais.vtkRank1TextureSampler()
    sampler.SetInputData(texture)
    getattr(sampler, "SetInterpolationTo" + mode)()
    getattr(sampler, "SetLevelFilterTo" + level_filter)()
    shape = places.shape[:-1]
    uv = numpy_to_vtk(np.ascontiguousarray(places.reshape(-1, 2), float), deep=True)
    if footprints is None:
        footprints = np.zeros(shape + (4,))
    axes = numpy_to_vtk(np.ascontiguousarray(footprints.reshape(-1, 4), float), deep=True)
    values = vtkDoubleArray()
    sampler.Sample(uv, axes, values)
    return vtk_to_numpy(values).reshape(shape + (-1,))


def get_base(texture):
    return texture.GetBlock(0) if texture.IsA("vtkMultiBlockDataSet") else texture


def to_colors(values, dtype):
    """RGB from 0 to 255, of opaque texels, as a window has them."""
    colors = values * (255 / textures.ONE.get(np.dtype(dtype), 1))
    colors = colors[..., :3] if values.shape[-1] > 2 else colors[..., :1]
    return np.clip(colors, 0, 255) + np.zeros(3)


def is_near_tie(texture, places, reach):
    """Where a point is so near to a Voronoi cell's edge that another may be taken there."""
    values = sample(texture, places, mode="Nearest")
    near = np.zeros(values.shape[:-1], bool)
    for away in (reach, 0), (-reach, 0), (0, reach), (0, -reach):
        near |= (sample(texture, places + np.array(away), mode="Nearest") != values).any(-1)
    return near


class Perspective:
    """The unit square's plane, seen from above its front edge to far behind it, the texture many
    times on it: all sizes of footprints."""

    def __init__(self, mapper, size, repeats):
        quad = textures.make_quad()
        coordinates = quad.GetPointData().GetTCoords()
        for point in range(4):
            x, y, _ = quad.GetPoint(point)
            quad.GetPoints().SetPoint(point, 12 * x - 6, 12 * y, 0)
            coordinates.SetTuple2(point, repeats * 12 * x, repeats * 12 * y)
        mapper.SetInputData(quad)
        self.size = size
        self.repeats = repeats
        self.scene = textures.Quad(mapper, size)
        camera = self.scene.renderer.GetActiveCamera()
        camera.ParallelProjectionOff()
        camera.SetPosition(0.2, 1, 0.8)
        camera.SetFocalPoint(0, 2, 0)
        camera.SetViewUp(0, 0, 1)
        camera.SetViewAngle(50)
        camera.SetClippingRange(0.1, 30)
        self.camera = camera

    def find_places(self, offset):
        """(u, v) at pixels' centres moved by an offset, and where the plane is seen."""
        matrix = self.camera.GetCompositeProjectionTransformMatrix(1, -1, 1)
        entries = np.array([[matrix.GetElement(i, j) for j in range(4)] for i in range(4)])
        # Pixel and plane z = 0: three equations for x, y and w.
        inverse = np.linalg.inv(entries[[0, 1, 3]][:, [0, 1, 3]])
        centers = 2 * (np.arange(self.size) + 0.5) / self.size - 1
        x, y = np.meshgrid(centers + 2 * offset[0] / self.size, centers + 2 * offset[1] / self.size)
        place = np.stack([x, y, np.ones_like(x)], -1) @ inverse.T
        xy = place[..., :2] / place[..., 2:]
        seen = (place[..., 2] > 0) & (np.abs(xy[..., 0]) < 5.9) & (xy[..., 1] > 0.05) & \
            (xy[..., 1] < 11.9)
        return self.repeats * (xy + np.array([6, 0])), seen

    def find_footprints(self):
        """The differences that a GPU takes: inside squares of two by two pixels."""
        places, seen = self.find_places((0, 0))
        blocks = places.reshape(self.size // 2, 2, self.size // 2, 2, 2)
        footprints = np.empty(places.shape[:2] + (4,))
        rows = footprints.reshape(self.size // 2, 2, self.size // 2, 2, 4)
        rows[..., :2] = (blocks[:, :, :, 1] - blocks[:, :, :, 0])[:, :, :, None]
        rows[..., 2:] = (blocks[:, 1] - blocks[:, 0])[:, None]
        return places, footprints, seen


class TestRank1TexturedMapperLookUp(unittest.TestCase):
    def check(self, picture, expected, where=None, share=1.0):
        """Within 1/255, and the rounding to 8 bits."""
        difference = np.abs(picture - expected).max(-1)
        if where is not None:
            self.assertGreater(where.mean(), 0.5)
            difference = difference[where]
        self.assertGreaterEqual((difference <= 1.5).mean(), share, difference.max())
        self.assertLess(difference.mean(), 0.6)

    def test_face_on(self):
        for n, generator, tiles in LATTICES:
            for components, dtype in (3, np.uint8), (1, np.float32), (1, np.uint16):
                texture = textures.make_texture(n, generator, components, dtype, tiles)
                low, high = -0.3, 1.2
                places = textures.get_places(64, low, high)
                quad = textures.Quad(
                    textures.make_mapper(texture, quad=textures.make_quad(low, high)), 64)
                for mode in textures.MODES:
                    with self.subTest(n=n, tiles=tiles, dtype=dtype, mode=mode):
                        getattr(quad.mapper, "SetInterpolationTo" + mode)()
                        expected = to_colors(sample(texture, places, mode=mode), dtype)
                        where = ~is_near_tie(texture, places, 1e-6) if mode == "Nearest" else None
                        self.check(quad.render(), expected, where)

    def test_reconstructed_pictures(self):
        texture = textures.make_texture(1000, (1, 361), 3, domain=(0, 3, -1, 1))
        for mode in textures.MODES:
            reconstruct = bravais.vtkRank1ImageReconstruct()
            reconstruct.SetInputData(texture)
            reconstruct.SetOutputDimensions(96, 96)
            getattr(reconstruct, "SetInterpolationTo" + mode)()
            reconstruct.Update()
            expected = bravais.image_to_numpy(reconstruct.GetOutput())[0].astype(int)
            places = textures.get_places(96)
            where = ~is_near_tie(texture, places, 1e-6) if mode == "Nearest" else None
            self.check(textures.show(texture, mode), expected, where)

    def test_opacity_is_interpolated_too(self):
        texture = textures.make_texture(56, (4, 7), 4)
        values = sample(texture, textures.get_places(64))
        expected = values[..., :3] * values[..., 3:] / 255
        difference = np.abs(textures.show(texture, size=64) - expected)
        self.assertLess(difference.max(), 2.5)

    def test_half_precision(self):
        texture = textures.make_texture(256, (1, 30), 3, np.float64)
        mapper = textures.make_mapper(texture)
        mapper.HalfPrecisionOn()
        self.check(textures.Quad(mapper).render(),
                   to_colors(sample(texture, textures.get_places(96)), np.float64))

    def test_millions_of_texels(self):
        """Places of a few texels each, in the whole picture."""
        lattice = bravais.vtkRank1Lattice()
        for n in 2 ** 22, 2 ** 22 - 3:
            lattice.SetNumberOfPoints(n)
            lattice.MaximizeMinimumDistance()
            texture = textures.make_texture(n, lattice.GetGenerator(), 1)
            for mode in "Nearest", "Barycentric":
                for low in 0.0, 0.25 + 1 / 3, 0.9:
                    high = low + 2.0 ** -6
                    mapper = textures.make_mapper(texture, mode, textures.make_quad(low, high))
                    places = textures.get_places(64, low, high)
                    expected = to_colors(sample(texture, places, mode=mode), np.uint8)
                    # A float's rounding of a coordinate is up to a thousandth of a texel here.
                    where = ~is_near_tie(texture, places, 4e-7) if mode == "Nearest" else None
                    with self.subTest(n=n, mode=mode, low=low):
                        self.check(textures.Quad(mapper, 64).render(), expected, where)

    def make_smooth_picture(self):
        y, x = np.mgrid[0:64, 0:64] / 64
        picture = np.stack([np.sin(2 * np.pi * (3 * x + y)), np.cos(2 * np.pi * (x - 5 * y)),
                            np.sin(2 * np.pi * 7 * x) * np.sin(2 * np.pi * 6 * y)], -1)
        return bravais.image_from_numpy((127.5 + 127.4 * picture).astype(np.uint8), components=True)

    def make_pyramid(self, kind, n, tiles):
        pyramid = bravais.vtkRank1TexturePyramid()
        pyramid.SetInputData(self.make_smooth_picture())
        getattr(pyramid, "SetKindTo" + kind)()
        pyramid.SetNumberOfPoints(n)
        pyramid.SetTiles(tiles)
        pyramid.Update()
        return pyramid.GetOutput()

    def test_receding_plane(self):
        """Levels follow the footprint. Where rounding of the derivatives decides on a nearest
        level, either may be taken."""
        for kind, n, tiles in (("MipLevels", 4096, (1, 1)), ("MipLevels", 1000, (2, 1)),
                               ("RSet", 128, (8, 4))):
            texture = self.make_pyramid(kind, n, tiles)
            mapper = textures.make_mapper(texture)
            plane = Perspective(mapper, 96, 1.0)
            places, footprints, seen = plane.find_footprints()
            for level_filter in "NearestLevel", "Trilinear":
                getattr(mapper, "SetLevelFilterTo" + level_filter)()
                for mode in "Barycentric", "BoxSpline":
                    getattr(mapper, "SetInterpolationTo" + mode)()
                    expected = to_colors(
                        sample(texture, places, footprints, mode, level_filter), np.uint8)
                    share = 1.0 if level_filter == "Trilinear" else 0.998
                    with self.subTest(kind=kind, n=n, level_filter=level_filter, mode=mode):
                        self.check(plane.scene.render(), expected, seen, share)

    def test_levels_matter(self):
        """Far away the pyramid is the mean colour, the base alone is not."""
        texture = self.make_pyramid("MipLevels", 4096, (1, 1))
        far = textures.make_quad(0, 64)
        mean = bravais.rank1_to_numpy(texture.GetBlock(0))[0].mean((0, 1, 2))
        picture = textures.Quad(textures.make_mapper(texture, quad=far), 32).render()
        self.assertLess(np.abs(picture - mean).max(), 3)
        base = textures.Quad(textures.make_mapper(get_base(texture), quad=far), 33).render()
        self.assertGreater(np.abs(base - mean).max(), 30)


if __name__ == "__main__":
    unittest.main()
