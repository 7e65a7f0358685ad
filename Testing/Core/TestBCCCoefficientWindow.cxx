// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "BCCCoefficientWindow.h"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

using namespace bravais;

namespace
{

const BCCExtent Padded = { -2, 3, -1, 3, -3, 44 }; // 6 x 5 indices, 48 layers
constexpr int LayerSize = 30;

/// Layer k of component c is filled with 100 k + c.
void Fill(BCCCoefficientWindow<float>& window)
{
  for (int k = window.GetFirstMissing(); k <= window.GetLast(); ++k)
  {
    for (std::size_t c = 0; c < window.GetPlanes().size(); ++c)
    {
      std::fill_n(window.GetPlanes()[c].GetRow(-1, k), LayerSize, 100.0f * k + c);
    }
  }
}

void CheckLayers(const BCCCoefficientWindow<float>& window, int low, int high, int components)
{
  for (int c = 0; c < components; ++c)
  {
    const BCCBlock<const float> plane = window.GetPlane(c);
    ASSERT_EQ(plane.Extent, (BCCExtent{ -2, 3, -1, 3, low, high }));
    for (int k = low; k <= high; ++k)
    {
      ASSERT_EQ(*plane.GetRow(-1, k), 100.0f * k + c);
      ASSERT_EQ(plane.GetRow(3, k)[5], 100.0f * k + c);
    }
  }
}

} // namespace

TEST(TestBCCCoefficientWindow, HoldsAsManyLayersAsMemoryAllows)
{
  const double layer = LayerSize * sizeof(float);
  EXPECT_EQ(BCCCoefficientWindow<float>(Padded, 1, 20.5 * layer).GetCapacity(), 20);
  EXPECT_EQ(BCCCoefficientWindow<float>(Padded, 2, 30.5 * layer).GetCapacity(), 15);
  EXPECT_EQ(BCCCoefficientWindow<double>(Padded, 1, 30.5 * layer).GetCapacity(), 15);
  EXPECT_EQ(BCCCoefficientWindow<float>(Padded, 1, 0.0).GetCapacity(), 10);
  EXPECT_EQ(BCCCoefficientWindow<float>(Padded, 3, layer).GetCapacity(), 10);
  EXPECT_EQ(BCCCoefficientWindow<float>(Padded, 1, 1e12).GetCapacity(), 48);
  EXPECT_EQ(BCCCoefficientWindow<float>({ 0, 4, 0, 4, 0, 7 }, 1, 0.0).GetCapacity(), 8);
}

TEST(TestBCCCoefficientWindow, KeepsLayersThatStayInIt)
{
  for (const int components : { 1, 3 })
  {
    BCCCoefficientWindow<float> window(Padded, components, 0.0);
    EXPECT_EQ(window.GetPlanes().size(), static_cast<std::size_t>(components));
    const std::pair<int, int> steps[] = { { -3, 4 }, { -3, 6 }, { 0, 8 }, { 0, 8 }, { 8, 16 },
      { 9, 16 }, { 17, 24 }, { 35, 44 } };
    const int missing[] = { -3, 5, 7, 9, 9, 17, 17, 35 };
    for (int n = 0; n < 8; ++n)
    {
      window.MoveTo(steps[n].first, steps[n].second);
      EXPECT_EQ(window.GetFirstMissing(), missing[n]);
      EXPECT_EQ(window.GetLast(), steps[n].second);
      Fill(window);
      CheckLayers(window, steps[n].first, steps[n].second, components);
    }
  }
}

TEST(TestBCCCoefficientWindow, CanStartAnywhere)
{
  BCCCoefficientWindow<float> window(Padded, 1, 0.0);
  window.MoveTo(20, 29);
  EXPECT_EQ(window.GetFirstMissing(), 20);
  Fill(window);
  CheckLayers(window, 20, 29, 1);
}
