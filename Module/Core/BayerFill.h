// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef BayerFill_h
#define BayerFill_h

#include <glm/vec2.hpp>

#include <cstdint>
#include <vector>

namespace bravais
{

class BayerPattern;

/**
 * Where the cells of a square pattern take a value from while only the first of its order have one.
 *
 * For each cell, x fastest, the step to the nearest of the first `count` cells of the pattern,
 * which repeats in both directions. Of several at the same distance it is one in the cell's own
 * square, if there is one, and of those the first of the order. `count` is from 1 to the number of
 * cells; the steps are 0 for the first `count` cells, and at most half a side long along each axis.
 */
std::vector<glm::ivec2> GetNearestFirstCells(const BayerPattern& pattern, std::int64_t count);

} // namespace bravais

#endif
