#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
"""A viewing session, culled frame by frame, as in the paper's Fig. 3.

A camera comes near, goes round and passes close by a surface in 1090 frames. Prints, and plots with
vtkChartXY: the time of culling alone and with the union of the masks, by frame and by the number of
visible leaves; and the bytes that would be sent as compressed masks, leaf by leaf or united, beside
those of an index list of the same triangles. Each frame's time is the best of several.
"""
import argparse
import math
import pathlib

import numpy as np
from vtkmodules.vtkChartsCore import vtkAxis, vtkChart, vtkChartLegend, vtkChartXY
from vtkmodules.vtkCommonCore import vtkDoubleArray
from vtkmodules.vtkCommonDataModel import vtkTable
from vtkmodules.vtkRenderingCore import vtkCamera, vtkRenderer
from vtkmodules.vtkRenderingContext2D import vtkContextActor
import vtkmodules.vtkRenderingContextOpenGL2  # noqa: F401, draws charts
import vtkmodules.vtkRenderingFreeType  # noqa: F401, draws their text
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401, draws

import bravais
import geometryimages
import pictures

COLORS = (204, 51, 26, 255), (26, 77, 179, 255), (26, 153, 51, 255)


def place_camera(camera, share, low, high):
    """At a share, 0 .. 1, of the session round a box."""
    center, radius = (low + high) / 2, np.linalg.norm(high - low) / 2
    turn = 2 * math.pi * share
    distance = radius * (1.7 + 1.5 * math.cos(2 * turn) * (1 - 0.3 * math.sin(turn)))
    direction = np.array([math.cos(turn), 0.4 * math.sin(3 * turn), math.sin(turn)])
    camera.SetPosition(center + distance * direction / np.linalg.norm(direction))
    aside = np.array([-math.sin(turn), 0, math.cos(turn)])
    camera.SetFocalPoint(center + 0.5 * radius * math.sin(5 * turn) * aside)
    camera.SetViewAngle(30)
    camera.SetClippingRange(0.01 * radius, 6 * radius)


def measure_query(mask, repeats):
    """Seconds of culling and of the union, the best of several."""
    times = []
    for _ in range(repeats):
        mask.Modified()
        mask.Update()
        times.append((mask.GetCullTime(), mask.GetUnionTime()))
    return np.min(times, axis=0)


def measure(image, depth, encoding, frames, repeats):
    """Rows of visible leaves, seconds of culling, of the union, and three sizes in bytes."""
    low, high = geometryimages.get_box(image)
    camera = vtkCamera()
    masks = []
    for internal in True, False:
        mask = bravais.vtkGeometryImageLocalityMask()
        mask.SetInputData(image)
        mask.SetMaximumDepth(depth)
        mask.SetEncoding(encoding)
        mask.SetStoreInternalMasks(internal)
        mask.SetCamera(camera)
        masks.append(mask)
    surface = bravais.vtkGeometryImageToPolyData()
    surface.ComputeNormalsOff()
    surface.ComputeTextureCoordinatesOff()
    surface.SetInputConnection(masks[0].GetOutputPort())
    rows = []
    for frame in range(frames):
        place_camera(camera, frame / frames, low, high)
        times = [measure_query(mask, repeats) for mask in masks]
        surface.Update()
        indices = 3 * 4 * surface.GetOutput().GetNumberOfPolys()
        rows.append([masks[0].GetNumberOfVisibleLeaves(), *times[0], *times[1],
                     masks[1].GetVisibleSize(), masks[0].GetUnionSize(), indices])
    return np.array(rows, float)


def bin_by_leaves(rows, bins=12):
    """Means of the rows in ranges of visible leaves."""
    edges = np.linspace(0, rows[:, 0].max() + 1, bins + 1)
    which = np.digitize(rows[:, 0], edges) - 1
    return np.array([rows[which == n].mean(axis=0) for n in range(bins) if (which == n).any()])


def make_chart(viewport, title, labels, columns, legend, logarithmic=False):
    """A renderer with a chart of lines over the first column."""
    table = vtkTable()
    for name, values in columns.items():
        array = vtkDoubleArray()
        array.SetName(name)
        for value in values:
            array.InsertNextValue(max(value, 1) if logarithmic and table.GetNumberOfColumns() else value)
        table.AddColumn(array)
    chart = vtkChartXY()
    chart.SetTitle(title)
    chart.SetShowLegend(True)
    chart.GetLegend().SetHorizontalAlignment(legend[0])
    chart.GetLegend().SetVerticalAlignment(legend[1])
    for n, color in zip(range(1, len(columns)), COLORS):
        plot = chart.AddPlot(vtkChart.LINE)
        plot.SetInputData(table, 0, n)
        plot.SetColor(*color)
        plot.SetWidth(1.5)
    for axis, label in zip((vtkAxis.BOTTOM, vtkAxis.LEFT), labels):
        chart.GetAxis(axis).SetTitle(label)
    chart.GetAxis(vtkAxis.LEFT).SetLogScale(logarithmic)
    actor = vtkContextActor()
    actor.GetScene().AddItem(chart)
    renderer = vtkRenderer()
    renderer.SetBackground(1, 1, 1)
    renderer.SetViewport(viewport)
    renderer.AddActor(actor)
    actor.GetScene().SetRenderer(renderer)
    return renderer


def plot(rows, path, width):
    """Three charts, one above another."""
    micro = 1e6
    means = bin_by_leaves(rows)
    frames = make_chart(
        (0, 2 / 3, 1, 1), "Culling, by frame", ("frame", "microseconds"),
        {"frame": np.arange(len(rows)), "with union": (rows[:, 1] + rows[:, 2]) * micro,
         "without": rows[:, 1] * micro}, (vtkChartLegend.RIGHT, vtkChartLegend.TOP))
    leaves = make_chart(
        (0, 1 / 3, 1, 2 / 3), "Culling, by visible leaves", ("visible leaves", "microseconds"),
        {"leaves": means[:, 0], "leaf masks united": (means[:, 3] + means[:, 4]) * micro,
         "with internal masks": (means[:, 1] + means[:, 2]) * micro,
         "without union": means[:, 1] * micro}, (vtkChartLegend.LEFT, vtkChartLegend.TOP))
    sizes = make_chart(
        (0, 0, 1, 1 / 3), "Bytes to send, by visible leaves", ("visible leaves", "bytes"),
        {"leaves": means[:, 0], "index list": means[:, 7], "leaf masks": means[:, 5],
         "their union": means[:, 6]}, (vtkChartLegend.RIGHT, vtkChartLegend.CENTER), True)
    pictures.write(path, pictures.render([frames, leaves, sizes], (width, width * 3 // 2)))


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("folder", type=pathlib.Path, help="where the picture goes")
    parser.add_argument("model", nargs="?", type=pathlib.Path, help="geometry image or .obj mesh")
    parser.add_argument("--size", type=int, default=257, help="gixels along each side")
    parser.add_argument("--depth", type=int, default=5)
    parser.add_argument("--encoding", choices=("RLE", "Roaring"), default="RLE")
    parser.add_argument("--frames", type=int, default=1090)
    parser.add_argument("--repeats", type=int, default=3)
    parser.add_argument("--width", type=int, default=500, help="of the picture")
    options = parser.parse_args()
    options.folder.mkdir(parents=True, exist_ok=True)
    image = (geometryimages.read(options.model, options.size) if options.model
             else geometryimages.make("BumpySphere", options.size, options.size))
    encoding = getattr(bravais.vtkGeometryImageLocalityMask, options.encoding)
    rows = measure(image, options.depth, encoding, options.frames, options.repeats)
    print(f"{options.frames} frames, depth {options.depth}, {options.encoding}")
    print("| visible leaves | cull (us) | with union (us) | with union of leaves (us) "
          "| leaf masks (bytes) | union (bytes) | index list (bytes) |\n|---|---|---|---|---|---|---|")
    for row in [*bin_by_leaves(rows), rows.mean(axis=0)]:
        print(f"| {row[0]:.0f} | {row[1] * 1e6:.1f} | {(row[1] + row[2]) * 1e6:.1f} | "
              f"{(row[3] + row[4]) * 1e6:.1f} | {row[5]:.0f} | {row[6]:.0f} | {row[7]:.0f} |")
    print("The last row is the mean of all frames.")
    plot(rows, options.folder / "locality-mask-session.png", options.width)


main()
