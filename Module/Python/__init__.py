# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
"""Bravais: sampling, reconstruction and rendering on lattices other than the Cartesian grid.

Five lines from nothing to a picture:

    import bravais

    volume = bravais.apply(bravais.vtkBCCVolumeSource)
    pixels = bravais.render(bravais.isosurface(volume, 0.5))
    bravais.write_picture("marschner-lobb.png", pixels)

Functions; each has help of its own, help(bravais.render) for one:

    arrays      NumPy arrays as lattice images and back: bcc_from_numpy, bcc_to_numpy, bcc_points,
                rank1_from_numpy, rank1_to_numpy, geometry_from_numpy, geometry_to_numpy,
                image_from_numpy, image_to_numpy, bayer_thresholds
    pictures    isosurface, surface, render, make_window, grab, read_picture, write_picture
    pipeline    apply, which runs any of VTK's algorithms in one call; rank1_sample

Constants: BCC4, BCC7, BCC8 and BCC12, the kernels of BCC volumes; all others are their classes',
vtkImageToBCCVolume.Subset for one. Classes:

"""

# VTK's factories for rendering register themselves when these are imported; without them a
# mapper made from Python would be the abstract one.
import vtkmodules.vtkInteractionStyle  # noqa: F401
import vtkmodules.vtkRenderingFreeType  # noqa: F401
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401
import vtkmodules.vtkRenderingVolumeOpenGL2  # noqa: F401

from .vtkBravais import *  # noqa: F401,F403

__version__ = "@PROJECT_VERSION@"

BCC4, BCC7, BCC8, BCC12 = (
    getattr(vtkBCCLattice, name) for name in ("BCC4", "BCC7", "BCC8", "BCC12")  # noqa: F405
)

_MODULES = "arrays", "pictures", "pipeline"  # NumPy is loaded when one of them is first used


def _describe(name):
    """A line for help(): a class's name, and what its documentation says in brief."""
    brief = (globals()[name].__doc__ or "").split("\n\n")[0].split(" - ", 1)[-1]
    return f"    {name:<31} {' '.join(brief.split())}"


if __doc__:  # there is none where Python was told to leave out texts
    __doc__ += "\n".join(_describe(name) for name in sorted(globals())
                         if name.startswith("vtk") and isinstance(globals()[name], type))


def __getattr__(name):
    import importlib

    if not name.startswith("_"):
        for module in _MODULES:
            found = importlib.import_module("." + module, __name__)
            if name == module:
                return found
            if name in found.__all__:
                return getattr(found, name)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")


def __dir__():
    return sorted({*globals(), *(name for module in _MODULES for name in __getattr__(module).__all__)})
