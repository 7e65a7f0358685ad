// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause

#include "BayerPattern.h"

#include <array>

namespace bravais
{
namespace
{

/// A base order, which is linear, by the ranks of the unit steps along x, y and z and by the cells
/// (x + 2 y + 4 z) of ranks 1, 2 and 4.
struct BaseOrder
{
  std::array<int, 3> Ranks;
  std::array<int, 3> Cells;
};

constexpr BaseOrder Square = { { 2, 3, 0 }, { 3, 1, 0 } };
constexpr BaseOrder FaceCentred = { { 7, 6, 5 }, { 3, 5, 7 } };
constexpr BaseOrder BodyCentred = { { 7, 5, 3 }, { 7, 3, 5 } };

const BaseOrder& GetBaseOrder(int dimension, BayerPattern::Base base)
{
  if (dimension == 2)
  {
    return Square;
  }
  return base == BayerPattern::Base::FCC ? FaceCentred : BodyCentred;
}

} // namespace

std::optional<BayerPattern> BayerPattern::Create(int dimension, int log2Size, Base base)
{
  if (dimension < 2 || dimension > 3 || log2Size < 0 || log2Size > GetMaximumLog2Size(dimension))
  {
    return std::nullopt;
  }
  return BayerPattern(dimension, log2Size, base);
}

BayerPattern::BayerPattern(int dimension, int log2Size, Base base)
  : Dimension(dimension)
  , Log2Size(log2Size)
  , Order(base)
{
}

std::int64_t BayerPattern::GetAxisRank(int axis, std::int64_t coordinate) const
{
  const std::int64_t step = GetBaseOrder(this->Dimension, this->Order).Ranks[axis];
  std::int64_t rank = 0;
  for (int bit = 0; bit < this->Log2Size; ++bit)
  {
    rank = (rank << this->Dimension) | (((coordinate >> bit) & 1) ? step : 0);
  }
  return rank;
}

std::int64_t BayerPattern::GetRank(const glm::ivec3& cell) const
{
  return this->GetAxisRank(0, cell.x) ^ this->GetAxisRank(1, cell.y) ^ this->GetAxisRank(2, cell.z);
}

glm::ivec3 BayerPattern::GetCell(std::int64_t rank) const
{
  const BaseOrder& base = GetBaseOrder(this->Dimension, this->Order);
  glm::ivec3 cell(0);
  for (int bit = this->Log2Size - 1; bit >= 0; --bit)
  {
    int place = 0;
    for (int digit = 0; digit < this->Dimension; ++digit)
    {
      place ^= ((rank >> digit) & 1) ? base.Cells[digit] : 0;
    }
    cell += glm::ivec3(place & 1, (place >> 1) & 1, place >> 2) << bit;
    rank >>= this->Dimension;
  }
  return cell;
}

std::vector<std::int64_t> GetThresholds(const BayerPattern& pattern)
{
  std::vector<std::int64_t> ranks;
  ranks.reserve(static_cast<std::size_t>(pattern.GetNumberOfCells()));
  const std::int64_t size = pattern.GetSize();
  const std::int64_t layers = pattern.GetDimension() == 3 ? size : 1;
  std::vector<std::int64_t> row;
  for (std::int64_t x = 0; x < size; ++x)
  {
    row.push_back(pattern.GetAxisRank(0, x));
  }
  for (std::int64_t z = 0; z < layers; ++z)
  {
    for (std::int64_t y = 0; y < size; ++y)
    {
      const std::int64_t other = pattern.GetAxisRank(1, y) ^ pattern.GetAxisRank(2, z);
      for (const std::int64_t rank : row)
      {
        ranks.push_back(rank ^ other);
      }
    }
  }
  return ranks;
}

std::vector<std::int64_t> GetOrder(const BayerPattern& pattern)
{
  const std::vector<std::int64_t> ranks = GetThresholds(pattern);
  std::vector<std::int64_t> cells(ranks.size());
  for (std::size_t cell = 0; cell < ranks.size(); ++cell)
  {
    cells[static_cast<std::size_t>(ranks[cell])] = static_cast<std::int64_t>(cell);
  }
  return cells;
}

} // namespace bravais
