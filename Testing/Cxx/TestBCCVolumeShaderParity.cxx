// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
// The GLSL functions agree with their twins of Module/Core: roots of random functions, and splines,
// by values and gradients at random points of a random volume and on the faces, edges and vertices
// of tetrahedra and box, with coefficients in a 3D texture and in a buffer. The shader's numbers
// are floats, drawn into a float target; the twins are evaluated in double.

#include "BCCLattice.h"
#include "BoxSpline.h"
#include "FindRoot.h"
#include "ShaderDrawing.h"
#include "vtkBCCCoefficientBuffer.h"
#include "vtkBCCCoefficientTexels.h"
#include "vtkBCCLattice.h"
#include "vtkBCCVolumeFrame.h"
#include "vtkBCCVolumeShaderText.h"

#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkLogger.h"
#include "vtkMinimalStandardRandomSequence.h"
#include "vtkNew.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPointData.h"
#include "vtkRenderWindow.h"
#include "vtkShaderProgram.h"
#include "vtkSmartPointer.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

namespace
{
constexpr int Width = 64;
constexpr int Height = 64;
constexpr double ValueTolerance = 2e-6; // coefficients are from -1 to 1
constexpr double GradientTolerance = 5e-6;
constexpr double RootTolerance =
  3e-5; // functions below 1e-6 end the search, and slopes are 0.1 or more

// A piece of a volume that starts at an odd layer.
vtkSmartPointer<vtkImageData> MakeVolume(vtkMinimalStandardRandomSequence* random, int components)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetExtent(2, 8, -1, 4, 3, 11);
  vtkNew<vtkFloatArray> values;
  values->SetNumberOfComponents(components);
  values->SetNumberOfTuples(image->GetNumberOfPoints());
  for (vtkIdType i = 0; i < values->GetNumberOfValues(); ++i)
  {
    values->SetValue(i, static_cast<float>(random->GetNextRangeValue(-1, 1)));
  }
  image->GetPointData()->SetScalars(values);
  vtkBCCLattice::Tag(image);
  return image;
}

// Points as floats, three of four at random, the others at multiples of one half.
std::vector<float> MakePoints(
  vtkMinimalStandardRandomSequence* random, const vtkBCCVolumeFrame& frame)
{
  std::vector<float> points;
  for (int i = 0; i < Width * Height; ++i)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      const double x = random->GetNextRangeValue(frame.Low[axis], frame.High[axis]);
      points.push_back(static_cast<float>(i % 4 ? x : std::round(2 * x) / 2));
    }
  }
  return points;
}

vtkSmartPointer<vtkTextureObject> MakeTexture(vtkOpenGLRenderWindow* window)
{
  auto texture = vtkSmartPointer<vtkTextureObject>::New();
  texture->SetContext(window);
  return texture;
}

constexpr int Origin[3] = { vtkBCCCoefficientTexels::Halo, vtkBCCCoefficientTexels::Halo,
  vtkBCCCoefficientTexels::Halo };

// What draws one component of the spline at each point: the value (x) and gradient (yzw).
std::string GetImplementation(int components, int component)
{
  const std::string channel =
    components == 1 ? std::string() : "[" + std::to_string(component) + "]";
  return "BCC_VALUE x, y, z;\nBCC_VALUE value = EvaluateBoxSpline(point.xyz, x, y, z);\n"
         "gl_FragData[0] = vec4(value" +
    channel + ", x" + channel + ", y" + channel + ", z" + channel + ");\n";
}

std::vector<float> DrawFromBuffer(vtkOpenGLRenderWindow* window, bravais::BCCKernel kernel,
  const vtkBCCCoefficientTexels& texels, const std::vector<float>& points, int component)
{
  vtkBCCCoefficientBuffer buffer;
  buffer.Fill(window, kernel, texels, false);
  const auto result =
    DrawAtPoints(window, vtkBCCVolumeShaderText::GetSpline(kernel, texels.Components, ""),
      GetImplementation(texels.Components, component), points, 3,
      [&](vtkShaderProgram* program)
      {
        buffer.Activate(program);
        program->SetUniform1iv("in_bccOriginTexel", 3, Origin);
      });
  buffer.Deactivate();
  buffer.ReleaseGraphicsResources(window);
  return result;
}

std::vector<float> DrawFromTexture(vtkOpenGLRenderWindow* window, bravais::BCCKernel kernel,
  const vtkBCCCoefficientTexels& texels, const std::vector<float>& points, int component)
{
  auto coefficients = MakeTexture(window);
  coefficients->Create3DFromRaw(texels.Size.x, texels.Size.y, texels.Size.z, texels.Components,
    VTK_FLOAT, const_cast<float*>(texels.Values.data()));
  const int filter =
    kernel == bravais::BCCKernel::BCC12 ? vtkTextureObject::Linear : vtkTextureObject::Nearest;
  coefficients->SetMagnificationFilter(filter);
  coefficients->SetMinificationFilter(filter);
  coefficients->Activate();
  const auto result = DrawAtPoints(window,
    "uniform sampler3D coefficients;\n" +
      vtkBCCVolumeShaderText::GetSpline(kernel, texels.Components, "coefficients"),
    GetImplementation(texels.Components, component), points, 3,
    [&](vtkShaderProgram* program)
    {
      program->SetUniformi("coefficients", coefficients->GetTextureUnit());
      program->SetUniformi("in_bccCosetDepth", texels.Size.z / 2);
      program->SetUniform1iv("in_bccOriginTexel", 3, Origin);
    });
  coefficients->Deactivate();
  coefficients->ReleaseGraphicsResources(window);
  return result;
}

// Written so that a NaN counts.
double Worse(double error, double difference)
{
  return difference <= error ? error : difference;
}

// Roots of x + y s + z s^3, which is negative at 0 and rises to positive values at 1.
bool CompareRoots(vtkOpenGLRenderWindow* window, vtkMinimalStandardRandomSequence* random)
{
  std::vector<float> points;
  for (int i = 0; i < Width * Height; ++i)
  {
    const double y = random->GetNextRangeValue(0.1, 1);
    const double z = random->GetNextRangeValue(0, 3);
    const double x = -random->GetNextRangeValue(0.02, 0.98) * (y + z);
    points.insert(
      points.end(), { static_cast<float>(x), static_cast<float>(y), static_cast<float>(z) });
  }
  const auto drawn = DrawAtPoints(window,
    "float BCCDifference(float s) { return point.x + s * (point.y + s * s * point.z); }\n" +
      vtkBCCVolumeShaderText::GetFindRoot(),
    "gl_FragData[0] = vec4(FindRoot(point.x, point.x + point.y + point.z));\n", points, 3,
    [](vtkShaderProgram*) {});
  double error = 0;
  for (int i = 0; i < Width * Height; ++i)
  {
    const float* p = points.data() + 3 * i;
    const auto function = [p](double s) { return p[0] + s * (p[1] + s * s * p[2]); };
    const double root = bravais::FindRoot(function, double{ p[0] }, double{ p[0] } + p[1] + p[2]);
    error = Worse(error, std::abs(root - drawn[4 * i]));
  }
  vtkLog(INFO, << "FindRoot: error " << error);
  return error < RootTolerance;
}

// Whether what was drawn at the points is the spline of a component, and its gradient.
bool CompareSplines(bravais::BCCKernel kernel, vtkImageData* image, int component,
  const std::vector<float>& points, const std::vector<float>& drawn)
{
  auto* values = vtkFloatArray::SafeDownCast(image->GetPointData()->GetScalars());
  int dimensions[3];
  image->GetDimensions(dimensions);
  const bravais::BCCLattice lattice(glm::ivec3(dimensions[0], dimensions[1], dimensions[2]));
  const int first = static_cast<int>(vtkBCCVolumeFrame(image).Low[2]);
  // The mirrors of the twin stand at the box's ends too, but its first layer is even.
  const auto fetch = [&](const glm::ivec3& point)
  {
    const glm::ivec3 last = lattice.GetLast();
    const glm::ivec3 inside(bravais::BCCLattice::Mirror(point.x, last.x),
      bravais::BCCLattice::Mirror(point.y, last.y),
      bravais::BCCLattice::Mirror(point.z - first, last.z));
    const glm::ivec3 index(inside.x / 2, inside.y / 2, inside.z);
    return static_cast<double>(values->GetTypedComponent(lattice.ToLinear(index), component));
  };
  double valueError = 0;
  double gradientError = 0;
  for (int i = 0; i < Width * Height; ++i)
  {
    const float* at = points.data() + 3 * i;
    const float* got = drawn.data() + 4 * i;
    glm::dvec3 gradient;
    const double value =
      bravais::EvaluateBoxSpline(kernel, fetch, glm::dvec3(at[0], at[1], at[2]), gradient);
    valueError = Worse(valueError, std::abs(value - got[0]));
    // bcc4's gradient jumps at the tetrahedra's faces, where a quarter of the points may lie.
    if (kernel != bravais::BCCKernel::BCC4 || i % 4)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        gradientError = Worse(gradientError, std::abs(gradient[axis] - got[axis + 1]));
      }
    }
  }
  vtkLog(INFO, << bravais::GetName(kernel) << ", " << values->GetNumberOfComponents()
               << " component(s): value error " << valueError << ", gradient error "
               << gradientError);
  return valueError < ValueTolerance && gradientError < GradientTolerance;
}
}

int TestBCCVolumeShaderParity(int, char*[])
{
  vtkNew<vtkRenderWindow> renderWindow;
  renderWindow->SetOffScreenRendering(true);
  renderWindow->SetSize(Width, Height);
  renderWindow->Render();
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderWindow);
  vtkNew<vtkMinimalStandardRandomSequence> random;
  random->SetSeed(20);
  bool good = CompareRoots(window, random);
  for (int components : { 1, 2, 3, 4 })
  {
    const auto image = MakeVolume(random, components);
    const vtkBCCVolumeFrame frame(image);
    const auto points = MakePoints(random, frame);
    for (auto kernel : { bravais::BCCKernel::BCC4, bravais::BCCKernel::BCC7,
           bravais::BCCKernel::BCC8, bravais::BCCKernel::BCC12 })
    {
      vtkBCCCoefficientTexels texels;
      texels.Pack(frame, image->GetPointData()->GetScalars());
      const int component = components - 1;
      const auto drawn = DrawFromTexture(window, kernel, texels, points, component);
      good = CompareSplines(kernel, image, component, points, drawn) && good;
      if (components == 3)
      {
        continue; // There are no buffers of three half floats.
      }
      const auto fromBuffer = DrawFromBuffer(window, kernel, texels, points, component);
      if (kernel == bravais::BCCKernel::BCC12)
      {
        good = CompareSplines(kernel, image, component, points, fromBuffer) && good;
      }
      else if (fromBuffer != drawn)
      {
        vtkLog(ERROR, << bravais::GetName(kernel) << ", " << components
                      << " component(s): a buffer gives another picture than a texture");
        good = false;
      }
    }
  }
  return good ? EXIT_SUCCESS : EXIT_FAILURE;
}
