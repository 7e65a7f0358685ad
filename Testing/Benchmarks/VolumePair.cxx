// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "VolumePair.h"

#include "vtkBCCLattice.h"
#include "vtkImageToBCCVolume.h"

#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkMetaImageReader.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace bravais
{
namespace
{

using Function = std::function<double(const double[3])>;

double MarschnerLobb(const double x[3])
{
  const double pi = std::acos(-1.0);
  const double rho = std::cos(12.0 * pi * std::cos(0.5 * pi * std::hypot(x[0], x[1])));
  return (1.0 - std::sin(0.5 * pi * x[2]) + 0.25 * (1.0 + rho)) / 2.5;
}

/// Skin at -100, brain about 40, bone about 1000 in air of -1000, on -1 .. 1 cubed.
double Head(const double x[3])
{
  const auto ellipsoid = [&](double a, double b, double c)
  {
    const double d[3] = { x[0] / a, x[1] / b, x[2] / c };
    return std::sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]) - 1.0;
  };
  const auto inside = [](double distance) { return 0.5 - 0.5 * std::tanh(60.0 * distance); };
  const double skin = inside(ellipsoid(0.72, 0.9, 0.85));
  const double bone = inside(ellipsoid(0.65, 0.82, 0.78)) - inside(ellipsoid(0.58, 0.75, 0.71));
  const double folds = 20.0 * std::sin(20.0 * x[0]) * std::sin(17.0 * x[1]) * std::sin(23.0 * x[2]);
  return -1000.0 + 1040.0 * skin + 1000.0 * bone + folds * skin;
}

void Fill(vtkImageData* image, bool bcc, const Function& function)
{
  vtkNew<vtkFloatArray> values;
  values->SetName("Scalars");
  values->SetNumberOfTuples(image->GetNumberOfPoints());
  const int* size = image->GetDimensions();
  vtkSMPTools::For(0, size[2],
    [&](vtkIdType begin, vtkIdType end)
    {
      for (int k = static_cast<int>(begin); k < end; ++k)
      {
        const double* origin = image->GetOrigin();
        const double* h = image->GetSpacing();
        const double shift = bcc ? 0.5 * (k & 1) : 0.0;
        vtkIdType id = static_cast<vtkIdType>(k) * size[0] * size[1];
        for (int j = 0; j < size[1]; ++j)
        {
          for (int i = 0; i < size[0]; ++i, ++id)
          {
            const double x[3] = { origin[0] + h[0] * (i + shift), origin[1] + h[1] * (j + shift),
              origin[2] + h[2] * k };
            values->SetValue(id, static_cast<float>(function(x)));
          }
        }
      }
    });
  image->GetPointData()->SetScalars(values);
}

/// A function on -1 .. 1 cubed, on both lattices.
void MakePair(VolumePair& pair, const int dimensions[3], const Function& function)
{
  pair.BCC = vtkSmartPointer<vtkImageData>::New();
  pair.BCC->SetDimensions(dimensions);
  pair.BCC->SetOrigin(-1, -1, -1);
  pair.BCC->SetSpacing(
    2.0 / (dimensions[0] - 0.5), 2.0 / (dimensions[1] - 0.5), 2.0 / (dimensions[2] - 1));
  vtkBCCLattice::Tag(pair.BCC);
  Fill(pair.BCC, true, function);
  // As many points, in the same proportions but for the two cosets' layers.
  const double scale = std::cbrt(2.0);
  int size[3];
  for (int a = 0; a < 3; ++a)
  {
    size[a] =
      std::max(2, static_cast<int>(std::lround(dimensions[a] * (a == 2 ? 0.5 * scale : scale))));
  }
  pair.Cartesian = vtkSmartPointer<vtkImageData>::New();
  pair.Cartesian->SetDimensions(size);
  pair.Cartesian->SetOrigin(-1, -1, -1);
  pair.Cartesian->SetSpacing(2.0 / (size[0] - 1), 2.0 / (size[1] - 1), 2.0 / (size[2] - 1));
  Fill(pair.Cartesian, false, function);
}

void SetHeadOpacities(VolumePair& pair)
{
  pair.Opacities = { { -1000, 0 }, { -300, 0 }, { -100, 0.05 }, { 100, 0.1 }, { 300, 0.05 },
    { 1000, 0.8 } };
}

} // namespace

//------------------------------------------------------------------------------
VolumePair MakeMarschnerLobb(int n, int width, int height)
{
  VolumePair pair;
  pair.Name = "ML " + std::to_string(n);
  pair.IsoValue = 0.5;
  pair.Opacities = { { 0, 0 }, { 0.45, 0 }, { 0.5, 0.5 }, { 0.55, 0 }, { 1, 0 } };
  pair.Width = width;
  pair.Height = height;
  const int dimensions[3] = { n, n, 2 * n };
  MakePair(pair, dimensions, MarschnerLobb);
  return pair;
}

//------------------------------------------------------------------------------
VolumePair MakeHead(const std::string& name, const int dimensions[3], int width, int height)
{
  VolumePair pair;
  pair.Name = name;
  pair.IsoValue = 300.0;
  pair.Width = width;
  pair.Height = height;
  SetHeadOpacities(pair);
  MakePair(pair, dimensions, Head);
  return pair;
}

//------------------------------------------------------------------------------
VolumePair ReadPair(const std::string& path, double isoValue, int width, int height)
{
  VolumePair pair;
  pair.Name = path.substr(path.find_last_of('/') + 1);
  pair.IsoValue = isoValue;
  pair.Width = width;
  pair.Height = height;
  SetHeadOpacities(pair);
  vtkNew<vtkMetaImageReader> reader;
  if (reader->CanReadFile(path.c_str()))
  {
    reader->SetFileName(path.c_str());
    vtkNew<vtkImageToBCCVolume> toBCC;
    toBCC->SetInputConnection(reader->GetOutputPort());
    toBCC->SetModeToResample();
    toBCC->Update();
    pair.BCC = toBCC->GetOutput();
    pair.Cartesian = reader->GetOutput();
  }
  return pair;
}

} // namespace bravais
