#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
"""Errors of rank-1 and of square textures of as many texels, of photographs and a checkerboard.

    Rank1AgainstSquare.py FOLDER [PICTURE ... | --download] [--side N]
                          [--resolutions FIRST LAST STEP]

repeats the experiment of figure 8 of Dammertz, Dammertz, Keller and Lensch, Textures on Rank-1
Lattices, and writes rank1-against-square.png to FOLDER. Both textures of r x r texels are box
filtered, so that a texel is the mean of its cell, a square or about a hexagon. The error is the
mean square difference from the picture, grey and 0 to 1, of the nearest texel everywhere and of
interpolation, bilinear and barycentric.

Of a picture the central square is taken, at most --side pixels, and mirrored both ways, as textures
are periodic: else what is measured is how its opposite edges differ. The side is a prime number by
default, so that no texture's squares are whole blocks of pixels. The checkerboard's are, at 128,
256, 384 and 512. --download takes three photographs of Debian's lomiri-wallpapers-16.04; without
pictures a few are generated.
"""
import argparse
import pathlib

import numpy as np
import vtkmodules.vtkRenderingContextOpenGL2
import vtkmodules.vtkRenderingFreeType
from vtkmodules.vtkChartsCore import vtkAxis, vtkChart, vtkChartMatrix
from vtkmodules.vtkCommonCore import vtkFloatArray
from vtkmodules.vtkCommonDataModel import vtkTable, vtkVector2i
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import vtkWindowToImageFilter
from vtkmodules.vtkViewsContext2D import vtkContextView

import bravais
import debian
import pictures
from squares import make_square

PACKAGE = "lomiri-wallpapers-16.04"
PHOTOGRAPHS = {"brushes": "Picture_1A_by_freespace.jpg", "dragonfly": "Dragonfly_by_Bolly.jpg",
               "fig": "Picture_0B_by_freespace.jpg"}
CURVES = ("square", (200, 60, 40)), ("rank-1", (40, 90, 180))


def interpolate_square(texels, n):
    """Bilinear interpolation at the centres of n x n pixels of the periodic picture."""
    r = len(texels)
    place = (np.arange(n) + 0.5) * r / n - 0.5
    low = np.floor(place).astype(int)
    weight = place - low
    rows = texels[low % r] * (1 - weight)[:, None] + texels[(low + 1) % r] * weight[:, None]
    return rows[:, low % r] * (1 - weight) + rows[:, (low + 1) % r] * weight


def interpolate_rank1(image, n):
    reconstruct = bravais.vtkRank1ImageReconstruct()
    reconstruct.SetInputData(image)
    reconstruct.SetOutputDimensions(n, n)
    reconstruct.Update()
    return bravais.image_to_numpy(reconstruct.GetOutput())[0]


def measure(picture, resolutions):
    """Errors [resolution, nearest | interpolated, square | rank-1]."""
    resample = bravais.vtkRank1ImageResample()
    resample.SetInputData(bravais.image_from_numpy(picture))
    resample.SetFilterToBox()
    n = len(picture)
    errors = []
    for r in resolutions:
        square = make_square(picture, r)
        resample.SetNumberOfPoints(r * r)
        resample.Update()
        rank1 = bravais.rank1_to_numpy(resample.GetOutput())[0]
        # Cells are of one area and their means the best there are, so what they leave of the
        # picture is at right angles to them: the errors of the nearest texel need no look-up.
        power = (picture ** 2).mean()
        errors.append(((power - (square ** 2).mean(), power - (rank1 ** 2).mean()),
                       (((interpolate_square(square, n) - picture) ** 2).mean(),
                        ((interpolate_rank1(resample.GetOutput(), n) - picture) ** 2).mean())))
    return np.maximum(errors, 0)


def mirror(pixels, side):
    """The central square's grey values, at most `side` pixels, repeated as mirrors both ways."""
    grey = pixels.astype(float) @ [0.2126, 0.7152, 0.0722] / 255
    height, width = grey.shape
    n = min(height, width)
    top, left = (height - n) // 2, (width - n) // 2
    grey = grey[top:top + n, left:left + n]
    if n > side:
        grey = make_square(grey, side)
    grey = np.concatenate([grey, grey[:, ::-1]], axis=1)
    return np.concatenate([grey, grey[::-1]])


def make_checkerboard(n):
    """128 x 128 fields, or of 2 pixels where there are fewer."""
    field = max(n // 128, 2)
    y, x = np.mgrid[0:n, 0:n] // field
    return ((x + y) % 2).astype(float)


def make_waves(n, seed):
    """Waves of all directions and many lengths, the longer the higher."""
    random = np.random.default_rng(seed)
    y, x = np.mgrid[0:n, 0:n] / n
    picture = np.full((n, n), 0.5)
    for _ in range(60):
        length, turn = n / 3 * random.random() ** 2 + 1, 2 * np.pi * random.random()
        i, j = round(length * np.cos(turn)), round(length * np.sin(turn))
        picture += 0.3 / length * np.sin(2 * np.pi * (i * x + j * y + random.random()))
    return picture


def add_chart(matrix, place, name, resolutions, errors):
    chart = matrix.GetChart(vtkVector2i(*place))
    chart.SetTitle(name)
    chart.GetTitleProperties().SetFontSize(16)
    chart.GetAxis(vtkAxis.BOTTOM).SetTitle("columns and rows of the square texture")
    chart.GetAxis(vtkAxis.LEFT).SetTitle("mean square error x 10000")
    chart.SetShowLegend(True)
    table = vtkTable()
    columns = [("resolution", resolutions)] + [
        (curve, 1e4 * errors[:, 0, number]) for number, (curve, _) in enumerate(CURVES)]
    for title, values in columns:
        array = vtkFloatArray()
        array.SetName(title)
        for value in values:
            array.InsertNextValue(value)
        table.AddColumn(array)
    for number, (_, color) in enumerate(CURVES):
        line = chart.AddPlot(vtkChart.LINE)
        line.SetInputData(table, 0, number + 1)
        line.SetColor(*color, 255)
        line.SetWidth(2)


def draw(path, resolutions, results):
    """One chart a picture, two a row, in one PNG."""
    view = vtkContextView()
    rows = (len(results) + 1) // 2
    view.GetRenderWindow().SetOffScreenRendering(True)
    view.GetRenderWindow().SetMultiSamples(4)
    view.GetRenderWindow().SetSize(900, 330 * rows)
    view.GetRenderer().SetBackground(1, 1, 1)
    matrix = vtkChartMatrix()
    matrix.SetSize(vtkVector2i(min(2, len(results)), rows))
    matrix.SetGutterX(80)
    matrix.SetGutterY(70)
    view.GetScene().AddItem(matrix)
    for number, (name, errors) in enumerate(results.items()):
        place = number % 2, rows - 1 - number // 2
        add_chart(matrix, place, name, resolutions, errors)
    view.GetRenderWindow().Render()
    grabber = vtkWindowToImageFilter()
    grabber.SetInput(view.GetRenderWindow())
    grabber.ReadFrontBufferOff()
    writer = vtkPNGWriter()
    writer.SetInputConnection(grabber.GetOutputPort())
    writer.SetFileName(str(path))
    writer.SetCompressionLevel(9)
    writer.Write()
    print(path)


def print_ratios(resolutions, results):
    """Rank-1's error over the square's, per cent."""
    for kind, title in enumerate(("nearest texel", "interpolated")):
        print(f"\nrank-1's error in percent of the square's, {title}")
        print("texels".rjust(9), *(name[:11].rjust(11) for name in results))
        with np.errstate(divide="ignore", invalid="ignore"):
            ratios = {name: 100 * errors[:, kind, 1] / errors[:, kind, 0]
                      for name, errors in results.items()}
        for row, r in enumerate(resolutions):
            print(f"{r:4} x {r:<4}", *(
                f"{ratios[name][row]:11.1f}" if results[name][row, kind, 0] > 1e-9 else
                "square is 0" for name in results))
        below = (f"{int((ratio < 100).sum())} of {len(ratio)}".rjust(11)
                 for ratio in ratios.values())
        print("below 100", *below)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("picture", nargs="*")
    parser.add_argument("--download", action="store_true")
    parser.add_argument("--side", type=int, default=1019)
    parser.add_argument("--resolutions", type=int, nargs=3, default=(128, 512, 16),
                        metavar=("FIRST", "LAST", "STEP"))
    options = parser.parse_args()
    first, last, step = options.resolutions
    if options.side < 8 or not 2 <= first <= last or step < 1:
        parser.error(f"side {options.side} and resolutions {first} to {last} by {step} are no "
                     "experiment; a side of 8 or more and 2 <= FIRST <= LAST were expected")
    options.folder.mkdir(parents=True, exist_ok=True)
    paths = {pathlib.Path(path).stem: path for path in options.picture}
    if options.download:
        for name, file in PHOTOGRAPHS.items():
            paths[name] = debian.fetch(
                PACKAGE, f"usr/share/backgrounds/{file}", options.folder / "data")
    if None in paths.values():
        raise SystemExit(1)
    shown = {name: mirror(pictures.read(path), options.side) for name, path in paths.items()}
    for seed in () if shown else (1, 2, 3):
        shown[f"waves {seed}"] = make_waves(2 * options.side, seed)
    shown["checkerboard"] = make_checkerboard(-(-2 * options.side // 128) * 128)
    resolutions = range(first, last + 1, step)
    results = {name: measure(picture, resolutions) for name, picture in shown.items()}
    print_ratios(resolutions, results)
    draw(options.folder / "rank1-against-square.png", resolutions, results)


main()
