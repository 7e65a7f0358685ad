# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
"""Rank-1 textures on quads, for tests of vtkRank1TexturedPolyDataMapper."""
import numpy as np
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet
from vtkmodules.vtkFiltersSources import vtkPlaneSource
from vtkmodules.vtkRenderingCore import vtkActor, vtkRenderer

import bravais
import scenes

MODES = "Nearest", "Bilinear", "Barycentric", "BoxSpline"
ONE = {np.dtype(np.uint8): 255, np.dtype(np.uint16): 65535}


def make_texture(n=256, generator=(1, 30), components=3, dtype=np.uint8, tiles=(1, 1),
                 domain=(0, 1, 0, 1), seed=1):
    """A rank-1 image of random colours."""
    values = np.random.default_rng(seed).random((tiles[1], tiles[0], n, components))
    values = (values * ONE.get(np.dtype(dtype), 1)).astype(dtype)
    return bravais.rank1_from_numpy(values, generator, domain)


def make_constant(color, dtype=np.uint8, n=8, generator=(1, 3)):
    values = np.tile(np.array(color, dtype), (n, 1))
    return bravais.rank1_from_numpy(values, generator)


def make_pyramid(images):
    blocks = vtkMultiBlockDataSet()
    for number, image in enumerate(images):
        blocks.SetBlock(number, image)
    return blocks


def make_quad(low=0.0, high=1.0):
    """The unit square, with texture coordinates from `low` to `high`."""
    source = vtkPlaneSource()
    source.SetOrigin(0, 0, 0)
    source.SetPoint1(1, 0, 0)
    source.SetPoint2(0, 1, 0)
    source.Update()
    quad = source.GetOutput()
    coordinates = quad.GetPointData().GetTCoords()
    for point in range(4):
        x, y, _ = quad.GetPoint(point)
        coordinates.SetTuple2(point, low + (high - low) * x, low + (high - low) * y)
    return quad


class Quad:
    """A mapper's quad that fills a window exactly, without lights unless asked for."""

    def __init__(self, mapper, size=96, lighting=False, background=(0, 0, 0)):
        self.mapper = mapper
        self.actor = vtkActor()
        self.actor.SetMapper(mapper)
        self.actor.GetProperty().SetLighting(lighting)
        self.renderer = vtkRenderer()
        self.renderer.SetBackground(background)
        self.renderer.AddActor(self.actor)
        self.window = scenes.make_window(size, size)
        self.window.AddRenderer(self.renderer)
        camera = self.renderer.GetActiveCamera()
        camera.ParallelProjectionOn()
        camera.SetParallelScale(0.5)
        camera.SetPosition(0.5, 0.5, 2)
        camera.SetFocalPoint(0.5, 0.5, 0)
        camera.SetClippingRange(1, 3)

    def render(self):
        """The picture, [row from below, column, RGB], as numbers from 0 to 255."""
        self.window.Render()
        return scenes.get_picture(self.window)


def make_mapper(texture, mode="Barycentric", quad=None):
    mapper = bravais.vtkRank1TexturedPolyDataMapper()
    mapper.SetInputData(quad or make_quad())
    mapper.SetTextureData(texture)
    getattr(mapper, "SetInterpolationTo" + mode)()
    return mapper


def show(texture, mode="Barycentric", size=96, **options):
    return Quad(make_mapper(texture, mode), size, **options).render()


def get_places(size, low=0.0, high=1.0):
    """(u, v) of the pixels' centres, [row from below, column, 2]."""
    centers = low + (high - low) * (np.arange(size) + 0.5) / size
    return np.stack(np.meshgrid(centers, centers), -1)


def observe_errors(mapper):
    """A list that gets the mapper's errors."""
    errors = []

    def observe(caller, event, text):
        errors.append(text)
    observe.CallDataType = "string0"
    mapper.AddObserver("ErrorEvent", observe)
    return errors
