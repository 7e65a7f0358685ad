// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "RoundTo.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>

using bravais::RoundTo;

namespace
{

template <class T, class R>
void CheckEnds()
{
  using Limits = std::numeric_limits<T>;
  constexpr R infinity = std::numeric_limits<R>::infinity();
  EXPECT_EQ(RoundTo<T>(infinity), Limits::max());
  EXPECT_EQ(RoundTo<T>(-infinity), Limits::lowest());
  EXPECT_EQ(RoundTo<T>(std::numeric_limits<R>::max()), Limits::max());
  EXPECT_EQ(RoundTo<T>(std::numeric_limits<R>::lowest()), Limits::lowest());
  EXPECT_EQ(RoundTo<T>(static_cast<R>(Limits::max())), Limits::max());
  EXPECT_EQ(RoundTo<T>(static_cast<R>(Limits::lowest())), Limits::lowest());
  EXPECT_EQ(RoundTo<T>(std::numeric_limits<R>::quiet_NaN()), T(0));
  EXPECT_EQ(RoundTo<T>(R(0)), T(0));
  EXPECT_EQ(RoundTo<T>(R(-0.25)), T(0));
  EXPECT_EQ(RoundTo<T>(R(41.75)), T(42));
  EXPECT_EQ(RoundTo<T>(R(41.5)), T(42));
  EXPECT_EQ(RoundTo<T>(R(41.25)), T(41));
}

template <class T>
void CheckType()
{
  CheckEnds<T, float>();
  CheckEnds<T, double>();
}

} // namespace

TEST(TestRoundTo, ClampsToEveryIntegerType)
{
  CheckType<char>();
  CheckType<signed char>();
  CheckType<unsigned char>();
  CheckType<short>();
  CheckType<unsigned short>();
  CheckType<int>();
  CheckType<unsigned int>();
  CheckType<long>();
  CheckType<unsigned long>();
  CheckType<long long>();
  CheckType<unsigned long long>();
}

TEST(TestRoundTo, RoundsHalvesUpwards)
{
  EXPECT_EQ(RoundTo<int>(-1.5), -1);
  EXPECT_EQ(RoundTo<int>(-1.75), -2);
  EXPECT_EQ(RoundTo<int>(2.5), 3);
  EXPECT_EQ(RoundTo<short>(-1e-30f), 0);
}

// Their sum with 1/2 is no number of the type, so adding it first would be wrong.
TEST(TestRoundTo, RoundsWhereTheHalfIsLost)
{
  EXPECT_EQ(RoundTo<int>(std::nextafter(0.5f, 0.0f)), 0);
  EXPECT_EQ(RoundTo<int>(std::nextafter(0.5, 0.0)), 0);
  for (int n = (1 << 23) - 3; n < (1 << 23) + 9; ++n)
  {
    EXPECT_EQ(RoundTo<int>(static_cast<float>(n)), n);
    EXPECT_EQ(RoundTo<int>(static_cast<float>(-n)), -n);
  }
  for (std::int64_t n = (std::int64_t{ 1 } << 52) - 3; n < (std::int64_t{ 1 } << 52) + 9; ++n)
  {
    EXPECT_EQ(RoundTo<std::int64_t>(static_cast<double>(n)), n);
    EXPECT_EQ(RoundTo<std::int64_t>(static_cast<double>(-n)), -n);
  }
}

TEST(TestRoundTo, LeavesFloatingPointAlone)
{
  EXPECT_EQ(RoundTo<float>(0.3f), 0.3f);
  EXPECT_EQ(RoundTo<float>(0.3), 0.3f);
  EXPECT_EQ(RoundTo<double>(0.3f), static_cast<double>(0.3f));
  EXPECT_TRUE(std::isnan(RoundTo<double>(std::nan(""))));
  EXPECT_TRUE(std::isinf(RoundTo<float>(std::numeric_limits<float>::infinity())));
}
