// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause

#ifdef BCC_WRITE_DEPTH
  gl_FragDepth = g_bccDepth;
#endif
#ifdef BCC_PROGRESSIVE
#ifdef BCC_WRITE_DEPTH
  gl_FragData[1] = vec4(g_bccDepth);
#else
  gl_FragData[1] = vec4(g_bccFragCoord.z);
#endif
#endif
