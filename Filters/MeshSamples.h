// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef MeshSamples_h
#define MeshSamples_h

#include "GixelSampling.h"
#include "MeshLayout.h"
#include "vtkBravaisABINamespace.h"

#include "vtkNew.h"
#include "vtkPointData.h"

#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkImageData;
class vtkPolyData;
VTK_ABI_NAMESPACE_END

namespace bravais
{

/// The triangles of a vtkPolyData laid into a rectangle, and the points of them under its gixels.
/// What vtkPolyDataToGeometryImage keeps between requests for pieces.
class MeshSamples
{
public:
  /// Reads a mesh; false with a sentence in `why` if it cannot be a geometry image.
  bool SetMesh(vtkPolyData* mesh, std::string& why);
  /// Lays it out and samples it; false if stopped, with an empty `why`, or if that fails.
  bool Sample(const int dimensions[2], int rounds, SurfaceParametrization::Progress progress,
    std::string& why);

  /// Fills an image's extent with positions and the mesh's point data.
  void Fill(vtkImageData* image) const;

  double GetStretch() const { return this->Layout.GetStretch(); }
  int GetNumberOfFlippedTriangles() const
  {
    return CountFlipped(this->Layout.GetMesh(), this->Layout.GetParameters());
  }

private:
  void AddSplitPoints();

  MeshLayout Layout;
  int Width = 0;
  vtkNew<vtkPointData> Attributes; // of all vertices
  vtkSmartPointer<vtkDataArray> Points;
  std::vector<SurfaceSample> Samples;
};

} // namespace bravais

#endif
