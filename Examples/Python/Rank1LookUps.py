#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
"""Close-ups of the look-ups in square and rank-1 textures of as many texels.

    Rank1LookUps.py FOLDER [PICTURE | --download] [--texels SIDE] [--window U0 U1 V0 V1]

writes rank1-look-ups.png to FOLDER. Above: a square texture of SIDE x SIDE texels by VTK's mapper,
nearest and linear, and the picture itself. Below: a rank-1 texture of as many texels by
vtkRank1TexturedPolyDataMapper, nearest, bilinear, barycentric and by the box-spline (figure 6 of
Dammertz, Dammertz, Keller and Lensch, Textures on Rank-1 Lattices, and one more). --download takes
the portrait of Debian's python3-imageio (NASA, public domain); without a picture one is generated.
"""
import argparse
import pathlib

import numpy as np
import vtkmodules.vtkRenderingOpenGL2
from vtkmodules.vtkFiltersSources import vtkPlaneSource
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper, vtkRenderer, vtkTexture

import bravais
import debian
import pictures
from squares import make_square

PORTRAIT = "python3-imageio", "usr/lib/python3/dist-packages/imageio/resources/images/astronaut.png"
WINDOW = 0.33, 0.55, 0.68, 0.9
PANEL = 200
MODES = "Nearest", "Bilinear", "Barycentric", "BoxSpline"


def generate(side=512):
    """Rings about two centres, in colours: lines of all directions."""
    y, x = np.mgrid[0:side, 0:side] / side
    left = np.hypot(x - 0.2, y - 0.15)
    right = np.hypot(x - 0.8, y - 0.5)
    rings = np.stack([np.sin(90 * left), np.sin(90 * left) * np.sin(50 * right),
                      np.sin(50 * right)], -1)
    return (127.5 + 127 * rings).astype(np.uint8)


def crop_to_square(picture):
    side = min(picture.shape[:2])
    top, left = (picture.shape[0] - side) // 2, (picture.shape[1] - side) // 2
    return picture[top:top + side, left:left + side]


def make_rank1(image, side):
    resample = bravais.vtkRank1ImageResample()
    resample.SetInputData(image)
    resample.SetNumberOfPoints(side * side)
    resample.SetFilterToBox()
    resample.Update()
    return resample.GetOutput()


def make_actor(mapper):
    """The unit square, with the picture on it."""
    plane = vtkPlaneSource()
    plane.SetOrigin(0, 0, 0)
    plane.SetPoint1(1, 0, 0)
    plane.SetPoint2(0, 1, 0)
    mapper.SetInputConnection(plane.GetOutputPort())
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().LightingOff()
    return actor


def show_square(image, linear):
    actor = make_actor(vtkPolyDataMapper())
    texture = vtkTexture()
    texture.SetInputData(image)
    texture.SetInterpolate(linear)
    actor.SetTexture(texture)
    return actor


def show_rank1(image, mode):
    mapper = bravais.vtkRank1TexturedPolyDataMapper()
    mapper.SetTextureData(image)
    getattr(mapper, "SetInterpolationTo" + mode)()
    return make_actor(mapper)


def close_up(actor, window, column, row, columns):
    """A renderer, one panel of two rows, that shows a part of the unit square."""
    renderer = vtkRenderer()
    renderer.AddActor(actor)
    renderer.SetViewport(column / columns, row / 2, (column + 1) / columns, (row + 1) / 2)
    camera = renderer.GetActiveCamera()
    camera.ParallelProjectionOn()
    camera.SetParallelScale((window[3] - window[2]) / 2)
    camera.SetFocalPoint((window[0] + window[1]) / 2, (window[2] + window[3]) / 2, 0)
    camera.SetPosition(*camera.GetFocalPoint()[:2], 1)
    renderer.ResetCameraClippingRange()
    return renderer


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("picture", nargs="?")
    parser.add_argument("--download", action="store_true")
    parser.add_argument("--texels", type=int, default=128, metavar="SIDE")
    parser.add_argument("--window", type=float, nargs=4, default=WINDOW,
                        metavar=("U0", "U1", "V0", "V1"))
    options = parser.parse_args()
    window = options.window
    if options.texels < 1 or not (window[0] < window[1] and window[2] < window[3]):
        parser.error(f"{options.texels} texels a side in the window {window}: at least one, and "
                     "U0 < U1, V0 < V1 were expected")
    options.folder.mkdir(parents=True, exist_ok=True)
    path = options.picture
    if options.download:
        path = debian.fetch(*PORTRAIT, options.folder / "data")
        if not path:
            raise SystemExit(1)
    picture = crop_to_square(pictures.read(path)) if path else generate()
    image = pictures.to_image(picture)
    texels = make_square(picture, options.texels)
    square = pictures.to_image(texels.round().astype(np.uint8))
    rank1 = make_rank1(image, options.texels)
    above = [show_square(square, False), show_square(square, True), show_square(image, True)]
    below = [show_rank1(rank1, mode) for mode in MODES]
    renderers = [close_up(actor, window, column, row, len(MODES))
                 for row, actors in ((1, above), (0, below))
                 for column, actor in enumerate(actors)]
    n, generator = options.texels ** 2, bravais.rank1_to_numpy(rank1)[1]
    print(f"{n} texels: {options.texels} x {options.texels} squares, and the rank-1 lattice of "
          f"generator {generator}")
    size = len(MODES) * PANEL, 2 * PANEL
    blank = vtkRenderer()  # the panel beside the picture
    blank.SetBackground(1, 1, 1)
    pixels = pictures.render([blank] + renderers, size)
    pictures.write(options.folder / "rank1-look-ups.png", pixels)


main()
