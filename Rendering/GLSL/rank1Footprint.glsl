// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause

// The footprint of a pixel, where all pixels of a quad pass.

vec4 rank1Footprint = vec4(dFdx(rank1TCoordVCVSOutput), dFdy(rank1TCoordVCVSOutput));
