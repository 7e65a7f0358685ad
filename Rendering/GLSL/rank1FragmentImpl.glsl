// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
  if (gl_FrontFacing || in_rank1ShowOnBackface != 0)
  {
    gl_FragData[0] *= GetRank1Color(rank1TCoordVCVSOutput, rank1Footprint);
  }
