// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
in vec2 rank1TCoord;
out vec2 rank1TCoordVCVSOutput;
uniform mat4 in_rank1TCoordMatrix;
