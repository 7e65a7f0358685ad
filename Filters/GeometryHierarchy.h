// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef GeometryHierarchy_h
#define GeometryHierarchy_h

#include "CellGrid.h"
#include "GixelOctree.h"
#include "MaskStore.h"
#include "vtkBravaisABINamespace.h"

#include "vtkType.h"

#include <optional>
#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkAlgorithm;
class vtkImageData;
VTK_ABI_NAMESPACE_END

namespace bravais
{

/// An octree over the gixels of an image with their masks, and what it was made of.
class GeometryHierarchy
{
public:
  struct Parameters
  {
    int MaximumDepth;
    double RootCube[4];
    MaskStore::Encoding Encoding;
    bool StoreInternalMasks;

    bool operator==(const Parameters& other) const;
  };

  /// Whether parameters are good for any image, as far as that can be told without one.
  static bool Check(const Parameters& parameters, std::string& why);

  /// Whether it is that of the image, as it now is, and the parameters.
  bool IsOf(vtkImageData* image, const Parameters& parameters) const;

  /// From an image that CheckGeometryImage has passed. Progress goes to `self` from `begin`
  /// to `end`.
  /// False, with a reason, for parameters or positions that are not good, and, without one, if
  /// aborted; it is then empty.
  bool Build(vtkAlgorithm* self, vtkImageData* image, const Parameters& parameters, double begin,
    double end, std::string& why);
  void Clear();

  const std::optional<CellGrid>& GetGrid() const { return this->Grid; } // none if no gixel is used
  const GixelOctree& GetTree() const { return this->Tree; }
  const MaskStore& GetMasks() const { return this->Masks; }
  bool IsEmpty() const { return this->Tree.GetDepth() < 0; }
  vtkIdType GetNumberOfGixels() const { return this->Gixels; }

private:
  std::optional<CellGrid> Grid;
  GixelOctree Tree;
  MaskStore Masks;
  vtkIdType Gixels = 0;
  std::optional<Parameters> Made;
  vtkImageData* Image = nullptr; // to be compared, never used
  vtkMTimeType ImageTime = 0;
};

} // namespace bravais

#endif
