// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef GixelSurface_h
#define GixelSurface_h

#include "GixelTriangles.h"
#include "vtkBravaisABINamespace.h"

#include <functional>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkAlgorithm;
class vtkDataArray;
class vtkImageData;
class vtkPolyData;
VTK_ABI_NAMESPACE_END

namespace bravais
{

/// What vtkGeometryImageToPolyData makes, step by step: first of all the points, then the rest.
class GixelSurface
{
public:
  /// The image is one that CheckGeometryImage has passed.
  GixelSurface(vtkAlgorithm* self, vtkImageData* image, int level);

  /// Which part of the rows of squares is wanted. Default: all.
  void SetPiece(int piece, int count);

  /// The points, with the image's point arrays.
  void MakePoints(vtkPolyData* output);
  /// Triangles or strips, with a mask of the image's gixels or nullptr. False if aborted.
  bool MakeTriangles(vtkPolyData* output, const unsigned char* mask, bool strips);
  bool MakeNormals(vtkPolyData* output);
  void MakeTextureCoordinates(vtkPolyData* output);

private:
  template <class T>
  GixelGrid<T> GetGrid() const;
  void FindUsed();
  template <class T>
  bool ClassifyCells(const unsigned char* mask, std::vector<std::int64_t>& counts);
  template <class T>
  bool ComputeNormals(float* normals);
  template <class Array>
  bool WriteTriangles(vtkPolyData* output, const std::vector<std::int64_t>& counts);
  bool WriteStrips(vtkPolyData* output);

  int GetFirstPointRow() const { return this->Begin; }
  int GetLastPointRow() const { return this->Empty ? this->Begin - 1 : this->End; }
  bool IsWholeImage() const;
  std::int64_t GetId(std::int64_t gixel) const;
  std::int64_t GetGixel(std::int64_t point) const;

  vtkAlgorithm* Self;
  vtkImageData* Image;
  vtkDataArray* Points;
  GixelLevel Level;
  int Begin; // of the level's rows of squares
  int End;
  bool Empty = false;
  std::vector<unsigned char> Used;  // of the image's gixels; empty if all are
  std::vector<std::int64_t> Gixels; // the image's, one for each point; empty if it is all of them
  std::vector<std::int64_t> Ids; // points of the level's gixels from row Begin; empty if in order
  std::vector<unsigned char> Cells;
};

} // namespace bravais

#endif
