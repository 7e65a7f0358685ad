// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause

  BCCStartRay();
#if defined(BCC_SKIP_DISTANCE) || defined(BCC_SKIP_EXTREMUM)
  BCCStartSkipping();
#endif
#ifdef BCC_LOOK_AHEAD
  BCCLookAhead();
#endif
