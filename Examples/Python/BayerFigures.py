#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
"""The pictures and figures of Documentation/bayer.md.

    BayerFigures.py FOLDER

writes bayer-square.png, bayer-slices.png and bayer-cells.png to FOLDER and prints the figures.
"""
import argparse
import pathlib

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkIdTypeArray
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkFiltersCore import vtkCellCenters
from vtkmodules.vtkFiltersSources import vtkCubeSource
from vtkmodules.vtkRenderingCore import (
    vtkActor, vtkActor2D, vtkDataSetMapper, vtkPolyDataMapper, vtkRenderer)
from vtkmodules.vtkRenderingLabel import vtkLabeledDataMapper

import pictures
from bravais import vtkBayerPattern

COLORS = (0.85, 0.35, 0.2), (0.2, 0.5, 0.8), (0.95, 0.75, 0.2), (0.3, 0.65, 0.4)


def get(method, *arguments, array=vtkIdTypeArray):
    values = array()
    method(*arguments, values)
    return vtk_to_numpy(values).copy()


def make_patterns():
    for base_order in vtkBayerPattern.FCC, vtkBayerPattern.BCC:
        pattern = vtkBayerPattern()
        pattern.SetBaseOrder(base_order)
        yield pattern


def make_renderer(column, row, columns, rows):
    renderer = vtkRenderer()
    renderer.SetViewport(column / columns, 1 - (row + 1) / rows, (column + 1) / columns,
                         1 - row / rows)
    renderer.SetBackground(1, 1, 1)
    renderer.GetActiveCamera().ParallelProjectionOn()
    return renderer


def draw_square(renderer, ranks, cells):
    """Numbered squares, dark to light by rank, the first row at the top."""
    side = len(ranks)
    image = vtkImageData()
    image.SetDimensions(side + 1, side + 1, 1)
    values = numpy_to_vtk(np.ascontiguousarray(ranks[::-1]).ravel(), deep=True)
    values.SetName("rank")
    image.GetCellData().SetScalars(values)
    mapper = vtkDataSetMapper()
    mapper.SetInputData(image)
    mapper.SetScalarRange(-0.8 * cells, cells - 1)
    table = mapper.GetLookupTable()
    table.SetSaturationRange(0, 0)
    table.SetValueRange(0, 1)
    table.Build()
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().EdgeVisibilityOn()
    actor.GetProperty().SetEdgeColor(0.5, 0.5, 0.5)
    actor.GetProperty().LightingOff()
    renderer.AddActor(actor)
    centers = vtkCellCenters()
    centers.SetInputData(image)
    labels = vtkLabeledDataMapper()
    labels.SetInputConnection(centers.GetOutputPort())
    labels.SetLabelModeToLabelScalars()
    labels.SetLabelFormat("%d")
    text = labels.GetLabelTextProperty()
    text.SetFontSize(14)
    text.ItalicOff()
    text.ShadowOff()
    text.BoldOff()
    text.SetColor(0, 0, 0)
    text.SetJustificationToCentered()
    text.SetVerticalJustificationToCentered()
    actor2d = vtkActor2D()
    actor2d.SetMapper(labels)
    renderer.AddActor2D(actor2d)
    renderer.ResetCamera()
    renderer.GetActiveCamera().SetParallelScale(0.53 * side)


def add_cube(renderer, corner, edge, color, wire=False):
    cube = vtkCubeSource()
    cube.SetBounds(*(c + e for c in corner for e in (0, edge)))
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(cube.GetOutputPort())
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(color)
    if wire:
        actor.GetProperty().SetRepresentationToWireframe()
        actor.GetProperty().LightingOff()
    else:
        actor.GetProperty().EdgeVisibilityOn()
        actor.GetProperty().SetAmbient(0.35)
        actor.GetProperty().SetDiffuse(0.7)
    renderer.AddActor(actor)


def draw_cells(renderer, order, count, side):
    """The first cells of the order in the cube's outline, a colour each pair."""
    add_cube(renderer, (0, 0, 0), side, (0.4, 0.4, 0.4), wire=True)
    for rank, cell in enumerate(order[:count]):
        corner = cell % side, cell // side % side, cell // side ** 2
        add_cube(renderer, corner, 1, COLORS[rank // 2 % len(COLORS)])
    camera = renderer.GetActiveCamera()
    camera.SetPosition(-2.2, -4, 2)
    camera.SetViewUp(0, 0, 1)
    renderer.ResetCamera()
    camera.Zoom(1.05)


def make_square_picture():
    renderers = []
    for column, log2_size in enumerate((1, 2, 3)):
        side = 2 ** log2_size
        renderers.append(make_renderer(column, 0, 3, 1))
        ranks = get(vtkBayerPattern().GetThresholds, 2, log2_size).reshape(side, side)
        draw_square(renderers[-1], ranks, side ** 2)
    return pictures.render(renderers, (780, 260))


def make_slices_picture():
    renderers = []
    for row, pattern in enumerate(make_patterns()):
        for column, ranks in enumerate(get(pattern.GetThresholds, 3, 2).reshape(4, 4, 4)):
            renderers.append(make_renderer(column, row, 4, 2))
            draw_square(renderers[-1], ranks, 64)
    return pictures.render(renderers, (800, 400))


def make_cells_picture():
    renderers = []
    for row, pattern in enumerate(make_patterns()):
        for column, count in enumerate((1, 2, 4, 8)):
            renderers.append(make_renderer(column, row, 4, 2))
            draw_cells(renderers[-1], get(pattern.GetOrder, 3, 2), count, 4)
    return pictures.render(renderers, (800, 440))


def print_distances(pattern, log2_size):
    distances = get(pattern.GetMinimumDistances, 3, log2_size, array=vtkDoubleArray)
    first = " ".join(f"{d:.3f}" for d in distances[[1, 2, 3, 4, 7]])
    print(f"{pattern.GetBaseOrderAsString()}: smallest distance of the first 2, 3, 4, 5, 8 cells: "
          f"{first}; mean of all prefixes {distances.mean():.3f}")


def print_power(pattern, log2_size):
    """Where in frequency the power of all prefixes lies."""
    side = 2 ** log2_size
    waves = np.minimum(np.arange(side), side - np.arange(side))
    x, y, z = np.meshgrid(waves, waves, waves)
    power = sum(
        get(pattern.GetPowerSpectrum, 3, log2_size, m, array=vtkDoubleArray)
        for m in range(1, side ** 3)).reshape(side, side, side)
    highest = np.stack([x, y, z]) == side // 2
    harmonic = (highest | (np.stack([x, y, z]) == 0)).all(axis=0)
    shortest = [harmonic & (highest.sum(axis=0) == axes) for axes in (1, 2, 3)]
    sums = np.array([power[kind].sum() for kind in shortest])
    print("     power at the shortest waves along axes, face and space diagonals (%):",
          (100 * sums / sums.sum()).round(1))
    radius = np.sqrt(x * x + y * y + z * z)
    shares = [100 * power[radius <= limit].sum() / power.sum() for limit in (1, 2, 4)]
    print("     power of up to 1, 2, 4 waves a side (%):", " ".join(f"{s:.3f}" for s in shares))


def print_errors(name, ranks):
    """Of constants at two levels: root mean square over all constants and cells."""
    cells = ranks.size
    angle = 2 * np.pi * np.fft.fftfreq(len(ranks))
    squares = sum(np.meshgrid(*[angle ** 2] * 3))
    sums = np.zeros(5)
    for m in range(1, cells):
        error = (ranks < m) - m / cells
        spectrum = np.fft.fftn(error)
        for place, deviation in enumerate((0.5, 1)):
            blurred = np.abs(spectrum * np.exp(-squares * deviation ** 2 / 2)) ** 2
            sums[place] += blurred.mean() / cells
        sums[2:] += [(error.mean(axis=axis) ** 2).mean() for axis in (2, 1, 0)]
    print(f"{name:6} errors blurred by 0.5, 1 cells, and averaged along x, y, z:",
          np.sqrt(sums / (cells - 1)).round(4))


def print_figures(log2_size=3):
    side = 2 ** log2_size
    shape = side, side, side
    ranks = {}
    for pattern in make_patterns():
        print_distances(pattern, log2_size)
        print_power(pattern, log2_size)
        name = pattern.GetBaseOrderAsString()
        ranks[name] = get(pattern.GetThresholds, 3, log2_size).reshape(shape)
    square = get(vtkBayerPattern().GetThresholds, 2, log2_size).reshape(side, side)
    ranks["square"] = side * np.broadcast_to(square, shape)
    ranks["random"] = np.random.default_rng(0).permutation(side ** 3).reshape(shape)
    for name, pattern in ranks.items():
        print_errors(name, pattern)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("folder", type=pathlib.Path)
    folder = parser.parse_args().folder
    folder.mkdir(parents=True, exist_ok=True)
    for name, make in (("square", make_square_picture), ("slices", make_slices_picture),
                       ("cells", make_cells_picture)):
        pictures.write(folder / f"bayer-{name}.png", make())
    print_figures()


main()
