#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
"""What locality masks cost to store, as in the paper's Table 1.

Prints, for each model and depth, the leaves and nodes and their masks' bytes: uncompressed, by run
lengths and as Roaring bitmaps. Models are geometry image files or meshes of closed surfaces;
without any, three meshes where --download may fetch them, and surfaces that are made here.
"""
import argparse
import pathlib

import bravais
import geometryimages
import meshes


def print_row(name, image, depth):
    width, height, _ = image.GetDimensions()
    sizes = []
    for encoding in bravais.vtkGeometryImageLocalityMask.RLE, bravais.vtkGeometryImageLocalityMask.Roaring:
        mask = bravais.vtkGeometryImageLocalityMask()
        mask.SetInputData(image)
        mask.SetMaximumDepth(depth)
        mask.SetEncoding(encoding)
        mask.Update()
        sizes += [mask.GetCompressedSize(True), mask.GetCompressedSize(False)]
    plain = mask.GetUncompressedSize(True), mask.GetUncompressedSize(False)
    exceptions = mask.GetNumberOfExceptions()
    print(f"| {name} | {width} x {height} | {depth} | {mask.GetNumberOfLeaves()} / "
          f"{mask.GetNumberOfNodes()} | {plain[0]} / {plain[1]} | {sizes[0]} / {sizes[1]} | "
          f"{sizes[2]} / {sizes[3]} | {100 * (1 - sizes[1] / plain[1]):.2f} % | {exceptions} |")


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("models", nargs="*", type=pathlib.Path)
    parser.add_argument("--download", type=pathlib.Path, metavar="FOLDER",
                        help="fetch meshes of Debian packages into a folder")
    parser.add_argument("--size", type=int, default=257, help="gixels along each side")
    parser.add_argument("--depths", type=int, nargs="+", default=[4, 5])
    options = parser.parse_args()
    models = {path.stem: geometryimages.read(path, options.size) for path in options.models}
    if options.download:
        for name in "bunny", "armadillo", "homer":
            path = meshes.fetch(name, options.download)
            models.update({name: geometryimages.read(path, options.size)} if path else {})
    if not options.models:
        models["bumpy sphere"] = geometryimages.make("BumpySphere", options.size, options.size)
        models["torus"] = geometryimages.make("Torus", 2 * options.size, options.size // 2)
    print("| model | gixels | depth | leaves / nodes | uncompressed | run lengths | Roaring "
          "| saved | kept as run lengths |\n|---|---|---|---|---|---|---|---|---|")
    for name, image in models.items():
        for depth in options.depths:
            print_row(name, image, depth)


main()
