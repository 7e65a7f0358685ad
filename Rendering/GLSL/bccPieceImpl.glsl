// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef BCC_SLICE
#ifdef BCC_ISOSURFACE
    if (g_currentT > 0.0 && !BCCGoToPart())
#else
    if (!BCCGoToPart())
#endif
    {
      break;
    }
#endif
