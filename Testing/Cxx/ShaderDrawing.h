// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ShaderDrawing_h
#define ShaderDrawing_h

/// \file
/// What tests of GLSL functions share: evaluation of a shader's text at a list of points.

#include <functional>
#include <string>
#include <vector>

class vtkOpenGLRenderWindow;
class vtkShaderProgram;

/// Four numbers at each point of so many numbers, by `implementation`, which has the point as the
/// vec4 `point` and assigns gl_FragData[0]. There are as many points as pixels of a square.
/// `prepare` sets uniforms.
std::vector<float> DrawAtPoints(vtkOpenGLRenderWindow* window, const std::string& declarations,
  const std::string& implementation, const std::vector<float>& points, int numbers,
  const std::function<void(vtkShaderProgram*)>& prepare);

#endif
