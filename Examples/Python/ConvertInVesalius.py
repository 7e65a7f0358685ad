#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
"""Converts an InVesalius project (.inv3, a tar.gz) to a MetaImage: <name>.mhd and <name>.raw."""
import argparse
import os
import plistlib
import sys
import tarfile

HEADER = """ObjectType = Image
NDims = 3
BinaryData = True
BinaryDataByteOrderMSB = False
ElementSpacing = {spacing}
DimSize = {size}
ElementType = MET_SHORT
ElementDataFile = {raw}
"""


def convert(project, header):
    with tarfile.open(project, "r:gz") as archive:
        members = {os.path.basename(name): name for name in archive.getnames()}
        settings = plistlib.load(archive.extractfile(members["main.plist"]))
        values = archive.extractfile(members[settings["matrix"]["filename"]]).read()
    matrix = settings["matrix"]
    size = matrix["shape"][::-1]
    if matrix["dtype"] != "int16" or len(values) != 2 * size[0] * size[1] * size[2]:
        raise ValueError(f"expected {matrix['shape']} values of type int16")
    raw = os.path.splitext(header)[0] + ".raw"
    with open(raw, "wb") as file:
        file.write(values)
    with open(header, "w", encoding="ascii") as file:
        file.write(HEADER.format(
            spacing=" ".join(map(str, settings["spacing"])), size=" ".join(map(str, size)),
            raw=os.path.basename(raw)))


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("project", help="the .inv3 file")
    parser.add_argument("header", help="the .mhd file to write")
    options = parser.parse_args()
    try:
        convert(options.project, options.header)
    except (OSError, KeyError, ValueError, tarfile.TarError) as error:
        sys.exit(f"{parser.prog}: error: {options.project}: {error}")


if __name__ == "__main__":
    main()
