// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef BayerMeasures_h
#define BayerMeasures_h

/// \file
/// How evenly a pattern's first cells are spread, in space and in frequency. All of them are
/// periodic: the pattern is a tile that repeats, so distances are those on a torus.

#include "BayerPattern.h"

#include <cstdint>
#include <vector>

namespace bravais
{

/// For each number m = 1 .. cells, at place m - 1: the smallest squared distance between any two
/// of the first m cells. One cell alone is one side away from its own copies.
std::vector<std::int64_t> GetSquaredMinimumDistances(const BayerPattern& pattern);

/// The power |sum over cells c of v(c) exp(-2 pi i f.c / side)|^2 / cells at each frequency f of
/// 0 .. side - 1 an axis, x fastest, of the thresholds v = (rank + 1/2) / cells - 1/2. Its mean is
/// that of v^2.
std::vector<double> GetThresholdSpectrum(const BayerPattern& pattern);

/// The same of the picture that a constant m / cells becomes with two levels: v is 1 - m / cells in
/// the first m cells and -m / cells in the others.
std::vector<double> GetPrefixSpectrum(const BayerPattern& pattern, std::int64_t m);

} // namespace bravais

#endif
