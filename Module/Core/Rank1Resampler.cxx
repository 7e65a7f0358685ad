// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rank1Resampler.h"

namespace bravais
{

namespace
{

/// The Voronoi cell, in pixels.
CellCoverage MakeCell(const Rank1Lattice& lattice, const glm::dvec2& pixelsPerTile)
{
  std::array<glm::dvec2, 6> corners = lattice.GetVoronoiCell();
  for (glm::dvec2& corner : corners)
  {
    corner *= pixelsPerTile / static_cast<double>(lattice.GetNumberOfPoints());
  }
  return CellCoverage(corners);
}

} // namespace

//------------------------------------------------------------------------------
Rank1Resampler::Rank1Resampler(const Rank1Lattice& lattice, const glm::ivec2& tiles,
  const glm::ivec2& pixels, Rank1Filter filter, Rank1Boundary boundary)
  : Lattice(lattice)
  , PixelsPerTile(glm::dvec2(pixels) / glm::dvec2(tiles))
  , Pixels(pixels)
  , Filter(filter)
  , Boundary(boundary)
  , Cell(MakeCell(lattice, PixelsPerTile))
{
}

//------------------------------------------------------------------------------
Rank1Resampler::Taps Rank1Resampler::FindTaps(double position, int axis) const
{
  const double p = position - 0.5; // centres at the integers
  int first = static_cast<int>(p);
  first -= first > p ? 1 : 0; // rounded down
  const double f = p - first;
  Taps taps;
  if (this->Filter == Rank1Filter::Bilinear)
  {
    taps.Count = 2;
    taps.Weights[0] = 1.0 - f;
    taps.Weights[1] = f;
  }
  else // Catmull and Rom's cubic
  {
    taps.Count = 4;
    --first;
    taps.Weights[0] = ((-0.5 * f + 1.0) * f - 0.5) * f;
    taps.Weights[1] = (1.5 * f - 2.5) * f * f + 1.0;
    taps.Weights[2] = ((-1.5 * f + 2.0) * f + 0.5) * f;
    taps.Weights[3] = (0.5 * f - 0.5) * f * f;
  }
  for (int i = 0; i < taps.Count; ++i)
  {
    taps.Pixels[i] = this->Wrap(first + i, axis);
  }
  return taps;
}

} // namespace bravais
