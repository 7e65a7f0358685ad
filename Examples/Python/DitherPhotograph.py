#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
"""A photograph at 2, 4 and 8 levels: rounded to the nearest level above, dithered below.

    DitherPhotograph.py FOLDER [PICTURE | --download]

writes dither-photograph-grey.png and dither-photograph-color.png to FOLDER. --download takes the
portrait of Debian's python3-imageio (NASA, public domain); without a picture one is generated.
"""
import argparse
import pathlib

import numpy as np
from vtkmodules.vtkCommonCore import vtkLookupTable
from vtkmodules.vtkImagingCore import vtkImageMapToColors, vtkImageShiftScale

import debian
import pictures
from bravais import vtkOrderedDither

LEVELS = 2, 4, 8
SIDE = 256
PORTRAIT = "python3-imageio", "usr/lib/python3/dist-packages/imageio/resources/images/astronaut.png"


def generate():
    """Soft discs on a slope, in colours."""
    y, x = np.mgrid[0:SIDE, 0:SIDE] / (SIDE - 1)
    picture = np.stack([x, (x + y) / 2, y], -1)
    for cx, cy, radius, color in (
            (0.3, 0.4, 0.22, (1, 0.7, 0.4)), (0.7, 0.3, 0.15, (0.3, 0.9, 0.5)),
            (0.6, 0.7, 0.25, (0.5, 0.6, 1))):
        height = np.sqrt(np.clip(1 - ((x - cx) ** 2 + (y - cy) ** 2) / radius ** 2, 0, 1))
        inside = height[..., None] > 0
        picture = np.where(inside, height[..., None] * color, picture)
    return (255 * picture).round().astype(np.uint8)


def shrink(picture):
    """The central square, averaged to SIDE columns where it is larger."""
    height, width = picture.shape[:2]
    n = max(min(height, width) // SIDE, 1)
    side = min(height, width, n * SIDE)
    top, left = (height - side) // 2, (width - side) // 2
    square = picture[top:top + side, left:left + side].astype(float)
    side //= n
    square = square[:side * n, :side * n].reshape(side, n, side, n, -1)
    return square.mean(axis=(1, 3)).round().astype(np.uint8)


def quantize(picture, levels, log2_size):
    dither = vtkOrderedDither()
    dither.SetInputData(pictures.to_image(picture))
    dither.SetInputRange(0, 255)
    dither.SetNumberOfLevels(levels)
    dither.SetPatternLog2Size(log2_size)
    dither.Update()
    return dither.GetOutput()


def show_grey(image, levels):
    """Level indices through a lookup table of as many greys."""
    table = vtkLookupTable()
    table.SetNumberOfTableValues(levels)
    table.SetTableRange(0, levels - 1)
    for level in range(levels):
        grey = level / (levels - 1)
        table.SetTableValue(level, grey, grey, grey)
    colors = vtkImageMapToColors()
    colors.SetLookupTable(table)
    colors.SetOutputFormatToLuminance()
    colors.SetInputData(image)
    colors.Update()
    return pictures.to_array(colors.GetOutput())


def show_color(image, levels):
    """Level indices of red, green and blue, scaled to bytes."""
    scale = vtkImageShiftScale()
    scale.SetInputData(image)
    scale.SetScale(255 / (levels - 1))
    scale.SetShift(0.5 / scale.GetScale())  # so that the conversion to bytes rounds
    scale.SetOutputScalarTypeToUnsignedChar()
    scale.ClampOverflowOn()
    scale.Update()
    return pictures.to_array(scale.GetOutput())


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("picture", nargs="?")
    parser.add_argument("--download", action="store_true")
    options = parser.parse_args()
    options.folder.mkdir(parents=True, exist_ok=True)
    path = options.picture
    if options.download:
        path = debian.fetch(*PORTRAIT, options.folder / "data")
    picture = shrink(pictures.read(path)) if path else generate()
    grey = (picture @ [0.2126, 0.7152, 0.0722]).round().astype(np.uint8)
    for name, original, show in ("grey", grey, show_grey), ("color", picture, show_color):
        rows = []
        for log2_size in 0, 3:  # a pattern of one cell rounds
            results = [show(quantize(original, n, log2_size), n) for n in LEVELS]
            for levels, result in zip(LEVELS, results):
                error = result.astype(float).mean() - original.mean()
                print(f"{name:5} {levels} levels, {'rounded ' if log2_size == 0 else 'dithered'}: "
                      f"mean {error:+7.3f} of 255 off")
            rows.append(np.concatenate(results, axis=1))
        pictures.write(options.folder / f"dither-photograph-{name}.png", np.concatenate(rows))


main()
