// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Rank1TileRows_h
#define Rank1TileRows_h

#include "CellCoverage.h"
#include "PictureRows.h"
#include "Rank1Levels.h"
#include "RoundTo.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace bravais
{

/// Texels of a member of an r-set, computed from the rows of the picture that are at hand: those
/// whose points lie in a range of rows, whose cells reach over some rows more on either side.
class Rank1TileRows
{
public:
  Rank1TileRows(const Rank1LevelPlan& plan, const PictureRows& picture);

  /// Pixels that a cell reaches up and down from its texel.
  int GetReach() const { return this->Reach; }

  int GetColumns() const { return this->Tiles.x; }

  /// Texels of rows of tiles whose points lie in rows first .. last - 1 of the picture, of type T,
  /// by Rank1Filter::Box, in parallel; bit by bit those of Rank1Resampler, rounded to F. place(x,
  /// y) is where the first texel of a tile goes.
  template <class T, class F, class Place>
  void Execute(const PictureRows& picture, int first, int last, const int tileRows[2],
    const Place& place) const;

  /// Rows of tiles that have such texels: first, last + 1.
  void GetTileRows(int first, int last, int tileRows[2]) const;

  /// Whether all texels of a row of tiles lie below a row of pixels.
  bool IsComplete(int tileRow, int row) const
  {
    return (tileRow + 1) * this->PixelsPerTile.y <= row;
  }

private:
  template <class T>
  void SumCell(const PictureRows& picture, const glm::dvec2& center, CellCoverage::Row& row,
    double* sum) const;

  Rank1Lattice Lattice;
  glm::ivec2 Tiles;
  glm::dvec2 PixelsPerTile;
  CellCoverage Cell;
  int Reach;
  std::vector<std::int64_t> Order; ///< of texels, by v
  std::vector<double> Heights;     ///< v of these
};

//------------------------------------------------------------------------------
template <class T>
void Rank1TileRows::SumCell(
  const PictureRows& picture, const glm::dvec2& center, CellCoverage::Row& row, double* sum) const
{
  constexpr double none = 1e-14; // of a cell: rounding
  const int components = picture.GetNumberOfComponents();
  this->Cell.ForEachRow(center, row,
    [&](int y, int x, int count, const double* weights)
    {
      // At the last of the cell, rounding may touch a row more, with no weight.
      const bool inside = x >= 0 && x + count <= picture.GetWidth();
      const T* line = nullptr;
      for (int i = 0; i < count; ++i)
      {
        const double weight = weights[i];
        if (weight > none)
        {
          line = line ? line : reinterpret_cast<const T*>(picture.GetRow(y));
          const T* pixel =
            line + std::int64_t{ components } * (inside ? x + i : picture.WrapColumn(x + i));
          for (int c = 0; c < components; ++c)
          {
            sum[c] += weight * static_cast<double>(pixel[c]);
          }
        }
      }
    });
}

//------------------------------------------------------------------------------
template <class T, class F, class Place>
void Rank1TileRows::Execute(
  const PictureRows& picture, int first, int last, const int tileRows[2], const Place& place) const
{
  const int components = picture.GetNumberOfComponents();
  for (int y = tileRows[0]; y < tileRows[1]; ++y)
  {
    const auto below = [&](double border)
    {
      return std::partition_point(this->Heights.begin(), this->Heights.end(),
               [&](double v) { return (y + v) * this->PixelsPerTile.y < border; }) -
        this->Heights.begin();
    };
    const vtkIdType from = below(first);
    const vtkIdType to = below(last);
    constexpr vtkIdType run = 512;
    const vtkIdType runs = (to - from + run - 1) / run;
    vtkSMPTools::For(0, runs * this->Tiles.x, 1,
      [&](vtkIdType begin, vtkIdType end)
      {
        CellCoverage::Row row = this->Cell.MakeRow();
        std::vector<double> sum(components);
        for (vtkIdType item = begin; item < end; ++item)
        {
          const auto x = static_cast<int>(item / runs);
          const vtkIdType start = from + item % runs * run;
          F* texels = place(x, y);
          for (vtkIdType k = start; k < std::min(to, start + run); ++k)
          {
            const std::int64_t i = this->Order[k];
            std::fill(sum.begin(), sum.end(), 0.0);
            this->SumCell<T>(picture,
              (glm::dvec2(x, y) + this->Lattice.GetPoint(i)) * this->PixelsPerTile, row,
              sum.data());
            for (int c = 0; c < components; ++c)
            {
              texels[i * components + c] = RoundTo<F>(sum[c]);
            }
          }
        }
      });
  }
}

} // namespace bravais

#endif
