// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rank1Level.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace
{

constexpr double Infinity = std::numeric_limits<double>::infinity();

/// Member for a footprint along u and v of so many base texels.
glm::ivec2 Member(double width, double height, int columns = 5, int rows = 5)
{
  const glm::dvec2 density(64.0, 64.0);
  const glm::dvec4 footprint(width / 64.0, 0.0, 0.0, height / 64.0);
  return bravais::GetRank1Member(
    bravais::GetRank1MemberLevel(footprint, density), glm::ivec2(columns, rows));
}

} // namespace

TEST(Rank1Level, DensityIsPixelsAlongTheSidesOfAPictureOfSquareTexels)
{
  EXPECT_EQ(bravais::GetRank1Density({ 1.0, 1.0 }, 4096.0), glm::dvec2(64.0, 64.0));
  EXPECT_EQ(bravais::GetRank1Density({ 8.0, 2.0 }, 4096.0), glm::dvec2(128.0, 32.0));
}

TEST(Rank1Level, LevelsOfTheSamplingText)
{
  // "du/dx, dv/dx, du/dy, dv/dy are all 1: L = sqrt 2" and so on, in texels.
  const glm::dvec2 density(1.0, 1.0);
  const double all[] = { 1.0, 2.0, 4.0, 8.0 };
  for (int level = 0; level < 4; ++level)
  {
    const double D = bravais::GetRank1MipLevel(glm::dvec4(all[level]), density);
    EXPECT_DOUBLE_EQ(D, level + 0.5);
    EXPECT_EQ(bravais::GetNearestRank1Level(D, 9), level);
  }
  const double D = bravais::GetRank1MipLevel({ 1.0, 1.0, 8.0, 10.0 }, density);
  EXPECT_NEAR(D, std::log2(std::sqrt(164.0)), 1e-12);
}

TEST(Rank1Level, TheLongerAxisIsMeasuredInTexelSpacings)
{
  const glm::dvec2 density = bravais::GetRank1Density({ 4.0, 1.0 }, 16384.0); // 256 x 64
  EXPECT_DOUBLE_EQ(bravais::GetRank1MipLevel({ 8.0 / 256.0, 0.0, 0.0, 2.0 / 64.0 }, density), 3.0);
  EXPECT_DOUBLE_EQ(bravais::GetRank1MipLevel({ 2.0 / 256.0, 0.0, 0.0, 8.0 / 64.0 }, density), 3.0);
  EXPECT_DOUBLE_EQ(
    bravais::GetRank1MipLevel({ 3.0 / 256.0, 4.0 / 64.0, 0.0, 0.0 }, density), std::log2(5.0));
}

TEST(Rank1Level, LevelsAreClamped)
{
  EXPECT_EQ(bravais::GetNearestRank1Level(-Infinity, 4), 0);
  EXPECT_EQ(bravais::GetNearestRank1Level(-3.0, 4), 0);
  EXPECT_EQ(bravais::GetNearestRank1Level(0.5, 4), 0);
  EXPECT_EQ(bravais::GetNearestRank1Level(0.5001, 4), 1);
  EXPECT_EQ(bravais::GetNearestRank1Level(Infinity, 4), 3);
  EXPECT_EQ(bravais::GetNearestRank1Level(2.0, 1), 0);
}

TEST(Rank1Level, BlendsAreContinuousAndEndAtTheLastLevel)
{
  for (const int levels : { 1, 2, 5 })
  {
    for (double D = -1.0; D <= levels + 1.0; D += 1.0 / 64.0)
    {
      const auto blend = bravais::GetRank1LevelBlend(D, levels);
      EXPECT_GE(blend.Lower, 0);
      EXPECT_LT(blend.Upper, levels);
      EXPECT_GE(blend.Weight, 0.0);
      EXPECT_LE(blend.Weight, 1.0);
      const double level = blend.Lower + blend.Weight * (blend.Upper - blend.Lower);
      EXPECT_EQ(level, std::fmin(std::fmax(D, 0.0), levels - 1.0));
    }
  }
  EXPECT_EQ(bravais::GetRank1LevelBlend(-Infinity, 3).Weight, 0.0);
  EXPECT_EQ(bravais::GetRank1LevelBlend(Infinity, 3).Upper, 2);
}

TEST(Rank1Level, FootprintOfOneTexelOfAMemberIsThatMember)
{
  for (int i = 0; i < 5; ++i)
  {
    for (int j = 0; j < 5; ++j)
    {
      EXPECT_EQ(Member(1 << i, 1 << j), glm::ivec2(i, j));
      EXPECT_EQ(Member((1 << i) * 1.0005, (1 << j) * 1.0005), glm::ivec2(i, j)); // rounding
    }
  }
}

TEST(Rank1Level, MemberHasTheNearestRatioAndTheFirstTexelAsLarge)
{
  constexpr int columns = 5;
  constexpr int rows = 4;
  for (double u = 0.0351; u < 4.0; u += 0.17)
  {
    for (double v = 0.05; v < 3.0; v += 0.13)
    {
      const glm::ivec2 member = Member(std::exp2(u), std::exp2(v), columns, rows);
      int least = 100;
      for (int i = 0; i < columns; ++i)
      {
        for (int j = 0; j < rows; ++j)
        {
          const bool ratio = std::abs(i - j - (u - v)) < 0.5;
          least = ratio && i + j >= u + v - 0.004 ? std::min(least, i + j) : least;
        }
      }
      EXPECT_LE(std::abs(member.x - member.y - (u - v)), 0.5);
      // Where no member of that ratio is coarse enough, the coarsest.
      EXPECT_TRUE(member.x + member.y == least ||
        (least == 100 && (member.x == columns - 1 || member.y == rows - 1)));
    }
  }
}

TEST(Rank1Level, MembersOfFootprintsBeyondTheSet)
{
  EXPECT_EQ(Member(0.0, 0.0), glm::ivec2(0, 0));
  EXPECT_EQ(Member(0.01, 8.0), glm::ivec2(0, 3));
  EXPECT_EQ(Member(1e9, 2.0), glm::ivec2(4, 1));
  EXPECT_EQ(Member(1e9, 1e9, 3, 2), glm::ivec2(2, 1));
  EXPECT_EQ(Member(1e9, 1e9, 1, 1), glm::ivec2(0, 0));
  EXPECT_EQ(Member(1e9, 0.0, 1, 4), glm::ivec2(0, 0));
}

TEST(Rank1Level, EqualAxesAtRightAnglesHaveALevelThatTurningKeeps)
{
  const glm::dvec2 density(128.0, 128.0);
  for (int step = 0; step < 12; ++step)
  {
    const double c = std::cos(0.3 * step) / 16.0;
    const double s = std::sin(0.3 * step) / 16.0;
    const glm::dvec2 level = bravais::GetRank1MemberLevel({ c, s, -s, c }, density);
    EXPECT_NEAR(level.x, 3.0, 1e-12);
    EXPECT_NEAR(level.y, 3.0, 1e-12);
    EXPECT_NEAR(bravais::GetRank1MipLevel({ c, s, -s, c }, density), 3.0, 1e-12);
  }
}
