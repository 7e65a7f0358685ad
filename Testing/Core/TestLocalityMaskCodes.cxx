// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause

// The codes of locality masks: what is decoded is what was coded, and unions of codes are unions.

#include "BitMask.h"
#include "RoaringCode.h"
#include "RunLengthCode.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace
{

using Bytes = std::vector<std::uint8_t>;
using Places = std::vector<std::uint32_t>;

Bytes Encode(const Bytes& bytes)
{
  Bytes code;
  bravais::AppendRunLengthCode(bytes.data(), bytes.size(), code);
  return code;
}

void Append(Bytes& bytes, std::size_t count, std::uint8_t byte)
{
  bytes.insert(bytes.end(), count, byte);
}

/// Places with a given share of gixels set, in runs of a given mean length.
Places MakePlaces(std::uint32_t gixels, double share, double run, unsigned int seed)
{
  std::mt19937 generator(seed);
  std::geometric_distribution<std::uint32_t> set(1.0 / run);
  std::geometric_distribution<std::uint32_t> gap(share / (run * (1.0 - share) + share));
  Places places;
  for (std::uint64_t place = gap(generator); place < gixels; place += gap(generator) + 1)
  {
    for (std::uint32_t n = set(generator) + 1; n && place < gixels; --n)
    {
      places.push_back(static_cast<std::uint32_t>(place++));
    }
  }
  return places;
}

std::vector<Places> MakeMasks(std::uint32_t gixels)
{
  std::vector<Places> masks{ {}, { 0 }, { gixels - 1 }, { 0, gixels - 1 } };
  for (const double share : { 0.001, 0.1, 0.5, 0.9 })
  {
    for (const double run : { 1.0, 3.0, 50.0, 3000.0 })
    {
      masks.push_back(MakePlaces(gixels, share, run, static_cast<unsigned int>(masks.size())));
    }
  }
  masks.emplace_back(gixels);
  for (std::uint32_t gixel = 0; gixel < gixels; ++gixel)
  {
    masks.back()[gixel] = gixel;
  }
  return masks;
}

Bytes ToValues(const Places& places, std::uint32_t gixels)
{
  Bytes values(gixels);
  for (const std::uint32_t place : places)
  {
    values[place] = 1;
  }
  return values;
}

} // namespace

TEST(TestLocalityMaskCodes, RunsAreTheByteTwiceAndTheirLength)
{
  EXPECT_EQ(Encode({}), Bytes{});
  EXPECT_EQ(Encode({ 7 }), Bytes{ 7 });
  EXPECT_EQ(Encode({ 7, 7 }), (Bytes{ 7, 7, 2, 0 }));
  EXPECT_EQ(Encode({ 1, 2, 2, 2, 3, 4, 4 }), (Bytes{ 1, 2, 2, 3, 0, 3, 4, 4, 2, 0 }));
  Bytes bytes;
  Append(bytes, 300, 9);
  EXPECT_EQ(Encode(bytes), (Bytes{ 9, 9, 0x2c, 1 }));
}

TEST(TestLocalityMaskCodes, LongRunsAreSeveral)
{
  for (const std::size_t extra : { 0, 1, 2, 65535, 65536, 65537 })
  {
    Bytes bytes;
    Append(bytes, 65535 + extra, 5);
    const Bytes code = Encode(bytes);
    const std::size_t rest = extra % 65535;
    EXPECT_EQ(code.size(), 4 * (1 + extra / 65535) + (rest > 1 ? 4 : rest)) << extra;
    EXPECT_EQ(Bytes(code.begin(), code.begin() + 4), (Bytes{ 5, 5, 0xff, 0xff }));
    EXPECT_EQ(bravais::DecodeRunLength(code.data(), code.size(), bytes.size()), bytes);
  }
}

TEST(TestLocalityMaskCodes, RunsAreDecoded)
{
  std::mt19937 generator(1);
  for (int trial = 0; trial < 200; ++trial)
  {
    Bytes bytes;
    while (bytes.size() < 500)
    {
      Append(bytes, 1 + generator() % 4, static_cast<std::uint8_t>(generator() % 3));
    }
    const Bytes code = Encode(bytes);
    EXPECT_EQ(bravais::DecodeRunLength(code.data(), code.size(), bytes.size()), bytes);
    EXPECT_FALSE(bravais::DecodeRunLength(code.data(), code.size(), bytes.size() - 1));
    EXPECT_FALSE(bravais::DecodeRunLength(code.data(), code.size(), bytes.size() + 1));
    EXPECT_FALSE(bravais::DecodeRunLength(code.data(), code.size() - 1, bytes.size()));
  }
}

TEST(TestLocalityMaskCodes, BrokenRunsAreRefused)
{
  for (const Bytes& code :
    { Bytes{ 1, 1 }, Bytes{ 1, 1, 2 }, Bytes{ 1, 1, 0, 0 }, Bytes{ 1, 1, 3, 0 } })
  {
    EXPECT_FALSE(bravais::DecodeRunLength(code.data(), code.size(), 2));
  }
}

TEST(TestLocalityMaskCodes, PlacesAndBytesHaveTheSameCode)
{
  for (const std::uint32_t gixels : { 1U, 7U, 8U, 9U, 66049U, 140001U })
  {
    for (const Places& places : MakeMasks(gixels))
    {
      const Bytes values = ToValues(places, gixels);
      const Bytes bits = bravais::PackBits(values.data(), gixels);
      Bytes code;
      bravais::AppendRunLengthCode(places.data(), places.size(), gixels, code);
      EXPECT_EQ(code, Encode(bits));

      Bytes painted(gixels);
      bravais::PaintRunLengthCode(code.data(), code.data() + code.size(), gixels, painted.data());
      EXPECT_EQ(painted, values);
      Bytes united(bits.size());
      bravais::OrRunLengthCode(code.data(), code.data() + code.size(), united.data());
      EXPECT_EQ(united, bits);
    }
  }
}

TEST(TestLocalityMaskCodes, RoaringPaintsItsPlaces)
{
  for (const std::uint32_t gixels : { 1U, 9U, 65536U, 65537U, 66049U, 400000U })
  {
    for (const Places& places : MakeMasks(gixels))
    {
      Bytes code;
      bravais::AppendRoaringCode(places.data(), places.size(), code);
      Bytes painted(gixels);
      bravais::PaintRoaringCode(code.data(), code.data() + code.size(), painted.data());
      EXPECT_EQ(painted, ToValues(places, gixels));
      const std::size_t blocks = gixels / 65536 + 1;
      EXPECT_LE(code.size(), std::min(2 * places.size(), 8192 * blocks) + 5 * blocks);

      bravais::RoaringUnion alone;
      alone.Add(code.data(), code.data() + code.size());
      alone.Finish();
      EXPECT_EQ(alone.GetPlaces(), places);
      EXPECT_EQ(alone.Encode(), code);
      EXPECT_LE(code.size(), alone.GetPortableSize());
    }
  }
}

TEST(TestLocalityMaskCodes, BlocksMayBeEmpty)
{
  const Places places{ 5, 6, 7, 70000, 4000000000U, 4294967295U };
  Bytes code;
  bravais::AppendRoaringCode(places.data(), places.size(), code);
  bravais::RoaringUnion alone;
  alone.Add(code.data(), code.data() + code.size());
  alone.Finish();
  EXPECT_EQ(alone.GetPlaces(), places);
}

TEST(TestLocalityMaskCodes, RoaringUnitesCodes)
{
  const std::uint32_t gixels = 150000;
  const std::vector<Places> masks = MakeMasks(gixels);
  for (std::size_t first = 0; first < masks.size(); first += 3)
  {
    bravais::RoaringUnion all;
    Bytes values(gixels);
    Bytes bits(bravais::GetMaskSize(gixels));
    for (std::size_t n = first; n < std::min(first + 6, masks.size()); ++n)
    {
      Bytes code;
      bravais::AppendRoaringCode(masks[n].data(), masks[n].size(), code);
      all.Add(code.data(), code.data() + code.size());
      code.clear();
      bravais::AppendRunLengthCode(masks[n].data(), masks[n].size(), gixels, code);
      bravais::OrRunLengthCode(code.data(), code.data() + code.size(), bits.data());
      for (const std::uint32_t place : masks[n])
      {
        values[place] = 1;
      }
    }
    all.Finish();
    Bytes painted(gixels);
    all.Paint(painted.data());
    EXPECT_EQ(painted, values);
    EXPECT_EQ(all.Count(), static_cast<std::uint64_t>(std::count(values.begin(), values.end(), 1)));
    EXPECT_EQ(bits, bravais::PackBits(values.data(), gixels));
  }
}

TEST(TestLocalityMaskCodes, BitsArePackedFromTheLeastSignificant)
{
  const Bytes values{ 1, 0, 0, 255, 0, 0, 0, 0, 0, 2 };
  const Bytes bits = bravais::PackBits(values.data(), values.size());
  EXPECT_EQ(bits, (Bytes{ 9, 2 }));
  Bytes unpacked(values.size());
  bravais::UnpackBits(bits.data(), values.size(), unpacked.data());
  EXPECT_EQ(unpacked, (Bytes{ 1, 0, 0, 1, 0, 0, 0, 0, 0, 1 }));
}

TEST(TestLocalityMaskCodes, MasksAreUnitedIntersectedAndDownSampled)
{
  const std::uint32_t width = 13;
  const std::uint32_t height = 9;
  bravais::BitMask a(width, height);
  bravais::BitMask b(width, height);
  for (const std::uint32_t place : MakePlaces(width * height, 0.1, 1.0, 3))
  {
    a.Set(place);
  }
  for (const std::uint32_t place : MakePlaces(width * height, 0.4, 1.0, 4))
  {
    b.Set(place);
  }
  bravais::BitMask both = a;
  bravais::BitMask any = a;
  ASSERT_TRUE(both.Intersect(b) && any.Unite(b));
  EXPECT_FALSE(both.Intersect(bravais::BitMask(height, width)));
  EXPECT_FALSE(any.Unite(bravais::BitMask(width, height + 1)));
  for (std::uint64_t place = 0; place < a.GetNumberOfGixels(); ++place)
  {
    EXPECT_EQ(both.Get(place), a.Get(place) && b.Get(place));
    EXPECT_EQ(any.Get(place), a.Get(place) || b.Get(place));
  }
  EXPECT_EQ(any.Count() + both.Count(), a.Count() + b.Count());

  for (int level = 0; level < 6; ++level)
  {
    const std::uint32_t step = 1U << level;
    const bravais::BitMask coarse = a.DownSample(level);
    ASSERT_EQ(coarse.GetWidth(), (width - 1) / step + 1);
    ASSERT_EQ(coarse.GetHeight(), (height - 1) / step + 1);
    bravais::BitMask expected(coarse.GetWidth(), coarse.GetHeight());
    for (std::uint32_t y = 0; y < height; ++y)
    {
      for (std::uint32_t x = 0; x < width; ++x)
      {
        if (a.Get(y * width + x))
        {
          expected.Set(y / step * coarse.GetWidth() + x / step);
        }
      }
    }
    EXPECT_EQ(coarse.GetBytes(), expected.GetBytes());
  }
}
