// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef BrickDistances_h
#define BrickDistances_h

#include <glm/vec3.hpp>

#include <cstdint>
#include <vector>

namespace bravais
{

/// Chebyshev distances from every brick to the nearest marked one, up to 255, in the place of marks
/// that are not 0 (x fastest): 0 in marked bricks, d where all bricks less than d away along every
/// axis are unmarked. By one sweep forward and one backward, exact for this distance (A. Rosenfeld
/// and J. Pfaltz, Distance Functions on Digital Pictures).
void FindBrickDistances(const glm::ivec3& size, std::vector<std::uint8_t>& bricks);

/// Distances that tell of marked bricks as well: 128 + d in unmarked bricks, for d up to 127 as
/// above, and 128 - d in marked ones, where all bricks less than d away are marked, up to 128.
void FindSignedBrickDistances(const glm::ivec3& size, std::vector<std::uint8_t>& bricks);

} // namespace bravais

#endif
