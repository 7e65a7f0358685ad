#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
"""A mesh, its geometry image in colours, and the surface that the image holds.

    GeometryImageOfMesh.py FOLDER [MESH | --debian NAME] [--dimensions WIDTH HEIGHT]

prints how far the two surfaces are apart, the root mean square of the distances from each to the
other, the larger of both, in percent and decibels of the diagonal, how many triangles the
parametrisation turns over, its stretch and its time, and writes geometry-image-NAME.png to FOLDER.
Without a mesh one is generated; --debian takes bunny (from the package glmark2-data), armadillo,
bull, fandisk, homer or man (libcgal-demo).
"""
import argparse
import math
import pathlib
import time

import numpy as np
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkFiltersCore import vtkPolyDataNormals
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper, vtkRenderer

import meshes
import pictures
from bravais import vtkGeometryImageToPolyData, vtkPolyDataToGeometryImage

SIDE = 300
LINES = 16  # gixels from one line of the grid to the next


def convert(mesh, dimensions, rounds):
    """The image, the surface that it holds, and what is to be said of it."""
    image = vtkPolyDataToGeometryImage()
    image.SetInputData(mesh)
    image.SetDimensions(dimensions)
    image.SetRounds(rounds)
    start = time.process_time()
    image.Update()
    seconds = time.process_time() - start
    if not image.GetOutput().GetNumberOfPoints():
        raise SystemExit(1)
    surface = vtkGeometryImageToPolyData()
    surface.SetInputConnection(image.GetOutputPort())
    surface.Update()
    text = (f"{image.GetNumberOfFlippedTriangles()} flipped, "
            f"stretch {image.GetStretch():.3f}, {seconds:.1f} s")
    return image.GetOutput(), surface.GetOutput(), text


def get_colors(image):
    """Positions in their box as red, green and blue, [row, column, RGB], the first row below."""
    points = vtk_to_numpy(image.GetPointData().GetVectors()).astype(float)
    low, high = points.min(axis=0), points.max(axis=0)
    colors = (points - low) / np.maximum(high - low, 1e-300) * 255
    return colors.round().astype(np.uint8).reshape(image.GetDimensions()[1::-1] + (3,))


def draw_lines(colors):
    """The same with lines of a grid."""
    lined = colors.copy()
    lined[::LINES] //= 2
    lined[:, ::LINES] //= 2
    return lined


def show(mesh, viewport, colors=None):
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(mesh)
    if colors is not None:
        array = numpy_to_vtk(colors.reshape(-1, 3), deep=True)
        array.SetName("colors")
        mesh.GetPointData().SetScalars(array)
    else:
        mapper.ScalarVisibilityOff()
    actor = vtkActor()
    actor.SetMapper(mapper)
    renderer = vtkRenderer()
    renderer.SetViewport(viewport)
    renderer.SetBackground(1, 1, 1)
    renderer.AddActor(actor)
    renderer.ResetCamera()
    renderer.GetActiveCamera().Azimuth(20)
    renderer.GetActiveCamera().Elevation(15)
    renderer.GetActiveCamera().Zoom(1.4)
    renderer.ResetCameraClippingRange()
    return renderer


def draw(mesh, image, surface):
    """The mesh, the image, and its surface, side by side."""
    smooth = vtkPolyDataNormals()
    smooth.SetInputData(mesh)
    smooth.SplittingOff()
    smooth.Update()
    colors = draw_lines(get_colors(image))
    row = pictures.render([show(smooth.GetOutput(), (0, 0, 0.5, 1)),
                           show(surface, (0.5, 0, 1, 1), colors)], (2 * SIDE, SIDE))
    height, width = colors.shape[:2]
    rows = (np.arange(SIDE) + 0.5) * height / SIDE
    columns = (np.arange(SIDE) + 0.5) * width / SIDE
    middle = colors[::-1][rows.astype(int)][:, columns.astype(int)]
    return np.concatenate([row[:, :SIDE], middle, row[:, SIDE:]], axis=1)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("mesh", nargs="?", type=pathlib.Path)
    parser.add_argument("--debian")
    parser.add_argument("--dimensions", nargs=2, type=int, default=(257, 257))
    parser.add_argument("--rounds", type=int, default=8)
    options = parser.parse_args()
    options.folder.mkdir(parents=True, exist_ok=True)
    path = options.mesh
    if options.debian:
        path = meshes.fetch(options.debian, options.folder / "data")
    mesh = meshes.read(path) if path else meshes.generate()
    image, surface, text = convert(mesh, options.dimensions, options.rounds)
    error = meshes.get_error(mesh, surface)
    name = path.stem if path else "generated"
    print(f"{name}: {mesh.GetNumberOfPoints()} points, {mesh.GetNumberOfPolys()} polygons; "
          f"{'%d x %d' % tuple(options.dimensions)} gixels: "
          f"RMS distance {100 * error:.4f} % of the diagonal, {-20 * math.log10(error):.1f} dB; "
          f"{text}")
    pictures.write(options.folder / f"geometry-image-{name}.png", draw(mesh, image, surface))


main()
