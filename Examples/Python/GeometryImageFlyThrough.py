#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
"""Flies by a geometry image that is culled each frame, at three levels of detail.

Each row is a level. Left, seen from aside, the camera's frustum and what its locality mask leaves of
the model; in the middle, what the camera sees of that; right, the mask over the geometry image, whose
colours are the positions: what is masked is bright. --interactive plays it in a window; otherwise
the frames chosen become pictures.
"""
import argparse
import pathlib

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkFiltersSources import vtkFrustumSource
from vtkmodules.vtkCommonDataModel import vtkPlanes
from vtkmodules.vtkRenderingCore import (
    vtkActor, vtkImageActor, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow)
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401, draws

import bravais
import geometryimages
import pictures

LEVELS = 0, 2, 3


class Model:
    """A geometry image, its locality mask for a camera, and its surface at the levels."""

    def __init__(self, image, depth):
        self.image = image
        self.low, self.high = geometryimages.get_box(image)
        self.mask = bravais.vtkGeometryImageLocalityMask()
        self.mask.SetInputData(image)
        self.mask.SetMaximumDepth(depth)
        self.surfaces = []
        for level in LEVELS:
            surface = bravais.vtkGeometryImageToPolyData()
            surface.SetInputConnection(self.mask.GetOutputPort())
            surface.SetLevelOfDetail(level)
            self.surfaces.append(surface)

    def paint_mask(self, level):
        """Colours of the gixels of a level [row, column, RGB], dark and grey where not masked."""
        step = 2 ** level
        points = geometryimages.get_points(self.image)[::step, ::step]
        mask = geometryimages.get_mask(self.mask.GetOutput())
        rows, columns = (-(-n // step) * step for n in mask.shape)
        padded = np.zeros((rows, columns), np.uint8)
        padded[:mask.shape[0], :mask.shape[1]] = mask
        mask = padded.reshape(rows // step, step, columns // step, step).max(axis=(1, 3))
        colors = np.nan_to_num((points - self.low) / (self.high - self.low))
        grey = 0.12 + 0.2 * colors.mean(axis=2, keepdims=True)
        return (255 * np.where(mask[..., None], 0.25 + 0.75 * colors, grey)).astype(np.uint8)


class View:
    """The three panels of a level."""

    def __init__(self, model, row, camera):
        self.model, self.level = model, LEVELS[row]
        self.surface = model.surfaces[row]
        top = 1 - row / len(LEVELS)
        self.renderers = []
        for column in range(3):
            renderer = vtkRenderer()
            renderer.SetViewport(column / 3, top - 1 / len(LEVELS), (column + 1) / 3, top)
            renderer.SetBackground((0.16, 0.18, 0.22) if column else (0.1, 0.11, 0.14))
            self.renderers.append(renderer)
        actor = vtkActor()
        mapper = vtkPolyDataMapper()
        mapper.SetInputConnection(self.surface.GetOutputPort())
        mapper.ScalarVisibilityOff()
        actor.SetMapper(mapper)
        actor.GetProperty().SetColor(0.85, 0.75, 0.6)
        actor.GetProperty().SetInterpolationToFlat()
        self.renderers[0].AddActor(actor)
        self.renderers[1].AddActor(actor)
        self.renderers[1].SetActiveCamera(camera)
        self.planes = vtkPlanes()
        self.add_frustum()
        self.image = vtkImageActor()
        self.image.InterpolateOff()
        self.renderers[2].AddActor(self.image)

    def add_frustum(self):
        source = vtkFrustumSource()
        source.SetPlanes(self.planes)
        source.ShowLinesOff()
        mapper = vtkPolyDataMapper()
        mapper.SetInputConnection(source.GetOutputPort())
        frustum = vtkActor()
        frustum.SetMapper(mapper)
        frustum.GetProperty().SetRepresentationToWireframe()
        frustum.GetProperty().SetColor(1, 0.85, 0.2)
        frustum.GetProperty().SetLineWidth(1.5)
        frustum.GetProperty().LightingOff()
        self.frustum = source
        self.renderers[0].AddActor(frustum)

    def look_from_aside(self, flying):
        """From the right of the flying camera, and a little above it, at the model before it."""
        low, high = self.model.low, self.model.high
        center, radius = (low + high) / 2, np.linalg.norm(high - low) / 2
        position = np.array(flying.GetPosition())
        aside = np.cross(flying.GetDirectionOfProjection(), (0, 1, 0))
        focus = 0.6 * center + 0.4 * position
        camera = self.renderers[0].GetActiveCamera()
        camera.SetFocalPoint(focus)
        camera.SetPosition(focus + radius * (3.4 * aside + np.array((0, 1.6, 0))))
        camera.SetViewAngle(40)
        camera.SetClippingRange(0.5 * radius, 9 * radius)

    def update(self, flying, equations):
        self.look_from_aside(flying)
        self.planes.SetFrustumPlanes(equations)
        self.frustum.Modified()
        colors = self.model.paint_mask(self.level)
        picture = pictures.to_image(colors[::-1])
        self.image.SetInputData(picture)
        camera = self.renderers[2].GetActiveCamera()
        camera.ParallelProjectionOn()
        self.renderers[2].ResetCamera()
        camera.SetParallelScale(0.53 * max(colors.shape[:2]))


def fly(camera, share, low, high):
    """The camera at a share, 0 .. 1, of its way: round the front, at a changing distance."""
    center, radius = (low + high) / 2, np.linalg.norm(high - low) / 2
    turn = 2 * np.pi * share
    distance = radius * (1.6 - 0.6 * np.cos(turn))
    direction = np.array([np.cos(turn + 0.4), 0.3 + 0.2 * np.sin(2 * turn), np.sin(turn + 0.4)])
    camera.SetPosition(center + distance * direction / np.linalg.norm(direction))
    camera.SetFocalPoint(center + 0.35 * radius * np.array([-np.sin(turn), 0.5, np.cos(turn)]))
    camera.SetViewAngle(26)
    camera.SetClippingRange(0.15 * radius, 2.2 * radius)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("folder", type=pathlib.Path, help="where pictures go")
    parser.add_argument("model", nargs="?", type=pathlib.Path, help="geometry image or .obj mesh")
    parser.add_argument("--gixels", type=int, default=257, help="along each side")
    parser.add_argument("--depth", type=int, default=5, help="of the octree")
    parser.add_argument("--size", type=int, default=220, help="of each panel, in pixels")
    parser.add_argument("--frames", type=int, default=120, help="of the whole flight")
    parser.add_argument("--pictures", type=int, nargs="*", default=[12], help="frames to keep")
    parser.add_argument("--interactive", action="store_true", help="play it in a window")
    options = parser.parse_args()
    options.folder.mkdir(parents=True, exist_ok=True)
    image = (geometryimages.read(options.model, options.gixels) if options.model
             else geometryimages.make("BumpySphere", options.gixels, options.gixels))
    model = Model(image, options.depth)
    window = vtkRenderWindow()
    window.SetOffScreenRendering(not options.interactive)
    window.SetMultiSamples(0)
    window.SetSize(3 * options.size, len(LEVELS) * options.size)
    camera = vtkRenderer().MakeCamera()
    model.mask.SetCamera(camera)
    views = [View(model, row, camera) for row in range(len(LEVELS))]
    for renderer in (renderer for view in views for renderer in view.renderers):
        window.AddRenderer(renderer)
    for frame in range(options.frames) if options.interactive else options.pictures:
        fly(camera, frame / options.frames, model.low, model.high)
        equations = [0.0] * 24
        camera.GetFrustumPlanes(1.0, equations)
        model.mask.Update()
        for view in views:
            view.update(camera, equations)
        window.Render()
        masked = geometryimages.get_mask(model.mask.GetOutput()).mean()
        triangles = [view.surface.GetOutput().GetNumberOfPolys() for view in views]
        print(f"frame {frame}: {model.mask.GetNumberOfVisibleLeaves()} of "
              f"{model.mask.GetNumberOfLeaves()} leaves, {100 * masked:.1f} % of the gixels, "
              f"{' / '.join(map(str, triangles))} triangles")
        if frame in options.pictures:
            name = f"geometry-image-fly-through-{frame}.png"
            pictures.write(options.folder / name, pictures.capture(window))


main()
