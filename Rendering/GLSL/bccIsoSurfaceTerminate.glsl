// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause

    if (l_bccLast || g_fragColor.a > g_opacityThreshold)
    {
      break;
    }
    BCCStopAtEnd();
