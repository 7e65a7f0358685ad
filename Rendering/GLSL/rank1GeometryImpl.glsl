// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause

// The same, of the corner that is emitted.

rank1TCoordVCGSOutput = rank1TCoordVCVSOutput[i];
