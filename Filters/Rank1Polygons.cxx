// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rank1Polygons.h"

#include "SliceLoop.h"

#include "vtkAlgorithm.h"
#include "vtkCellArray.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkSMPTools.h"

#include <algorithm>

namespace bravais
{

namespace
{

using Work = std::function<void(vtkIdType texel, Rank1Polygons& run)>;

/// Runs of texels, each by one thread.
std::vector<Rank1Polygons> ForEachTexel(
  vtkAlgorithm* self, vtkIdType first, vtkIdType last, double end, const Work& work)
{
  constexpr vtkIdType shortest = 256;
  constexpr vtkIdType mostRuns = 4096;
  const vtkIdType length = std::max(shortest, (last - first) / mostRuns + 1);
  std::vector<Rank1Polygons> runs(first < last ? (last - first - 1) / length + 1 : 0);
  const auto run = [&](int index)
  {
    const vtkIdType from = first + index * length;
    for (vtkIdType texel = from; texel < std::min(from + length, last); ++texel)
    {
      work(texel, runs[index]);
    }
  };
  if (!runs.empty() && !ForEachSlice(self, 0, static_cast<int>(runs.size()) - 1, run, 0.0, end))
  {
    runs.clear();
  }
  return runs;
}

/// New vertices for the corners of a part; the number of the first.
vtkIdType AddVertices(
  const Rank1Cells::Part& part, const std::array<std::int64_t, 3>& texels, Rank1Polygons& run)
{
  const auto first = static_cast<vtkIdType>(run.Vertices.size());
  for (const Rank1Cells::Corner& corner : part)
  {
    run.Vertices.push_back({ corner.Position, corner.Barycentric, texels });
  }
  return first;
}

} // namespace

//------------------------------------------------------------------------------
std::vector<Rank1Polygons> FindRank1VoronoiCells(
  vtkAlgorithm* self, const Rank1Cells& cells, vtkIdType first, vtkIdType last, double end)
{
  return ForEachTexel(self, first, last, end,
    [&](vtkIdType texel, Rank1Polygons& run)
    {
      std::vector<Rank1Cells::Part> parts;
      cells.FindCellParts(texel, parts);
      for (const Rank1Cells::Part& part : parts)
      {
        const vtkIdType vertex = AddVertices(part, { texel, texel, texel }, run);
        const auto size = static_cast<vtkIdType>(part.size());
        for (vtkIdType i = 0; i < size; ++i)
        {
          run.Corners.push_back(-1 - (vertex + i));
        }
        run.Sizes.push_back(size);
        run.Texels.push_back(texel);
      }
    });
}

//------------------------------------------------------------------------------
std::vector<Rank1Polygons> FindRank1Triangles(
  vtkAlgorithm* self, const Rank1Cells& cells, vtkIdType first, vtkIdType last, double end)
{
  return ForEachTexel(self, first, last, end,
    [&](vtkIdType texel, Rank1Polygons& run)
    {
      std::vector<Rank1Cells::Part> parts;
      for (const int which : { 0, 1 })
      {
        const Rank1Cells::Triangle triangle = cells.GetTriangle(texel, which);
        if (triangle.IsInside)
        {
          run.Corners.insert(run.Corners.end(), triangle.Texels.begin(), triangle.Texels.end());
          run.Sizes.push_back(3);
          continue;
        }
        cells.FindTriangleParts(triangle, parts);
        for (const Rank1Cells::Part& part : parts)
        {
          const vtkIdType vertex = AddVertices(part, triangle.Texels, run);
          for (vtkIdType i = 1; i + 1 < static_cast<vtkIdType>(part.size()); ++i)
          {
            for (const vtkIdType corner : { vtkIdType{ 0 }, i, i + 1 })
            {
              run.Corners.push_back(-1 - (vertex + corner));
            }
            run.Sizes.push_back(3);
          }
        }
      }
    });
}

//------------------------------------------------------------------------------
std::vector<vtkIdType> CountRank1Vertices(const std::vector<Rank1Polygons>& runs)
{
  std::vector<vtkIdType> counts = { 0 };
  for (const Rank1Polygons& run : runs)
  {
    counts.push_back(counts.back() + static_cast<vtkIdType>(run.Vertices.size()));
  }
  return counts;
}

//------------------------------------------------------------------------------
void FillRank1Polygons(const std::vector<Rank1Polygons>& runs,
  const std::function<vtkIdType(vtkIdType)>& texel, vtkIdType firstVertex, vtkCellArray* polygons)
{
  const std::vector<vtkIdType> vertices = CountRank1Vertices(runs);
  std::vector<vtkIdType> cells = { 0 };
  std::vector<vtkIdType> corners = { 0 };
  for (const Rank1Polygons& run : runs)
  {
    cells.push_back(cells.back() + static_cast<vtkIdType>(run.Sizes.size()));
    corners.push_back(corners.back() + static_cast<vtkIdType>(run.Corners.size()));
  }
  vtkNew<vtkIdTypeArray> offsets;
  vtkNew<vtkIdTypeArray> connectivity;
  offsets->SetNumberOfValues(cells.back() + 1);
  connectivity->SetNumberOfValues(corners.back());
  offsets->SetValue(cells.back(), corners.back());
  vtkIdType* starts = offsets->GetPointer(0);
  vtkIdType* points = connectivity->GetPointer(0);
  vtkSMPTools::For(0, static_cast<vtkIdType>(runs.size()),
    [&](vtkIdType from, vtkIdType to)
    {
      for (vtkIdType index = from; index < to; ++index)
      {
        const Rank1Polygons& run = runs[index];
        vtkIdType start = corners[index];
        vtkIdType cell = cells[index];
        for (const vtkIdType size : run.Sizes)
        {
          starts[cell++] = start;
          start += size;
        }
        vtkIdType* point = points + corners[index];
        for (const vtkIdType corner : run.Corners)
        {
          *point++ = corner >= 0 ? texel(corner) : firstVertex + vertices[index] + (-1 - corner);
        }
      }
    });
  polygons->SetData(offsets, connectivity);
}

} // namespace bravais
