// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause

    if (l_bccLast || g_fragColor.a > g_opacityThreshold)
    {
      break;
    }
    ++g_currentT;
    l_bccSteps -= 1.0;
    if (l_bccSteps <= 0.0)
    {
      g_dataPos += l_bccSteps * g_dirStep;
      l_bccLast = true;
    }
