#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
"""Lattices of 56 points with their Voronoi cells: the square one, rank-1 ones, the hexagonal one.

    Rank1Lattices.py FOLDER [--points N] [--generators G1,G2 ...]

writes rank1-lattices.png to FOLDER and prints the lattices' sampling efficiencies: figure 3 of
Dammertz, Dammertz, Keller and Lensch, Textures on Rank-1 Lattices. For another number of points the
last of the rank-1 lattices is the one of largest minimum distance.
"""
import argparse
import math
import pathlib

import numpy as np
import vtkmodules.vtkRenderingFreeType
import vtkmodules.vtkRenderingOpenGL2
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper, vtkRenderer, vtkTextActor

import bravais
import pictures

PANEL, GAP, TITLE = 150, 14, 44
FIGURE = "3,11", "1,9", "1,21", "4,7"


def make_cells(n, generator):
    """Voronoi cells of a rank-1 lattice, cut at the unit square, and its points."""
    cells = bravais.vtkRank1ImageToPolyData()
    cells.SetInputData(bravais.rank1_from_numpy(np.arange(n, dtype=float), generator))
    cells.SetShapeToVoronoiCells()
    cells.Update()
    return cells.GetOutput(), np.outer(np.arange(n), generator) % n / n


def repeat_cell(corners, first, second):
    """A cell at all points of a plane lattice round the unit square, and these."""
    steps = np.arange(-30, 31)
    places = (steps[:, None, None] * first + steps[None, :, None] * second).reshape(-1, 2)
    places = places[(np.abs(places - 0.5) < 0.7).all(-1)]
    points = vtkPoints()
    polygons = vtkCellArray()
    for place in places:
        polygons.InsertNextCell(len(corners))
        for corner in corners:
            polygons.InsertCellPoint(points.InsertNextPoint(*(place + corner), 0))
    data = vtkPolyData()
    data.SetPoints(points)
    data.SetPolys(polygons)
    return data, places


def make_plane_lattice(n, sides):
    """The square or hexagonal lattice of n points on a unit of area."""
    distance = math.sqrt(1 / n if sides == 4 else 2 / math.sqrt(3) / n)
    turn = 2 * math.pi / sides
    radius = distance / 2 / math.cos(turn / 2)
    angles = turn * (np.arange(sides) + 0.5)
    corners = radius * np.stack([np.cos(angles), np.sin(angles)], -1)
    return repeat_cell(corners, distance * np.array([1, 0]),
                       distance * np.array([math.cos(turn), math.sin(turn)]))


def make_points(places):
    data = vtkPolyData()
    points = vtkPoints()
    vertices = vtkCellArray()
    for place in places:
        vertices.InsertNextCell(1)
        vertices.InsertCellPoint(points.InsertNextPoint(*place, 0.1))
    data.SetPoints(points)
    data.SetVerts(vertices)
    return data


def add_actor(renderer, data, color, **properties):
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(data)
    mapper.ScalarVisibilityOff()
    actor = vtkActor()
    actor.SetMapper(mapper)
    look = actor.GetProperty()
    look.SetColor(color)
    look.LightingOff()
    for name, value in properties.items():
        getattr(look, "Set" + name)(value)
    renderer.AddActor(actor)


def draw_panel(left, size, cells, places):
    """A renderer that shows exactly the unit square."""
    renderer = vtkRenderer()
    renderer.SetViewport(left / size[0], TITLE / size[1], (left + PANEL) / size[0],
                         (TITLE + PANEL) / size[1])
    renderer.SetBackground(1, 1, 1)
    add_actor(renderer, cells, (0.86, 0.91, 0.97), EdgeVisibility=True,
              EdgeColor=(0.25, 0.35, 0.5))
    add_actor(renderer, make_points(places), (0.75, 0.2, 0.1), PointSize=4)
    camera = renderer.GetActiveCamera()
    camera.ParallelProjectionOn()
    camera.SetParallelScale(0.5)
    camera.SetFocalPoint(0.5, 0.5, 0)
    camera.SetPosition(0.5, 0.5, 1)
    renderer.ResetCameraClippingRange()
    return renderer


def write_title(renderer, left, text):
    title = vtkTextActor()
    title.SetInput(text)
    title.SetPosition(left + PANEL / 2, TITLE - 4)
    title.GetTextProperty().SetJustificationToCentered()
    title.GetTextProperty().SetVerticalJustificationToTop()
    title.GetTextProperty().SetFontSize(14)
    title.GetTextProperty().SetLineSpacing(1.2)
    title.GetTextProperty().SetColor(0, 0, 0)
    renderer.AddViewProp(title)


def find_lattices(n, generators):
    """(name, efficiency, cells, points), as in the picture from left to right."""
    lattices = [("square", math.pi / 4, *make_plane_lattice(n, 4))]
    lattice = bravais.vtkRank1Lattice()
    lattice.SetNumberOfPoints(n)
    for text in generators:
        generator = tuple(int(number) for number in text.split(","))
        lattice.SetGenerator(*generator)
        lattices.append((f"g = ({generator[0]}, {generator[1]})",
                         lattice.GetSamplingEfficiency(), *make_cells(n, generator)))
    lattices.append(("hexagonal", math.pi / math.sqrt(12), *make_plane_lattice(n, 6)))
    return lattices


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--points", type=int, default=56)
    parser.add_argument("--generators", nargs="+")
    options = parser.parse_args()
    options.folder.mkdir(parents=True, exist_ok=True)
    generators = options.generators
    if not generators and options.points == 56:
        generators = FIGURE
    elif not generators:
        best = bravais.vtkRank1Lattice()
        best.SetNumberOfPoints(options.points)
        best.MaximizeMinimumDistance()
        generators = "1,1", "{},{}".format(*best.GetGenerator())
    lattices = find_lattices(options.points, generators)
    size = len(lattices) * (PANEL + GAP) + GAP, PANEL + TITLE + GAP
    frame = vtkRenderer()
    frame.SetBackground(1, 1, 1)
    renderers = [frame]
    for number, (name, efficiency, cells, places) in enumerate(lattices):
        left = GAP + number * (PANEL + GAP)
        renderers.append(draw_panel(left, size, cells, places))
        write_title(frame, left, f"{name}\n{100 * efficiency:.1f} %")
        print(f"{name:14} sampling efficiency {100 * efficiency:.1f} %")
    pictures.write(options.folder / "rank1-lattices.png", pictures.render(renderers, size))


main()
