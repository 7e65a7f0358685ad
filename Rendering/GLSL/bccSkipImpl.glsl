// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause

    BCCSkipEmpty();
    if (g_bccLeft)
    {
      break;
    }
