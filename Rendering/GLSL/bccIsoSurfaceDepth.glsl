// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause

  g_bccDepth = l_depthValue.x;
  g_bccDepthTaken = false;
