// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause

    // In the place of VTK's step from where the ray enters to its first sample: (rank + 1/2) / cells
    // of it, by the viewport's pixel and Bayer's square of side 8. The ranks' twin, for any side, is
    // in Module/Core/BayerPattern.h.
    {
      ivec2 cell = ivec2(gl_FragCoord.xy - in_windowLowerLeftCorner);
      ivec2 digits = ivec2(cell.x ^ cell.y, cell.y);
      int rank = (digits.x & 1) << 5 | (digits.y & 1) << 4 | (digits.x & 2) << 2 |
        (digits.y & 2) << 1 | (digits.x & 4) >> 1 | (digits.y & 4) >> 2;
      g_rayJitter = (float(rank) + 0.5) / 64.0 * g_dirStep;
    }
