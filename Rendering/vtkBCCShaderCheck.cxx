// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkBCCShaderCheck.h"

#include "bccNothing_glsl.h"
#include "bccNowhere_glsl.h"

#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLShaderProperty.h"
#include "vtkShader.h"
#include "vtkShaderProgram.h"
#include "vtkVolume.h"
#include "vtk_glew.h"

#include <functional>
#include <vector>

namespace
{
// Opens what VTK does to all shaders, such as putting their version first.
class SystemReplacements : public vtkOpenGLShaderCache
{
public:
  static SystemReplacements* New() { VTK_STANDARD_NEW_BODY(SystemReplacements); }
  using vtkOpenGLShaderCache::ReplaceShaderValues;
};

// The log of glGetShaderInfoLog or glGetProgramInfoLog.
template <class GetValue, class GetLog>
std::string GetInfoLog(unsigned int handle, GetValue getValue, GetLog getLog)
{
  int length = 0;
  getValue(handle, GL_INFO_LOG_LENGTH, &length);
  std::vector<char> text(length + 1, '\0');
  getLog(handle, length, nullptr, text.data());
  return text.data();
}
}

//------------------------------------------------------------------------------
void vtkBCCShaderCheck::Check(vtkVolume* volume, std::string& vertex, std::string& fragment)
{
  std::string checkedVertex = vertex;
  std::string checkedFragment = fragment;
  auto* property = vtkOpenGLShaderProperty::SafeDownCast(volume->GetShaderProperty());
  for (const auto& [which, how] : property->GetAllShaderReplacements())
  {
    if (!which.ReplaceFirst && which.ShaderType != vtkShader::Geometry)
    {
      vtkShaderProgram::Substitute(
        which.ShaderType == vtkShader::Vertex ? checkedVertex : checkedFragment,
        which.OriginalValue, how.Replacement, how.ReplaceAll);
    }
  }
  std::string geometry;
  vtkNew<SystemReplacements> system;
  system->ReplaceShaderValues(checkedVertex, checkedFragment, geometry);

  this->Log.clear();
  const std::size_t hash = std::hash<std::string>()(checkedVertex + '\n' + checkedFragment);
  if (this->Good.count(hash) == 0)
  {
    if (Build(checkedVertex, checkedFragment, this->Log))
    {
      this->Good.insert(hash);
    }
    else
    {
      vertex = bccNowhere_glsl;
      fragment = bccNothing_glsl;
    }
  }
}

//------------------------------------------------------------------------------
std::size_t vtkBCCShaderCheck::GetHash(vtkVolume* volume)
{
  std::string all;
  auto* property = vtkOpenGLShaderProperty::SafeDownCast(volume->GetShaderProperty());
  for (const auto& [which, how] : property->GetAllShaderReplacements())
  {
    all += std::to_string(which.ShaderType) + (which.ReplaceFirst ? "1" : "0") +
      (how.ReplaceAll ? "1" : "0") + which.OriginalValue + '\n' + how.Replacement + '\n';
  }
  return std::hash<std::string>()(all);
}

//------------------------------------------------------------------------------
bool vtkBCCShaderCheck::Build(
  const std::string& vertex, const std::string& fragment, std::string& log)
{
  const unsigned int program = glCreateProgram();
  bool good = true;
  for (const auto& [type, source] :
    { std::make_pair(GL_VERTEX_SHADER, &vertex), std::make_pair(GL_FRAGMENT_SHADER, &fragment) })
  {
    const unsigned int shader = glCreateShader(type);
    const char* text = source->c_str();
    glShaderSource(shader, 1, &text, nullptr);
    glCompileShader(shader);
    int compiled = 0;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
    if (good && !compiled)
    {
      log = GetInfoLog(shader, glGetShaderiv, glGetShaderInfoLog);
    }
    good = good && compiled;
    glAttachShader(program, shader);
    glDeleteShader(shader); // once it is detached
  }
  if (good)
  {
    int linked = 0;
    glLinkProgram(program);
    glGetProgramiv(program, GL_LINK_STATUS, &linked);
    good = linked != 0;
    if (!good)
    {
      log = GetInfoLog(program, glGetProgramiv, glGetProgramInfoLog);
    }
  }
  glDeleteProgram(program);
  if (!good && log.empty())
  {
    log = "The driver does not say why.";
  }
  return good;
}
