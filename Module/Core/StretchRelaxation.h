// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef StretchRelaxation_h
#define StretchRelaxation_h

#include "SurfaceParameters.h"

#include <vector>

namespace bravais
{

/// Moves each free vertex in turn to where the distortion of the triangles round it is least, see
/// DistortionFactor, by one Newton step that is halved until it falls. No triangle is ever turned
/// over. Returns how much was removed.
double RelaxStretch(const TriangleTopology& mesh, const std::vector<TriangleShape>& shapes,
  SurfaceParameters& parameters);

} // namespace bravais

#endif
