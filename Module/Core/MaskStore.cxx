// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "MaskStore.h"

#include "BitMask.h"
#include "RoaringCode.h"
#include "RunLengthCode.h"

#include <algorithm>

namespace bravais
{

//------------------------------------------------------------------------------
MaskStore::MaskStore(
  const GixelOctree& tree, std::uint64_t gixels, Encoding encoding, bool internal)
  : Gixels(gixels)
  , Format(encoding)
  , Internal(internal)
  , Levels(static_cast<std::size_t>(tree.GetDepth()) + 1)
{
}

//------------------------------------------------------------------------------
void MaskStore::Encode(const GixelOctree& tree, int depth)
{
  if (!this->Has(depth))
  {
    return;
  }
  const std::vector<std::uint32_t> gixels = tree.SortGixels(depth);
  const GixelOctree::Level& nodes = tree.GetLevel(depth);
  Level& level = this->Levels[static_cast<std::size_t>(depth)];
  level.Index.reserve(nodes.GetSize());
  for (std::size_t node = 0; node < nodes.GetSize(); ++node)
  {
    const std::uint32_t* places = gixels.data() + nodes.Gixels[node];
    const std::size_t count = nodes.Gixels[node + 1] - nodes.Gixels[node];
    const std::size_t begin = level.Bytes.size();
    bool exception = false;
    if (this->Format == Encoding::Roaring)
    {
      AppendRoaringCode(places, count, level.Bytes);
      exception =
        GetRunLengthSize(places, count, this->Gixels) < std::uint64_t{ level.Bytes.size() - begin };
      level.Bytes.resize(exception ? begin : level.Bytes.size());
    }
    if (exception || this->Format == Encoding::RunLength)
    {
      AppendRunLengthCode(places, count, this->Gixels, level.Bytes);
    }
    level.Index.push_back(2 * std::uint64_t{ level.Bytes.size() } + exception);
  }
  level.Bytes.shrink_to_fit();
}

//------------------------------------------------------------------------------
std::uint64_t MaskStore::GetSize(bool leavesOnly) const
{
  std::uint64_t size = 0;
  for (int depth = 0; depth < this->GetNumberOfLevels(); ++depth)
  {
    const bool leaves = depth + 1 == this->GetNumberOfLevels();
    size += leaves || !leavesOnly ? this->Levels[static_cast<std::size_t>(depth)].Bytes.size() : 0;
  }
  return size;
}

//------------------------------------------------------------------------------
std::uint64_t MaskStore::GetUncompressedSize(bool leavesOnly) const
{
  std::uint64_t masks = 0;
  for (int depth = 0; depth < this->GetNumberOfLevels(); ++depth)
  {
    const bool leaves = depth + 1 == this->GetNumberOfLevels();
    masks += leaves || !leavesOnly ? this->Levels[static_cast<std::size_t>(depth)].Index.size() : 0;
  }
  return masks * GetMaskSize(this->Gixels);
}

//------------------------------------------------------------------------------
std::uint64_t MaskStore::GetNumberOfExceptions() const
{
  std::uint64_t count = 0;
  for (const Level& level : this->Levels)
  {
    for (const std::uint64_t entry : level.Index)
    {
      count += entry & 1;
    }
  }
  return count;
}

//------------------------------------------------------------------------------
MaskStore::Code MaskStore::Get(int depth, std::uint32_t node) const
{
  const Level& level = this->Levels[static_cast<std::size_t>(depth)];
  const std::uint64_t begin = node ? level.Index[node - 1] / 2 : 0;
  const std::uint64_t entry = level.Index[node];
  return { level.Bytes.data() + begin, level.Bytes.data() + entry / 2,
    entry & 1 ? Encoding::RunLength : this->Format };
}

//------------------------------------------------------------------------------
void MaskStore::Paint(int depth, std::uint32_t node, std::uint8_t* values) const
{
  const Code code = this->Get(depth, node);
  if (code.Format == Encoding::Roaring)
  {
    PaintRoaringCode(code.Begin, code.End, values);
  }
  else
  {
    PaintRunLengthCode(code.Begin, code.End, this->Gixels, values);
  }
}

} // namespace bravais
