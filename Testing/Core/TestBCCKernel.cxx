// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause

#include "BCCKernel.h"

#include <gtest/gtest.h>

using namespace bravais;

TEST(TestBCCKernel, IsFoundByItsNumber)
{
  EXPECT_EQ(ToBCCKernel(4), BCCKernel::BCC4);
  EXPECT_EQ(ToBCCKernel(7), BCCKernel::BCC7);
  EXPECT_EQ(ToBCCKernel(8), BCCKernel::BCC8);
  EXPECT_EQ(ToBCCKernel(12), BCCKernel::BCC12);
  for (const int number : { -1, 0, 1, 5, 6, 9, 11, 13 })
  {
    EXPECT_FALSE(ToBCCKernel(number)) << number;
  }
}

TEST(TestBCCKernel, HasAName)
{
  EXPECT_STREQ(GetName(BCCKernel::BCC4), "BCC4");
  EXPECT_STREQ(GetName(BCCKernel::BCC7), "BCC7");
  EXPECT_STREQ(GetName(BCCKernel::BCC8), "BCC8");
  EXPECT_STREQ(GetName(BCCKernel::BCC12), "BCC12");
}
