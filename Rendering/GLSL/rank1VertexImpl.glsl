// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
  vec4 rank1Place = in_rank1TCoordMatrix * vec4(rank1TCoord, 0.0, 1.0);
  rank1TCoordVCVSOutput = rank1Place.xy / rank1Place.w;
