// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause

// The texture coordinates on their way through the geometry shader.

in vec2 rank1TCoordVCVSOutput[];
out vec2 rank1TCoordVCGSOutput;
