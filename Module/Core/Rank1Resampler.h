// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Rank1Resampler_h
#define Rank1Resampler_h

#include "CellCoverage.h"
#include "Rank1Lattice.h"
#include "RoundTo.h"

#include <glm/vec2.hpp>

#include <cstdint>
#include <vector>

namespace bravais
{

/// Where a texel's value comes from.
enum class Rank1Filter
{
  Box,      ///< exact mean over the Voronoi cell of pixels of constant value
  Bilinear, ///< at the texel's point, between the centres of 2 x 2 pixels
  Bicubic,  ///< Catmull-Rom, of 4 x 4 pixels
  Nearest   ///< the pixel that the point is in
};

/// What is beyond the picture's border.
enum class Rank1Boundary
{
  Periodic, ///< the picture again
  Clamp,    ///< the pixel at the border
  Mirror    ///< the picture's mirror image; the border pixel counts twice
};

/**
 * Samples a picture of width x height pixels at the texels of S x T tiles of a lattice (section 5.3
 * of Dammertz, Dammertz, Keller and Lensch, Textures on Rank-1 Lattices). The picture spans all
 * tiles from edge to edge, so texel 0 is at a corner of a pixel, not at a centre. Each level of a
 * pyramid is one of these.
 */
class Rank1Resampler
{
public:
  /// The lattice's size is that of one tile, in any unit: it tells a pixel's shape, and so the
  /// cell's.
  Rank1Resampler(const Rank1Lattice& lattice, const glm::ivec2& tiles, const glm::ivec2& pixels,
    Rank1Filter filter, Rank1Boundary boundary);

  /// What Execute works in; one for each thread.
  using Scratch = std::vector<double>;

  /// How many pixels, about, a texel takes: what a texel costs.
  double GetPixelsPerTexel() const { return this->Cell.GetArea(); }

  /// Texels first .. last - 1 of a tile, from pixels in rows of width, the lowest first, with their
  /// components together. Arithmetic is in double precision. Pixels of no weight are not read, so
  /// that one that is not a number spoils only texels that it is a part of.
  template <class T>
  void Execute(const T* pixels, int components, const glm::ivec2& tile, std::int64_t first,
    std::int64_t last, T* texels) const;

private:
  /// Up to four pixels along an axis, and their weights.
  struct Taps
  {
    int Pixels[4];
    double Weights[4];
    int Count;
  };

  int Wrap(int pixel, int axis) const;
  Taps FindTaps(double position, int axis) const;
  bool IsInside(int y, int x, int count) const
  {
    return y >= 0 && y < this->Pixels.y && x >= 0 && x + count <= this->Pixels.x;
  }

  template <int Fixed, class T>
  void SumCell(const T* pixels, int components, const glm::dvec2& center, CellCoverage::Row& row,
    double* sum) const;
  template <int Fixed, class T>
  void SumTaps(const T* pixels, int components, const glm::dvec2& center, double* sum) const;
  template <int Fixed, class T>
  void ExecuteFixed(const T* pixels, int components, const glm::ivec2& tile, std::int64_t first,
    std::int64_t last, T* texels) const;

  Rank1Lattice Lattice;
  glm::dvec2 PixelsPerTile;
  glm::ivec2 Pixels;
  Rank1Filter Filter;
  Rank1Boundary Boundary;
  CellCoverage Cell;
};

//------------------------------------------------------------------------------
inline int Rank1Resampler::Wrap(int pixel, int axis) const
{
  const int last = this->Pixels[axis] - 1;
  if (pixel >= 0 && pixel <= last)
  {
    return pixel;
  }
  switch (this->Boundary)
  {
    case Rank1Boundary::Periodic:
      return static_cast<int>(Modulo(pixel, last + 1));
    case Rank1Boundary::Clamp:
      return pixel < 0 ? 0 : last;
    default:
    {
      const auto rest = static_cast<int>(Modulo(pixel, 2 * (std::int64_t{ last } + 1)));
      return rest > last ? 2 * last + 1 - rest : rest;
    }
  }
}

//------------------------------------------------------------------------------
template <int Fixed, class T>
void Rank1Resampler::SumCell(const T* pixels, int components, const glm::dvec2& center,
  CellCoverage::Row& row, double* sum) const
{
  constexpr double none = 1e-14; // of a cell: rounding
  const int number = Fixed ? Fixed : components;
  this->Cell.ForEachRow(center, row,
    [&](int y, int x, int count, const double* weights)
    {
      const bool inside = this->IsInside(y, x, count);
      const T* line =
        pixels + std::int64_t{ components } * this->Pixels.x * (inside ? y : this->Wrap(y, 1));
      for (int i = 0; i < count; ++i)
      {
        const double weight = weights[i];
        if (weight > none)
        {
          const T* pixel =
            line + std::int64_t{ components } * (inside ? x + i : this->Wrap(x + i, 0));
          for (int c = 0; c < number; ++c)
          {
            sum[c] += weight * static_cast<double>(pixel[c]);
          }
        }
      }
    });
}

//------------------------------------------------------------------------------
template <int Fixed, class T>
void Rank1Resampler::SumTaps(
  const T* pixels, int components, const glm::dvec2& center, double* sum) const
{
  const int count = Fixed ? Fixed : components;
  const Taps columns = this->FindTaps(center.x, 0);
  const Taps rows = this->FindTaps(center.y, 1);
  for (int j = 0; j < rows.Count; ++j)
  {
    const T* line = pixels + std::int64_t{ components } * this->Pixels.x * rows.Pixels[j];
    for (int i = 0; i < columns.Count; ++i)
    {
      const double weight = rows.Weights[j] * columns.Weights[i];
      const T* pixel = line + std::int64_t{ components } * columns.Pixels[i];
      for (int c = 0; c < count && weight != 0.0; ++c)
      {
        sum[c] += weight * static_cast<double>(pixel[c]);
      }
    }
  }
}

//------------------------------------------------------------------------------
template <int Fixed, class T>
void Rank1Resampler::ExecuteFixed(const T* pixels, int components, const glm::ivec2& tile,
  std::int64_t first, std::int64_t last, T* texels) const
{
  CellCoverage::Row row = this->Cell.MakeRow();
  const int count = Fixed ? Fixed : components;
  std::vector<double> sums(count);
  double* sum = sums.data();
  const std::int64_t n = this->Lattice.GetNumberOfPoints();
  const Rank1Lattice::Vector g = this->Lattice.GetGenerator();
  const glm::dvec2 corner = glm::dvec2(tile) * this->PixelsPerTile;
  const glm::dvec2 scale = this->PixelsPerTile / static_cast<double>(n);
  Rank1Lattice::Vector point = this->Lattice.GetGridPoint(first);
  for (std::int64_t i = first; i < last; ++i)
  {
    const glm::dvec2 center = corner + glm::dvec2(point) * scale;
    point += g;
    point.x -= point.x >= n ? n : 0;
    point.y -= point.y >= n ? n : 0;
    if (this->Filter == Rank1Filter::Nearest)
    {
      const std::int64_t x = this->Wrap(static_cast<int>(center.x), 0);
      const std::int64_t y = this->Wrap(static_cast<int>(center.y), 1);
      texels = std::copy_n(pixels + count * (x + this->Pixels.x * y), count, texels);
      continue;
    }
    std::fill_n(sum, count, 0.0);
    if (this->Filter == Rank1Filter::Box)
    {
      this->SumCell<Fixed>(pixels, count, center, row, sum);
    }
    else
    {
      this->SumTaps<Fixed>(pixels, count, center, sum);
    }
    for (int c = 0; c < count; ++c)
    {
      *texels++ = RoundTo<T>(sum[c]);
    }
  }
}

//------------------------------------------------------------------------------
template <class T>
void Rank1Resampler::Execute(const T* pixels, int components, const glm::ivec2& tile,
  std::int64_t first, std::int64_t last, T* texels) const
{
  switch (components) // loops of known length are no loops
  {
    case 1:
      this->ExecuteFixed<1>(pixels, components, tile, first, last, texels);
      break;
    case 3:
      this->ExecuteFixed<3>(pixels, components, tile, first, last, texels);
      break;
    case 4:
      this->ExecuteFixed<4>(pixels, components, tile, first, last, texels);
      break;
    default:
      this->ExecuteFixed<0>(pixels, components, tile, first, last, texels);
  }
}

} // namespace bravais

#endif
