# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
"""Bravais: sampling, reconstruction and rendering on lattices other than the Cartesian grid.

The classes are VTK's kind, vtkBCCVolumeSource for one: help(bravais.vtkBCCVolumeSource). The
functions of bravais.arrays, which turn NumPy arrays into lattice images and back, are here too:
bravais.bcc_from_numpy for one. NumPy is loaded when the first of them is used.
"""

# VTK's factories for rendering register themselves when these are imported; without them a
# mapper made from Python would be the abstract one.
import vtkmodules.vtkInteractionStyle  # noqa: F401
import vtkmodules.vtkRenderingFreeType  # noqa: F401
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401
import vtkmodules.vtkRenderingVolumeOpenGL2  # noqa: F401

from .vtkBravais import *  # noqa: F401,F403


def __getattr__(name):
    import importlib

    if not name.startswith("_"):
        arrays = importlib.import_module(".arrays", __name__)
        if name == "arrays" or name in arrays.__all__:
            return getattr(arrays, name, arrays)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")


def __dir__():
    from . import arrays

    return sorted(set(globals()) | set(arrays.__all__))
