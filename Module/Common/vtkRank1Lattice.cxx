// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRank1Lattice.h"

#include "Rank1Image.h"
#include "Rank1Lattice.h"
#include "Rank1Search.h"

#include "vtkObjectFactory.h"

#include <algorithm>
#include <cmath>
#include <optional>

vtkStandardNewMacro(vtkRank1Lattice);

/// The lattice of the properties as they were.
class vtkRank1Lattice::Internals
{
public:
  std::optional<bravais::Rank1Lattice> Lattice;
  vtkMTimeType Time = 0;
};

//------------------------------------------------------------------------------
vtkRank1Lattice::vtkRank1Lattice()
  : Cache(std::make_unique<Internals>())
{
}

//------------------------------------------------------------------------------
vtkRank1Lattice::~vtkRank1Lattice() = default;

//------------------------------------------------------------------------------
const char* vtkRank1Lattice::GetLayoutAsString()
{
  return this->Layout == Locality ? "Locality" : "Korobov";
}

//------------------------------------------------------------------------------
bool vtkRank1Lattice::Prepare()
{
  Internals& cache = *this->Cache;
  if (!cache.Lattice || cache.Time != this->GetMTime())
  {
    cache.Lattice = bravais::Rank1Lattice::Create(this->NumberOfPoints, this->Generator[0],
      this->Generator[1], { this->Aspect[0], this->Aspect[1] });
    cache.Time = this->GetMTime();
  }
  if (!cache.Lattice)
  {
    vtkErrorMacro(<< bravais::ExplainRank1Lattice(this->NumberOfPoints, this->Generator[0],
                    this->Generator[1], this->Aspect[0], this->Aspect[1]));
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkRank1Lattice::MaximizeMinimumDistance()
{
  const auto layout =
    this->Layout == Locality ? bravais::Rank1Layout::Locality : bravais::Rank1Layout::Korobov;
  const auto best = bravais::MaximizeMinimumDistance(
    this->NumberOfPoints, { this->Aspect[0], this->Aspect[1] }, layout);
  if (!best)
  {
    vtkErrorMacro(<< bravais::ExplainRank1Lattice(
                    this->NumberOfPoints, 1, 1, this->Aspect[0], this->Aspect[1]));
    return false;
  }
  this->SetGenerator(best->GetGenerator().x, best->GetGenerator().y);
  return true;
}

//------------------------------------------------------------------------------
void vtkRank1Lattice::GetBasis(vtkIdType b1[2], vtkIdType b2[2])
{
  const bool right = this->Prepare();
  for (int axis = 0; axis < 2; ++axis)
  {
    b1[axis] = right ? this->Cache->Lattice->GetBasis(0)[axis] : 0;
    b2[axis] = right ? this->Cache->Lattice->GetBasis(1)[axis] : 0;
  }
}

//------------------------------------------------------------------------------
void vtkRank1Lattice::GetBasis(double b1[2], double b2[2])
{
  vtkIdType basis[2][2];
  this->GetBasis(basis[0], basis[1]);
  std::copy_n(basis[0], 2, b1);
  std::copy_n(basis[1], 2, b2);
}

//------------------------------------------------------------------------------
void vtkRank1Lattice::GetBasisIndices(vtkIdType kl[2])
{
  const bool right = this->Prepare();
  kl[0] = right ? this->Cache->Lattice->GetBasisIndex(0) : -1;
  kl[1] = right ? this->Cache->Lattice->GetBasisIndex(1) : -1;
}

//------------------------------------------------------------------------------
void vtkRank1Lattice::GetDualBasis(double d1[2], double d2[2])
{
  std::array<glm::dvec2, 2> dual = { glm::dvec2(0.0), glm::dvec2(0.0) };
  if (this->Prepare())
  {
    dual = this->Cache->Lattice->GetDualBasis();
  }
  for (int axis = 0; axis < 2; ++axis)
  {
    d1[axis] = dual[0][axis];
    d2[axis] = dual[1][axis];
  }
}

//------------------------------------------------------------------------------
void vtkRank1Lattice::GetVoronoiCell(double corners[12])
{
  std::fill_n(corners, 12, 0.0);
  if (this->Prepare())
  {
    const auto cell = this->Cache->Lattice->GetVoronoiCell();
    for (int i = 0; i < 12; ++i)
    {
      corners[i] = cell[i / 2][i % 2] / static_cast<double>(this->NumberOfPoints);
    }
  }
}

//------------------------------------------------------------------------------
double vtkRank1Lattice::GetMinimumDistance()
{
  return this->Prepare() ? this->Cache->Lattice->GetMinimumDistance() : 0.0;
}

//------------------------------------------------------------------------------
double vtkRank1Lattice::GetSamplingEfficiency()
{
  return this->Prepare() ? this->Cache->Lattice->GetSamplingEfficiency() : 0.0;
}

//------------------------------------------------------------------------------
double vtkRank1Lattice::GetLayoutMeasure(int line)
{
  if (line < 1)
  {
    vtkErrorMacro("A line of " << line << " texels; at least 1 was expected.");
    return 0.0;
  }
  return this->Prepare() ? bravais::MeasureLayout(*this->Cache->Lattice, line) : 0.0;
}

//------------------------------------------------------------------------------
void vtkRank1Lattice::GetPoint(vtkIdType i, double uv[2])
{
  const glm::dvec2 point =
    this->Prepare() ? this->Cache->Lattice->GetPoint(i) : glm::dvec2(0.0, 0.0);
  uv[0] = point.x;
  uv[1] = point.y;
}

//------------------------------------------------------------------------------
vtkIdType vtkRank1Lattice::GetIndex(vtkIdType s, vtkIdType t)
{
  return this->Prepare() ? this->Cache->Lattice->GetIndex(s, t) : -1;
}

//------------------------------------------------------------------------------
vtkIdType vtkRank1Lattice::FindNearest(double u, double v)
{
  if (!std::isfinite(u) || !std::isfinite(v))
  {
    vtkErrorMacro("The point is (" << u << ", " << v << "); finite coordinates were expected.");
    return -1;
  }
  return this->Prepare() ? this->Cache->Lattice->FindNearest({ u, v }) : -1;
}

//------------------------------------------------------------------------------
void vtkRank1Lattice::GetNeighbors(vtkIdType i, vtkIdType ids[6])
{
  std::fill_n(ids, 6, vtkIdType{ -1 });
  if (this->Prepare())
  {
    const auto six = this->Cache->Lattice->GetNeighbors(i);
    std::copy(six.begin(), six.end(), ids);
  }
}

//------------------------------------------------------------------------------
void vtkRank1Lattice::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfPoints: " << this->NumberOfPoints << "\n";
  os << indent << "Generator: (" << this->Generator[0] << ", " << this->Generator[1] << ")\n";
  os << indent << "Aspect: (" << this->Aspect[0] << ", " << this->Aspect[1] << ")\n";
  os << indent << "Layout: " << this->GetLayoutAsString() << "\n";
}
