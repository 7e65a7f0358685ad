// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkBCCShaderCheck
 * @brief   compiles a shader before VTK does, to tell why it fails
 *
 * VTK prints a shader that does not compile line by line, and what the driver says of it, as errors
 * of an object that nobody can observe; then it renders without. Here a shader is compiled and
 * linked first, once for each different text.
 */

#ifndef vtkBCCShaderCheck_h
#define vtkBCCShaderCheck_h

#include "vtkBravaisABINamespace.h"
#include <set>
#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkVolume;

class vtkBCCShaderCheck
{
public:
  /// Takes what VTK has composed for a volume, before the user's own replacements. If it does not
  /// compile and link after them, what draws nothing is put in its place.
  void Check(vtkVolume* volume, std::string& vertex, std::string& fragment);

  /// A number that changes with the user's replacements; VTK overlooks that they are cleared.
  static std::size_t GetHash(vtkVolume* volume);

  /// What the driver has said of the last shader that was checked; nothing if that was a good one.
  std::string Log;

private:
  static bool Build(const std::string& vertex, const std::string& fragment, std::string& log);

  std::set<std::size_t> Good; // hashes of texts
};
VTK_ABI_NAMESPACE_END

#endif
// VTK-HeaderTest-Exclude: vtkBCCShaderCheck.h
