# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
"""Bravais: sampling, reconstruction and rendering on lattices other than the Cartesian grid."""

# VTK's factories for rendering register themselves when these are imported; without them a
# mapper made from Python would be the abstract one.
import vtkmodules.vtkInteractionStyle  # noqa: F401
import vtkmodules.vtkRenderingFreeType  # noqa: F401
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401
import vtkmodules.vtkRenderingVolumeOpenGL2  # noqa: F401

from .vtkBravais import *  # noqa: F401,F403
