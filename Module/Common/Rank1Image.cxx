// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Rank1Image.h"

#include "ImageChecks.h"
#include "LatticeTag.h"

#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkTypeInt64Array.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <sstream>

namespace bravais
{

namespace
{

constexpr const char* GeneratorName = "Rank1.Generator";
constexpr const char* DomainName = "Rank1.Domain";

/// A field array with so many numbers, or nullptr.
vtkDataArray* FindNumbers(vtkImageData* image, const char* name, int count, std::string& why)
{
  vtkDataArray* array = image->GetFieldData()->GetArray(name);
  if (!array || array->GetNumberOfValues() != count)
  {
    why = std::string("The input's field data have ") +
      (array ? std::to_string(array->GetNumberOfValues()) + " numbers " : "no array ") + name +
      "; a rank-1 image needs " + std::to_string(count) + " numbers of that name.";
    return nullptr;
  }
  return array;
}

/// A number of an array of any shape.
double GetNumber(vtkDataArray* array, int i)
{
  const int components = array->GetNumberOfComponents();
  return array->GetComponent(i / components, i % components);
}

} // namespace

//------------------------------------------------------------------------------
std::string ExplainRank1Lattice(
  long long n, long long g1, long long g2, double width, double height)
{
  std::ostringstream text;
  if (n < 1 || n > Rank1Lattice::MaximumNumberOfPoints)
  {
    text << "The number of points is " << n << "; 1 to " << Rank1Lattice::MaximumNumberOfPoints
         << " were expected.";
  }
  else if (!Rank1Lattice::IsSize({ width, height }))
  {
    text << "The area is " << width << " x " << height
         << "; two positive, finite lengths were expected, neither more than "
         << Rank1Lattice::MaximumAspect << " times the other.";
  }
  else if (const long long divisor = std::gcd(std::gcd(g1 % n, g2 % n), n); divisor != 1)
  {
    text << "The generator (" << g1 << ", " << g2 << ") makes " << n / divisor << " points, not "
         << n << ": no common divisor of both and " << n << " was expected, and " << divisor
         << " is one.";
  }
  return text.str();
}

//------------------------------------------------------------------------------
void TagRank1Image(vtkImageData* image, const Rank1Lattice& lattice, const double domain[4])
{
  TagLattice(image, Rank1Tag);
  vtkNew<vtkTypeInt64Array> generator;
  generator->SetName(GeneratorName);
  generator->InsertNextValue(lattice.GetNumberOfPoints());
  generator->InsertNextValue(lattice.GetGenerator().x);
  generator->InsertNextValue(lattice.GetGenerator().y);
  image->GetFieldData()->AddArray(generator);
  vtkNew<vtkDoubleArray> corners;
  corners->SetName(DomainName);
  for (int i = 0; i < 4; ++i)
  {
    corners->InsertNextValue(domain[i]);
  }
  image->GetFieldData()->AddArray(corners);
}

//------------------------------------------------------------------------------
std::optional<Rank1Image> ReadRank1Image(vtkImageData* image, std::string& why)
{
  if (!image)
  {
    why = "There is no input image; a rank-1 image was expected.";
    return std::nullopt;
  }
  if (!HasLatticeTag(image, Rank1Tag))
  {
    why = "The input is not tagged as a rank-1 image: its field data need a string array Lattice "
          "that holds Rank1.";
    return std::nullopt;
  }
  vtkDataArray* numbers = FindNumbers(image, GeneratorName, 3, why);
  vtkDataArray* corners = numbers ? FindNumbers(image, DomainName, 4, why) : nullptr;
  if (!corners)
  {
    return std::nullopt;
  }
  constexpr double limit = 9007199254740992.0; // integers are exact up to there
  std::int64_t generator[3];
  for (int i = 0; i < 3; ++i)
  {
    const double number = GetNumber(numbers, i);
    if (!(std::abs(number) <= limit) || number != std::trunc(number))
    {
      why = "The input's field data have " + std::to_string(number) + " in " + GeneratorName +
        "; whole numbers were expected.";
      return std::nullopt;
    }
    generator[i] = static_cast<std::int64_t>(number);
  }
  double domain[4];
  for (int i = 0; i < 4; ++i)
  {
    domain[i] = GetNumber(corners, i);
  }
  int dimensions[3];
  image->GetDimensions(dimensions);
  if (dimensions[0] != generator[0] || dimensions[1] < 1 || dimensions[2] < 1)
  {
    why = "The input's dimensions are " + JoinDimensions(image->GetExtent()) +
      "; for a lattice of " + std::to_string(generator[0]) +
      " points, that number, and at least one tile each way, were expected.";
    return std::nullopt;
  }
  const double width = (domain[1] - domain[0]) / dimensions[1];
  const double height = (domain[3] - domain[2]) / dimensions[2];
  why = ExplainRank1Lattice(generator[0], generator[1], generator[2], width, height);
  if (!why.empty())
  {
    return std::nullopt;
  }
  vtkDataArray* scalars = image->GetPointData()->GetScalars();
  if (!scalars || scalars->GetNumberOfComponents() < 1 ||
    scalars->GetNumberOfTuples() < image->GetNumberOfPoints())
  {
    why = "The input has no point scalars, or fewer than points.";
    return std::nullopt;
  }
  if (!IsNumberType(scalars->GetDataType()))
  {
    why = std::string("The input's scalars are of type ") + scalars->GetDataTypeAsString() +
      "; numbers of 8 to 64 bits were expected.";
    return std::nullopt;
  }
  Rank1Image result{ *Rank1Lattice::Create(
                       generator[0], generator[1], generator[2], { width, height }),
    { dimensions[1], dimensions[2] }, {}, scalars };
  std::copy_n(domain, 4, result.Domain);
  return result;
}

} // namespace bravais
