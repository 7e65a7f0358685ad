// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkBCCVolumePiece.h"

#include "BCCCoefficients.h"
#include "BCCKernel.h"
#include "BCCPrefilter.h"
#include "vtkBCCLattice.h"

#include "vtkImageData.h"

#include <algorithm>

namespace
{
bool IsQuasiInterpolation(int prefilter)
{
  return prefilter == static_cast<int>(bravais::BCCPrefilter::QuasiInterpolation);
}

bool IsVoid(const int extent[6])
{
  return extent[0] > extent[1] || extent[2] > extent[3] || extent[4] > extent[5];
}

bool IsWithin(const int inner[6], const int outer[6])
{
  bool within = true;
  for (int axis = 0; axis < 3; ++axis)
  {
    within =
      within && inner[2 * axis] >= outer[2 * axis] && inner[2 * axis + 1] <= outer[2 * axis + 1];
  }
  return within;
}

std::string ToText(const int extent[6])
{
  std::string text = "(" + std::to_string(extent[0]);
  std::for_each(extent + 1, extent + 6, [&](int n) { text += ", " + std::to_string(n); });
  return text + ")";
}

// Indices of points that a look-up reaches beyond a cut. Along x and y, where an index is two
// lattice units, the cut is at an even point; the odd one of its index lies beyond it.
int ToIndices(int axis, int reach, bool far)
{
  return axis == 2 ? reach : (far ? reach / 2 : (reach + 1) / 2);
}
}

//------------------------------------------------------------------------------
vtkBCCVolumePiece::vtkBCCVolumePiece(vtkImageData* image, int prefilter)
{
  image->GetExtent(this->Held);
  if (!vtkBCCLattice::GetPiece(image, this->Whole, this->Owned))
  {
    std::copy_n(this->Held, 6, this->Whole);
    std::copy_n(this->Held, 6, this->Owned);
  }
  this->IsPart = !std::equal(this->Held, this->Held + 6, this->Whole) ||
    !std::equal(this->Owned, this->Owned + 6, this->Whole);
  const int lost = IsQuasiInterpolation(prefilter) ? 1 : 0;
  const int odd = this->Whole[4] & 1;
  for (int axis = 0; axis < 3; ++axis)
  {
    const int low = 2 * axis;
    const int high = low + 1;
    const int units = axis == 2 ? 1 : 2;
    const auto toLattice = [&](int index)
    { return units * (index - this->Whole[low]) + (axis == 2 ? odd : 0); };
    this->Coefficients[low] = this->Held[low] + (this->Held[low] > this->Whole[low] ? lost : 0);
    this->Coefficients[high] = this->Held[high] - (this->Held[high] < this->Whole[high] ? lost : 0);
    this->Base[axis] =
      toLattice(this->Coefficients[low]) - (axis == 2 ? this->Coefficients[low] & 1 : 0);
    this->Low[axis] =
      this->Owned[low] > this->Whole[low] ? static_cast<float>(toLattice(this->Owned[low])) : -1e9f;
    this->High[axis] = this->Owned[high] < this->Whole[high]
      ? static_cast<float>(toLattice(this->Owned[high]))
      : 1e9f;
  }
}

//------------------------------------------------------------------------------
bool vtkBCCVolumePiece::IsEmpty() const
{
  return IsVoid(this->Owned) && !IsVoid(this->Whole);
}

//------------------------------------------------------------------------------
bool vtkBCCVolumePiece::Check(int kernel, int prefilter, std::string& why) const
{
  if (!IsWithin(this->Held, this->Whole) || !IsWithin(this->Owned, this->Held))
  {
    why = "The input is marked as the piece " + ToText(this->Owned) + " of " + ToText(this->Whole) +
      " and holds " + ToText(this->Held) +
      "; a piece has to lie in what is held, and that in the whole.";
    return false;
  }
  const bool whole = std::equal(this->Held, this->Held + 6, this->Whole);
  // A spline of BCC4 passes through its coefficients.
  const bool spectral = bravais::NeedsWholeVolume(prefilter) &&
    !(kernel == static_cast<int>(bravais::BCCKernel::BCC4) &&
      prefilter == static_cast<int>(bravais::BCCPrefilter::Interpolation));
  if (spectral && !whole)
  {
    why = std::string("Prefilter ") +
      bravais::GetName(static_cast<bravais::BCCPrefilter>(prefilter)) +
      " needs the whole volume, and the input is a piece that holds " + ToText(this->Held) +
      " of " + ToText(this->Whole) + "; None and QuasiInterpolation do with pieces.";
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkBCCVolumePiece::CheckGhosts(const int reach[3], std::string& why) const
{
  for (int n = 0; n < 6; ++n)
  {
    const int axis = n / 2;
    const bool far = n % 2 == 1;
    if (this->Owned[n] == this->Whole[n])
    {
      continue;
    }
    const int needed = ToIndices(axis, reach[axis], far);
    const int lost = std::abs(this->Held[n] - this->Coefficients[n]);
    const int held = std::abs(this->Owned[n] - this->Held[n]) - lost;
    if (this->Held[n] != this->Whole[n] && held < needed)
    {
      why = std::string("The input is a piece with ") + std::to_string(held + lost) +
        " layers of ghost points at the " + (far ? "end" : "beginning") + " of its " + "xyz"[axis] +
        " axis; these settings need " + std::to_string(needed + lost) +
        " (vtkBCCVolumeMapper::GetNumberOfGhostLevels).";
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
int vtkBCCVolumePiece::GetGhostLevels(int axis, int reach, int prefilter)
{
  return ToIndices(axis, reach, false) + (IsQuasiInterpolation(prefilter) ? 1 : 0);
}
