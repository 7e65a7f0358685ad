// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkBCCPieceSampling.h"

#include "BCCBricks.h"
#include "BCCCoefficients.h"
#include "vtkBCCVolumeMapper.h"
#include "vtkBCCVolumePiece.h"

#include "vtkMath.h"
#include "vtkMatrix4x4.h"

#include <algorithm>
#include <cmath>
#include <limits>

//------------------------------------------------------------------------------
float vtkBCCPieceSampling::FindDistance(
  vtkBCCVolumeMapper* mapper, const double spacing[3], vtkMatrix4x4* matrix, double locked)
{
  if (mapper->GetAutoAdjustSampleDistances())
  {
    double least = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis)
    {
      double column[3];
      for (int row = 0; row < 3; ++row)
      {
        column[row] = matrix->GetElement(row, axis);
      }
      least = std::min(least, spacing[axis] * vtkMath::Norm(column));
    }
    return static_cast<float>(least);
  }
  const float own = mapper->GetSampleDistance();
  if (mapper->GetLockSampleDistanceToInputSpacing())
  {
    const auto distance = static_cast<float>(locked);
    return std::abs(own / distance - 1.0f) > 0.001f ? distance : own;
  }
  return own;
}

//------------------------------------------------------------------------------
void vtkBCCPieceSampling::FindReach(vtkBCCVolumeMapper* mapper, const double latticePerUnit[3],
  double distance, bool surfaces, int reach[3])
{
  const auto kernel = bravais::ToBCCKernel(mapper->GetKernel());
  for (int axis = 0; axis < 3; ++axis)
  {
    // Two samples before the part and after it tell of surfaces within.
    const double samples = surfaces ? 2.02 * distance * latticePerUnit[axis] : 0.0;
    const int cell = mapper->GetAnalyticGradients() ? 0 : (axis == 2 ? 1 : 2);
    const double far = bravais::BCCBricks::GetReach(kernel.value_or(bravais::BCCKernel::BCC12)) -
      1 + std::ceil(samples) + cell;
    reach[axis] = static_cast<int>(std::min(far, 1e6));
  }
}

//------------------------------------------------------------------------------
int vtkBCCPieceSampling::GetNumberOfGhostLevels(
  vtkBCCVolumeMapper* mapper, const double spacing[3], double scale)
{
  const double mean = (spacing[0] + spacing[1] + spacing[2]) / 3.0;
  const double least = std::min({ spacing[0], spacing[1], spacing[2] });
  const double distance = mapper->GetAutoAdjustSampleDistances()
    ? least * scale
    : (mapper->GetLockSampleDistanceToInputSpacing() ? mean / 2.0 : mapper->GetSampleDistance());
  const double latticePerUnit[3] = { 2.0 / spacing[0], 2.0 / spacing[1], 1.0 / spacing[2] };
  int reach[3];
  FindReach(mapper, latticePerUnit, distance, true, reach);
  int levels = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    levels = std::max(
      levels, vtkBCCVolumePiece::GetGhostLevels(axis, reach[axis], mapper->GetPrefilter()));
  }
  return levels;
}
