// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef BayerPattern_h
#define BayerPattern_h

#include <glm/vec3.hpp>

#include <cstdint>
#include <optional>
#include <vector>

namespace bravais
{

/**
 * Bayer's recursive order of the cells of a square or cube whose side is a power of two.
 *
 * The cells of the 2 x 2 square, or of the 2 x 2 x 2 cube, have a base order. A pattern of twice
 * the side n is made of 2^d copies of the pattern in d dimensions, one a corner e of the base,
 * which take turns: rank'(c + n e) = 2^d rank(c) + base(e). It follows that the first 2^(d j) cells
 * of the order are a Cartesian lattice, and those after them shifted copies of it, as far from each
 * other as the base order has them.
 *
 * All base orders here are linear over the field of two elements: the rank of the exclusive or of
 * two cells is that of their ranks. A rank is therefore one number a coordinate, combined by
 * exclusive or, and no table of cells is needed:
 *   rank(x, y, z) = GetAxisRank(0, x) ^ GetAxisRank(1, y) ^ GetAxisRank(2, z).
 *
 * References: B. E. Bayer, "An optimum method for two-level rendition of continuous-tone
 * pictures", ICC 1973, for two dimensions.
 */
class BayerPattern
{
public:
  /// The orders of the cube's cells, written xyz.
  enum class Base
  {
    FCC, ///< 000 110 101 011 111 001 010 100: the even cells first, a face-centred cubic lattice
    BCC  ///< 000 111 110 001 101 010 011 100: antipodes in turn, body-centred cubic lattices
  };

  /// Of so many dimensions: coordinates fit int, and ranks 63 bits.
  static constexpr int GetMaximumLog2Size(int dimension) { return dimension == 2 ? 29 : 20; }

  /// A pattern of 2 or 3 dimensions and of side 2^log2Size, log2Size from 0 to the maximum. In two
  /// dimensions the base order is 00 11 10 01, and `base` is not used.
  static std::optional<BayerPattern> Create(int dimension, int log2Size, Base base = Base::FCC);

  int GetDimension() const { return this->Dimension; }
  int GetLog2Size() const { return this->Log2Size; }
  int GetLog2NumberOfCells() const { return this->Dimension * this->Log2Size; }
  std::int64_t GetSize() const { return std::int64_t{ 1 } << this->Log2Size; }
  std::int64_t GetNumberOfCells() const
  {
    return std::int64_t{ 1 } << this->GetLog2NumberOfCells();
  }

  /// What a coordinate adds to a rank. Any integer will do: the pattern is periodic. In two
  /// dimensions the third axis adds nothing.
  std::int64_t GetAxisRank(int axis, std::int64_t coordinate) const;

  /// The rank of a cell, 0 .. cells - 1, and the cell of a rank.
  std::int64_t GetRank(const glm::ivec3& cell) const;
  glm::ivec3 GetCell(std::int64_t rank) const;

  /// Place of a cell in an array of the pattern, x fastest.
  std::int64_t ToLinear(const glm::ivec3& cell) const
  {
    return cell.x + ((cell.y + (std::int64_t{ cell.z } << this->Log2Size)) << this->Log2Size);
  }

private:
  BayerPattern(int dimension, int log2Size, Base base);

  int Dimension;
  int Log2Size;
  Base Order;
};

/// The rank of each cell, x fastest.
std::vector<std::int64_t> GetThresholds(const BayerPattern& pattern);

/// Its inverse: the cell, as a place in the array of thresholds, of each rank.
std::vector<std::int64_t> GetOrder(const BayerPattern& pattern);

} // namespace bravais

#endif
