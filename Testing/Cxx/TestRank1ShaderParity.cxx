// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
// The GLSL of rank-1 textures agrees with its twins of Module/Core: indices of lattice points are
// the same integers for n up to 2^24, interpolated values of random texels at random points of the
// picture and beyond it are the twins' in double up to rounding, and so are levels of random
// footprints. OpenGL has no error to report, here and after frames of the mapper.

#include "Rank1Image.h"
#include "Rank1BoxSpline.h"
#include "Rank1Level.h"
#include "ShaderDrawing.h"
#include "vtkRank1ShaderText.h"
#include "vtkRank1TexelTexture.h"
#include "vtkRank1TextureInput.h"
#include "vtkRank1TexturedPolyDataMapper.h"

#include "vtkActor.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkLogger.h"
#include "vtkMinimalStandardRandomSequence.h"
#include "vtkNew.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPlaneSource.h"
#include "vtkPointData.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"
#include "vtk_glew.h"

#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

namespace
{
constexpr int Side = 48;
constexpr int Count = Side * Side;

struct Case
{
  std::int64_t N, G1, G2;
  int S, T;
  double Width, Height; // of the picture
};

// Tiny ones, powers of two and not, of several aspects, tiled, long cells, and the largest.
constexpr Case Cases[] = { { 1, 0, 0, 1, 1, 1, 1 }, { 2, 1, 1, 3, 2, 1, 1 },
  { 3, 1, 2, 2, 2, 1, 1 }, { 8, 1, 3, 1, 1, 1, 1 }, { 56, 4, 7, 1, 1, 1, 1 },
  { 97, 5, 31, 3, 1, 3, 1 }, { 128, 1, 1, 1, 1, 1, 1 }, { 210, 14, 15, 2, 3, 1, 2 },
  { 1000, 1, 0, 2, 2, 1, 1 }, { 2048, 31, 39, 1, 1, 2, 7 }, { 16384, 137, 13, 1, 1, 1, 1 },
  { 50176, 211, 116, 2, 2, 1, 1 }, { 262144, 1, 1990, 1, 1, 1, 1 },
  { 1 << 22, 1, 1741069, 2, 2, 1, 1 }, { 16777213, 1, 6132613, 1, 1, 1, 1 },
  { 1 << 24, 1, 6139855, 1, 1, 1, 1 } };

double Random(vtkMinimalStandardRandomSequence* random, double low, double high)
{
  return random->GetNextRangeValue(low, high);
}

// Written so that a NaN counts.
double Worse(double error, double difference)
{
  return difference <= error ? error : difference;
}

vtkSmartPointer<vtkImageData> MakeImage(const Case& about, vtkMinimalStandardRandomSequence* random)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(static_cast<int>(about.N), about.S, about.T);
  vtkNew<vtkFloatArray> values;
  values->SetNumberOfTuples(image->GetNumberOfPoints());
  for (vtkIdType i = 0; i < values->GetNumberOfValues(); ++i)
  {
    values->SetValue(i, static_cast<float>(Random(random, 0, 1)));
  }
  image->GetPointData()->SetScalars(values);
  const double domain[4] = { 0, about.Width, 0, about.Height };
  const auto lattice = bravais::Rank1Lattice::Create(
    about.N, about.G1, about.G2, { about.Width / about.S, about.Height / about.T });
  bravais::TagRank1Image(image, *lattice, domain);
  return image;
}

// Everything a shader needs of one texture.
struct Texture
{
  vtkRank1TextureInput Input;
  vtkRank1TexelTexture Texels;

  bool Set(vtkOpenGLRenderWindow* window, vtkImageData* image)
  {
    std::string why;
    const bool good = this->Input.SetSource(image, why) &&
      this->Input.Fold(vtkTextureObject::GetMaximumTextureSize(window), why) &&
      this->Texels.Fill(window, this->Input, false);
    if (!good)
    {
      vtkLog(ERROR, << why);
    }
    return good;
  }

  std::vector<float> Draw(vtkOpenGLRenderWindow* window, int interpolation,
    const std::string& implementation, const std::vector<float>& points)
  {
    this->Texels.Texture->Activate();
    const auto result = DrawAtPoints(window,
      vtkRank1ShaderText::GetLookUp(this->Input, interpolation, 1), implementation, points, 4,
      [this](vtkShaderProgram* program)
      { program->SetUniformi("in_rank1Texels", this->Texels.Texture->GetTextureUnit()); });
    this->Texels.Texture->Deactivate();
    return result;
  }
};

// How many indices of points in reach of the unit square's cells differ.
int CompareIndices(vtkOpenGLRenderWindow* window, vtkMinimalStandardRandomSequence* random,
  Texture& texture, const bravais::Rank1Lattice& lattice)
{
  std::vector<float> points;
  for (int i = 0; i < Count; ++i)
  {
    const glm::dvec2 st =
      glm::floor(lattice.ToBasis({ Random(random, -0.1, 1.1), Random(random, -0.1, 1.1) }));
    points.insert(points.end(), { static_cast<float>(st.x), static_cast<float>(st.y), 0.0f, 0.0f });
  }
  const auto drawn = texture.Draw(
    window, 0, "gl_FragData[0] = vec4(Rank1Index(GetRank1Texture(0), ivec2(point.xy)));\n", points);
  int wrong = 0;
  for (int i = 0; i < Count; ++i)
  {
    const auto index = lattice.GetIndex(
      static_cast<std::int64_t>(points[4 * i]), static_cast<std::int64_t>(points[4 * i + 1]));
    wrong += drawn[4 * i] == static_cast<float>(index) ? 0 : 1;
  }
  return wrong;
}

double Interpolate(const bravais::Rank1Texture<double>& texture, int interpolation,
  const glm::dvec2& uv, vtkFloatArray* values)
{
  std::int64_t texels[12];
  double weights[12];
  int count = 0;
  switch (interpolation)
  {
    case 1:
      bravais::FindRank1Bilinear(texture, uv, texels, weights);
      count = 4;
      break;
    case 2:
      bravais::FindRank1Barycentric(texture, uv, texels, weights);
      count = 3;
      break;
    default:
      bravais::FindRank1BoxSpline(texture, uv, texels, weights);
      count = 12;
      break;
  }
  double value = 0.0;
  for (int i = 0; i < count; ++i)
  {
    value += weights[i] * values->GetValue(texels[i]);
  }
  return value;
}

// Points of the picture and around it, in x, y; where they are in z, w in higher precision.
std::vector<float> MakePoints(vtkMinimalStandardRandomSequence* random)
{
  std::vector<float> points;
  for (int i = 0; i < Count; ++i)
  {
    const double reach = i % 3 == 0 ? 1.0 : 0.0;
    for (int axis = 0; axis < 2; ++axis)
    {
      points.push_back(static_cast<float>(Random(random, -reach, 1.0 + reach)));
    }
    points.insert(points.end(), { 0.0f, 0.0f });
  }
  return points;
}

// Values at random points; the nearest texel is the nearest one, up to rounding.
bool CompareValues(vtkOpenGLRenderWindow* window, vtkMinimalStandardRandomSequence* random,
  Texture& texture, const Case& about, const bravais::Rank1Lattice& lattice)
{
  const auto exact = bravais::MakeRank1Texture<double>(lattice, about.S, about.T);
  auto* values = vtkFloatArray::SafeDownCast(texture.Input.Texels[0]);
  const auto points = MakePoints(random);
  // How far basis coordinates are off for coordinates that are off by a float's rounding of them.
  const glm::dvec4 rows = glm::abs(exact.ToBasis) * glm::dvec4(about.S, about.T, about.S, about.T);
  const double rounding = 4.0 * std::ldexp(rows.x + rows.y + rows.z + rows.w, -24) + 1e-6;
  bool good = true;
  for (int interpolation = 0; interpolation < 4; ++interpolation)
  {
    const auto drawn =
      texture.Draw(window, interpolation, "gl_FragData[0] = LookUpLevel(0, point.xy);\n", points);
    double error = 0.0;
    for (int i = 0; i < Count; ++i)
    {
      const glm::dvec2 uv(points[4 * i], points[4 * i + 1]);
      double difference = 0.0;
      if (interpolation > 0)
      {
        difference = std::abs(Interpolate(exact, interpolation, uv, values) - drawn[4 * i]);
      }
      else
      {
        // One of the texels that are nearest to points around, as far as rounding moves a point.
        difference = 1.0;
        for (int way = 0; way < 9 && difference > 0.0; ++way)
        {
          const double step = 4.0 * std::ldexp(1.0, -24);
          const glm::dvec2 near = uv + step * glm::dvec2(way % 3 - 1, way / 3 - 1);
          const auto texel = bravais::FindRank1Nearest(exact, near);
          difference = values->GetValue(texel) == drawn[4 * i] ? 0.0 : difference;
        }
      }
      error = Worse(error, difference);
    }
    const double most = interpolation == 0 ? 0.0 : rounding;
    vtkLog(INFO, << "n " << about.N << ", " << about.S << " x " << about.T << " tiles, mode "
                 << interpolation << ": error " << error << " of at most " << most);
    good = good && error <= most;
  }
  return good;
}

// Footprints of all sizes and shapes; levels are compared, and members wherever rounding does not
// decide on them.
bool CompareLevels(
  vtkOpenGLRenderWindow* window, vtkMinimalStandardRandomSequence* random, Texture& texture)
{
  std::vector<float> footprints;
  for (int i = 0; i < Count; ++i)
  {
    const double scale = std::exp2(Random(random, -12, 1));
    const double stretch = std::exp2(Random(random, -4, 4));
    for (int axis = 0; axis < 4; ++axis)
    {
      const double factor = axis % 2 ? stretch : 1.0;
      footprints.push_back(static_cast<float>(scale * factor * Random(random, -1, 1)));
    }
  }
  const glm::dvec2 density(300, 200);
  const glm::ivec2 levels(6, 4);
  const auto levelsDrawn = texture.Draw(window, 0,
    "vec2 d = vec2(300.0, 200.0);\nfloat level = GetRank1MipLevel(point, d);\n"
    "Rank1LevelBlend blend = GetRank1LevelBlend(level, 6);\n"
    "gl_FragData[0] = vec4(level, float(blend.Lower) + blend.Weight, blend.Upper - blend.Lower, "
    "GetNearestRank1Level(level, 6));\n",
    footprints);
  const auto membersDrawn = texture.Draw(window, 0,
    "vec2 level = GetRank1MemberLevel(point, vec2(300.0, 200.0));\n"
    "gl_FragData[0] = vec4(level, GetRank1Member(level, ivec2(6, 4)));\n",
    footprints);
  double error = 0.0;
  int wrong = 0;
  for (int i = 0; i < Count; ++i)
  {
    const float* p = footprints.data() + 4 * i;
    const glm::dvec4 footprint(p[0], p[1], p[2], p[3]);
    const double level = bravais::GetRank1MipLevel(footprint, density);
    const auto blend = bravais::GetRank1LevelBlend(level, 6);
    const float* got = levelsDrawn.data() + 4 * i;
    error = Worse(error, std::abs(level - got[0]));
    error = Worse(error, std::abs(blend.Lower + blend.Weight - got[1]));
    wrong += got[2] == 1.0f ? 0 : 1;
    const float own = static_cast<float>(bravais::GetNearestRank1Level(got[0], 6));
    wrong += got[3] == own ? 0 : 1;
    const glm::dvec2 member = bravais::GetRank1MemberLevel(footprint, density);
    const float* gotMember = membersDrawn.data() + 4 * i;
    error = Worse(error, std::abs(member.x - gotMember[0]));
    error = Worse(error, std::abs(member.y - gotMember[1]));
    // By the shader's own levels, and those a rounding away.
    bool found = false;
    for (double off : { 0.0, 1e-5, -1e-5 })
    {
      const glm::ivec2 expected =
        bravais::GetRank1Member(glm::dvec2(gotMember[0] + off, gotMember[1] - off), levels);
      found = found ||
        (static_cast<float>(expected.x) == gotMember[2] &&
          static_cast<float>(expected.y) == gotMember[3]);
    }
    wrong += found ? 0 : 1;
  }
  vtkLog(INFO, << "Levels: error " << error << ", " << wrong << " wrong");
  return error < 2e-5 && wrong == 0;
}
}

namespace
{
bool IsGood(vtkRenderWindow* window)
{
  window->MakeCurrent();
  const unsigned int error = glGetError();
  vtkLog(INFO, << "OpenGL error " << error);
  return error == GL_NO_ERROR;
}

// Frames of all kinds of texels and look-ups, and after a release.
bool DrawFrames(vtkRenderWindow* window, vtkMinimalStandardRandomSequence* random)
{
  vtkNew<vtkPlaneSource> plane;
  vtkNew<vtkRank1TexturedPolyDataMapper> mapper;
  mapper->SetInputConnection(plane->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  vtkNew<vtkRenderer> renderer;
  renderer->AddActor(actor);
  window->AddRenderer(renderer);
  for (int kind = 0; kind < 8; ++kind)
  {
    const bool tiled = kind % 2 != 0;
    mapper->SetTextureData(MakeImage({ 97, 5, 31, tiled ? 3 : 1, 1, 1, 1 }, random));
    mapper->SetInterpolation(kind / 2);
    mapper->SetHalfPrecision(kind % 3 == 0);
    window->Render();
    if (kind == 5)
    {
      actor->ReleaseGraphicsResources(window);
    }
  }
  window->RemoveRenderer(renderer);
  return mapper->GetTexelTime() > 0;
}
}

int TestRank1ShaderParity(int, char*[])
{
  vtkNew<vtkRenderWindow> renderWindow;
  renderWindow->SetOffScreenRendering(true);
  renderWindow->SetSize(Side, Side);
  renderWindow->Render();
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderWindow);
  vtkNew<vtkMinimalStandardRandomSequence> random;
  random->SetSeed(31);
  bool good = true;
  for (const Case& about : Cases)
  {
    const auto image = MakeImage(about, random);
    const auto lattice = *bravais::Rank1Lattice::Create(
      about.N, about.G1, about.G2, { about.Width / about.S, about.Height / about.T });
    Texture texture;
    if (!texture.Set(window, image))
    {
      return EXIT_FAILURE;
    }
    const int wrong = CompareIndices(window, random, texture, lattice);
    vtkLog(INFO, << "n " << about.N << ": " << wrong << " wrong indices");
    good = CompareValues(window, random, texture, about, lattice) && wrong == 0 && good;
    if (about.N == 56)
    {
      good = CompareLevels(window, random, texture) && good;
    }
    texture.Texels.Release(window);
  }
  good = IsGood(renderWindow) && good;
  good = DrawFrames(renderWindow, random) && IsGood(renderWindow) && good;
  return good ? EXIT_SUCCESS : EXIT_FAILURE;
}
