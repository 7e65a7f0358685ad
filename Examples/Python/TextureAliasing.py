#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
"""Aliasing of minified textures: a zone plate, and a checkered plane that recedes.

    TextureAliasing.py FOLDER [--size PIXELS] [--texture TEXELS]

writes texture-aliasing.png. Its columns are point sampled, supersampled by 4 x 4, the nearest mip
level, trilinear; its rows are the zone plate by a square texture, by a rank-1 texture of as many
texels, and the plane by both. Prints root mean square differences from 16 x 16 samples a pixel of
the square texture, in grey values.
"""
import argparse
import pathlib

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkDoubleArray

import pictures
from bravais import vtkRank1TexturePyramid, vtkRank1TextureSampler

METHODS = "point sampled", "supersampled", "mip level", "trilinear"


class SquareTexture:
    def __init__(self, texture):
        self.levels = [texture]
        while self.levels[-1].shape[0] > 1:
            v = self.levels[-1]
            self.levels.append((v[::2, ::2] + v[1::2, ::2] + v[::2, 1::2] + v[1::2, 1::2]) / 4)

    def look_up(self, uv, level):
        """Bilinear, of a level for each point."""
        result = np.zeros(len(uv))
        for number in np.unique(level):
            v, chosen = self.levels[number], level == number
            p = uv[chosen] * v.shape[0] - 0.5
            i = np.floor(p).astype(int)
            (x, y), (f, g) = i.T, (p - i).T
            n = v.shape[0]
            below = (1 - f) * v[y % n, x % n] + f * v[y % n, (x + 1) % n]
            above = (1 - f) * v[(y + 1) % n, x % n] + f * v[(y + 1) % n, (x + 1) % n]
            result[chosen] = (1 - g) * below + g * above
        return result

    def sample(self, uv, footprints, trilinear):
        d = footprints.reshape(-1, 2, 2) * self.levels[0].shape[0]
        length = np.sqrt((d ** 2).sum(2)).max(1)
        top = len(self.levels) - 1
        level = np.clip(np.log2(np.maximum(length, 1e-9)), 0, top)
        if not trilinear:
            return self.look_up(uv, np.ceil(level - 0.5).astype(int))
        lower = np.minimum(level.astype(int), top - 1)
        share = level - lower
        return (1 - share) * self.look_up(uv, lower) + share * self.look_up(uv, lower + 1)


class Rank1Texture:
    def __init__(self, texture):
        self.pyramid = vtkRank1TexturePyramid()
        self.pyramid.SetInputData(pictures.to_image(texture[::-1]))
        self.sampler = vtkRank1TextureSampler()
        self.sampler.SetInputConnection(self.pyramid.GetOutputPort())

    def sample(self, uv, footprints, trilinear):
        self.sampler.SetLevelFilter(int(trilinear))
        values = vtkDoubleArray()
        self.sampler.Sample(numpy_to_vtk(np.ascontiguousarray(uv)),
                            numpy_to_vtk(np.ascontiguousarray(footprints)), values)
        return vtk_to_numpy(values).copy()


def zone_plate(x, y):
    return np.stack((x, y), -1)


def receding_plane(x, y):
    depth = 0.6 / (1.03 - y)  # the horizon is above the picture
    return np.stack((0.5 + (x - 0.5) * depth, 0.5 * depth), -1)


def draw(texture, scene, size, samples, method):
    """Mean of so many samples along each side of a pixel."""
    place = (np.arange(size * samples) + 0.5) / (size * samples)
    x, y = np.meshgrid(place, place)
    uv = scene(x, y).reshape(-1, 2)
    footprints = np.zeros((len(uv), 4))
    if method in METHODS[2:]:
        step = 0.5 / size
        footprints[:, :2] = (scene(x + step, y) - scene(x - step, y)).reshape(-1, 2)
        footprints[:, 2:] = (scene(x, y + step) - scene(x, y - step)).reshape(-1, 2)
    values = texture.sample(uv, footprints, method == "trilinear")
    return values.reshape(size, samples, size, samples).mean(axis=(1, 3))


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--size", type=int, default=150)
    parser.add_argument("--texture", type=int, default=512)
    options = parser.parse_args()
    options.folder.mkdir(parents=True, exist_ok=True)
    n = options.texture
    x, y = np.meshgrid(*[np.arange(n) + 0.5 - n / 2] * 2)
    textures = {zone_plate: 127.5 + 127.5 * np.cos(np.pi * (x * x + y * y) / n),
                receding_plane: 255.0 * ((x // (n / 16) + y // (n / 16)) % 2)}
    rows = []
    for scene, values in textures.items():
        square = SquareTexture(values)
        reference = draw(square, scene, options.size, 16, "supersampled")
        for name, texture in ("square", square), ("rank-1", Rank1Texture(values)):
            drawn = [draw(texture, scene, options.size, 4 if m == "supersampled" else 1, m)
                     for m in METHODS]
            rows.append(np.hstack([d[::-1] for d in drawn]))
            errors = ", ".join(f"{m} {np.sqrt(((d - reference) ** 2).mean()):.2f}"
                               for m, d in zip(METHODS, drawn))
            print(f"{scene.__name__} {name}: {errors}")
    picture = np.clip(np.vstack(rows) + 0.5, 0, 255).astype(np.uint8)
    pictures.write(options.folder / "texture-aliasing.png", picture)


if __name__ == "__main__":
    main()
