// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "BCCPaddedLayer.h"

#include "BCCLattice.h"
#include "BCCQuasiInterpolation.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

using namespace bravais;

namespace
{

std::size_t Count(const BCCExtent& e)
{
  return static_cast<std::size_t>(e[1] - e[0] + 1) * static_cast<std::size_t>(e[3] - e[2] + 1) *
    static_cast<std::size_t>(e[5] - e[4] + 1);
}

template <class T>
std::vector<T> MakeSamples(const BCCExtent& whole, int components)
{
  std::mt19937 random(3);
  std::uniform_int_distribution<int> values(0, 100);
  std::vector<T> samples(Count(whole) * static_cast<std::size_t>(components));
  for (T& sample : samples)
  {
    sample = static_cast<T>(values(random));
  }
  return samples;
}

/// A block of one value at an index that may lie anywhere, by the mirrors of the lattice.
template <class R>
R Fetch(const BCCBlock<const R>& inside, const glm::ivec3& index, int component)
{
  const BCCExtent& e = inside.Extent;
  const glm::ivec3 p = BCCLattice::ToPoint(index);
  const glm::ivec3 low(2 * e[0], 2 * e[2], e[4]);
  const glm::ivec3 last(2 * e[1] + 1, 2 * e[3] + 1, e[5]);
  glm::ivec3 q;
  for (int axis = 0; axis < 3; ++axis)
  {
    q[axis] = low[axis] + BCCLattice::Mirror(p[axis] - low[axis], last[axis] - low[axis]);
  }
  const glm::ivec3 image = BCCLattice::ToIndex(q);
  return inside.GetRow(image.y, image.z)[(image.x - e[0]) * inside.Components + component];
}

template <class T>
void Check(const BCCExtent& whole, const BCCExtent& padded, BCCKernel kernel, bool local, int count)
{
  using R = BCCCoefficient<T>;
  const std::vector<T> memory = MakeSamples<T>(whole, count);
  const BCCBlock<const T> samples(memory.data(), whole, count);
  std::vector<R> inside(memory.begin(), memory.end());
  const BCCBlock<R> coefficients(inside.data(), whole, count);
  if (local)
  {
    ASSERT_TRUE(QuasiInterpolate(kernel, whole, samples, coefficients));
  }
  const BCCBlock<const R> expected(inside.data(), whole, count);

  std::vector<R> out(Count(padded) * static_cast<std::size_t>(count), R(-999));
  std::vector<BCCBlock<R>> planes;
  for (int c = 0; c < count; ++c)
  {
    planes.emplace_back(out.data() + static_cast<std::size_t>(c) * Count(padded), padded);
  }
  for (int k = padded[4]; k <= padded[5]; ++k)
  {
    FillPaddedLayer(kernel, local, whole, samples, k, planes);
  }
  for (int k = padded[4]; k <= padded[5]; ++k)
  {
    for (int j = padded[2]; j <= padded[3]; ++j)
    {
      for (int i = padded[0]; i <= padded[1]; ++i)
      {
        for (int c = 0; c < count; ++c)
        {
          ASSERT_EQ(planes[static_cast<std::size_t>(c)].GetRow(j, k)[i - padded[0]],
            Fetch(expected, { i, j, k }, c))
            << i << ", " << j << ", " << k << ", component " << c;
        }
      }
    }
  }
}

const BCCExtent Wholes[] = { { 0, 5, 0, 4, 0, 7 }, { -3, 2, 5, 8, 1, 6 }, { 2, 2, -1, -1, -3, -2 },
  { 0, 0, 0, 5, 3, 5 } };

} // namespace

TEST(TestBCCPaddedLayer, ContinuesTheWholeByItsMirrors)
{
  for (const BCCExtent& whole : Wholes)
  {
    const BCCExtent padded = { whole[0] - 3, whole[1] + 2, whole[2] - 2, whole[3] + 3, whole[4] - 5,
      whole[5] + 4 };
    for (const bool local : { false, true })
    {
      Check<float>(whole, padded, BCCKernel::BCC7, local, 1);
      Check<double>(whole, padded, BCCKernel::BCC12, local, 1);
      Check<unsigned char>(whole, padded, BCCKernel::BCC8, local, 3);
      Check<long long>(whole, padded, BCCKernel::BCC4, local, 2);
    }
  }
}

TEST(TestBCCPaddedLayer, FillsPartsInside)
{
  for (const bool local : { false, true })
  {
    Check<short>({ 0, 9, 0, 8, 0, 7 }, { 3, 6, 2, 5, 1, 4 }, BCCKernel::BCC7, local, 1);
    Check<short>({ 0, 9, 0, 8, 0, 7 }, { 3, 6, 2, 5, 1, 4 }, BCCKernel::BCC7, local, 2);
    // a corner and the mirror images that stencils there need
    Check<float>({ 0, 9, 0, 8, 1, 8 }, { 6, 11, -2, 3, 5, 10 }, BCCKernel::BCC12, local, 1);
  }
}

TEST(TestBCCPaddedLayer, FillsEveryType)
{
  const BCCExtent whole = { 0, 3, 0, 2, 0, 3 };
  const BCCExtent padded = { -2, 5, -2, 4, -3, 7 };
  Check<char>(whole, padded, BCCKernel::BCC7, true, 1);
  Check<signed char>(whole, padded, BCCKernel::BCC7, true, 1);
  Check<unsigned short>(whole, padded, BCCKernel::BCC7, true, 1);
  Check<int>(whole, padded, BCCKernel::BCC7, true, 1);
  Check<unsigned int>(whole, padded, BCCKernel::BCC7, true, 1);
  Check<long>(whole, padded, BCCKernel::BCC7, true, 1);
  Check<unsigned long>(whole, padded, BCCKernel::BCC7, true, 1);
  Check<unsigned long long>(whole, padded, BCCKernel::BCC7, true, 1);
}
