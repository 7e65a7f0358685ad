// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause

  if (g_fragColor.a > 3.0 / 255.0)
  {
    gl_FragData[0] = BCCPickedColor(BCC_PICKED_PLACE, BCC_PICKED_SHIFT);
  }
  else
  {
    gl_FragData[0] = vec4(0.0);
  }
  return;
