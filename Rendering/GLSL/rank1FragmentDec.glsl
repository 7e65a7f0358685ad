// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause

// What rank1FragmentImpl reads.

in vec2 rank1TCoordVCVSOutput;
uniform int in_rank1ShowOnBackface;
