// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LocalityQuery_h
#define LocalityQuery_h

#include "CullOctree.h"
#include "CullVolume.h"
#include "GeometryHierarchy.h"
#include "GeometryImage.h"
#include "vtkBravaisABINamespace.h"

#include <cstdint>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkAlgorithm;
VTK_ABI_NAMESPACE_END

namespace bravais
{

/// One query of a hierarchy: which nodes a volume meets, and the union of their masks, which it
/// writes to one byte a gixel, all 0 before.
class LocalityQuery
{
public:
  /// False if `self` was aborted. Progress goes from `begin` to 1.
  bool Execute(vtkAlgorithm* self, const GeometryHierarchy& hierarchy, const GixelView& gixels,
    const CullVolume& volume, bool refine, double begin, std::uint8_t* mask);

  std::uint64_t GetNumberOfLeaves() const { return this->Leaves; }
  double GetCullTime() const { return this->CullTime; }   // seconds, to find the nodes
  double GetUnionTime() const { return this->UnionTime; } // seconds, to unite their masks

  /// Compressed bytes of the masks of the nodes that were met, of the leaves below where a node has
  /// none.
  std::uint64_t GetSize(const GeometryHierarchy& hierarchy) const;

private:
  bool FindLeaves(vtkAlgorithm* self, const GeometryHierarchy& hierarchy, const GixelView& gixels,
    vtkImplicitFunction* function, double begin);
  void Paint(const GeometryHierarchy& hierarchy, const OctreeNode& node, std::uint8_t* mask);

  CullResult Result;
  std::vector<std::uint8_t> Inside; // of each gixel, where only gixels can be asked
  std::uint64_t Leaves = 0;
  double CullTime = 0.0;
  double UnionTime = 0.0;
};

} // namespace bravais

#endif
