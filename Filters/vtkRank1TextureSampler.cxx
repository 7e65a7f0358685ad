// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRank1TextureSampler.h"

#include "Rank1Texels.h"
#include "Rank1TileFile.h"
#include "SliceLoop.h"

#include "vtkAlgorithmOutput.h"
#include "vtkDataObject.h"
#include "vtkDoubleArray.h"
#include "vtkExecutive.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"

#include <algorithm>
#include <cmath>
#include <limits>

vtkStandardNewMacro(vtkRank1TextureSampler);

class vtkRank1TextureSampler::Internals
{
public:
  bravais::Rank1Texels Texels;
};

//------------------------------------------------------------------------------
vtkRank1TextureSampler::vtkRank1TextureSampler()
  : Internal(new Internals)
{
  this->SetNumberOfInputPorts(1);
  this->SetNumberOfOutputPorts(0);
}

//------------------------------------------------------------------------------
vtkRank1TextureSampler::~vtkRank1TextureSampler() = default;

//------------------------------------------------------------------------------
const char* vtkRank1TextureSampler::GetInterpolationAsString()
{
  constexpr const char* names[] = { "Nearest", "Bilinear", "Barycentric", "BoxSpline" };
  return names[this->Interpolation];
}

//------------------------------------------------------------------------------
const char* vtkRank1TextureSampler::GetLevelFilterAsString()
{
  return this->LevelFilter == Trilinear ? "Trilinear" : "NearestLevel";
}

//------------------------------------------------------------------------------
int vtkRank1TextureSampler::FillInputPortInformation(int vtkNotUsed(port), vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataObject");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1); // a file may take its place
  return 1;
}

//------------------------------------------------------------------------------
void vtkRank1TextureSampler::SetInputData(vtkDataObject* texture)
{
  this->SetInputDataInternal(0, texture);
}

//------------------------------------------------------------------------------
bool vtkRank1TextureSampler::Fail(const std::string& why)
{
  vtkErrorMacro(<< why);
  return false;
}

//------------------------------------------------------------------------------
bool vtkRank1TextureSampler::PrepareInput(std::string& why)
{
  bravais::Rank1Texels& texels = this->Internal->Texels;
  if (this->GetNumberOfInputConnections(0) == 0)
  {
    texels.Clear();
    why = "There is no texture; a rank-1 image, a pyramid of them, or a FileName was expected.";
    return false;
  }
  vtkExecutive* source = this->GetInputExecutive(0, 0);
  if (!source->Update(this->GetInputConnection(0, 0)->GetIndex()))
  {
    texels.Clear();
    return false; // the input has told why
  }
  return texels.SetSource(this->GetInputDataObject(0, 0), why);
}

//------------------------------------------------------------------------------
bool vtkRank1TextureSampler::Prepare()
{
  bravais::Rank1Texels& texels = this->Internal->Texels;
  std::string why;
  if (!this->FileName.empty())
  {
    if (!texels.SetFile(this->FileName, this->CacheSize, why))
    {
      return this->Fail(why);
    }
  }
  else if (!this->PrepareInput(why))
  {
    return why.empty() ? false : this->Fail(why);
  }
  texels.Sampling.Trilinear = this->LevelFilter == Trilinear;
  texels.Sampling.LookUp = static_cast<bravais::Rank1LookUp>(this->Interpolation);
  return true;
}

//------------------------------------------------------------------------------
int vtkRank1TextureSampler::GetNumberOfLevels()
{
  return this->Prepare() ? static_cast<int>(this->Internal->Texels.Sampling.Levels.size()) : 0;
}

//------------------------------------------------------------------------------
void vtkRank1TextureSampler::GetNumberOfMembers(int columnsAndRows[2])
{
  const bool prepared = this->Prepare();
  columnsAndRows[0] = prepared ? this->Internal->Texels.Sampling.Counts.x : 0;
  columnsAndRows[1] = prepared ? this->Internal->Texels.Sampling.Counts.y : 0;
}

//------------------------------------------------------------------------------
int vtkRank1TextureSampler::GetNumberOfComponents()
{
  return this->Prepare() ? this->Internal->Texels.GetNumberOfComponents() : 0;
}

//------------------------------------------------------------------------------
bool vtkRank1TextureSampler::IsRSet()
{
  return this->Prepare() && this->Internal->Texels.Sampling.IsRSet;
}

//------------------------------------------------------------------------------
double vtkRank1TextureSampler::GetLevel(double dudx, double dvdx, double dudy, double dvdy)
{
  return this->Prepare()
    ? bravais::GetRank1MipLevel({ dudx, dvdx, dudy, dvdy }, this->Internal->Texels.Sampling.Density)
    : std::numeric_limits<double>::quiet_NaN();
}

//------------------------------------------------------------------------------
void vtkRank1TextureSampler::GetMemberLevels(
  double dudx, double dvdx, double dudy, double dvdy, double levels[2])
{
  levels[0] = levels[1] = std::numeric_limits<double>::quiet_NaN();
  if (this->Prepare())
  {
    const glm::dvec2 level = bravais::GetRank1MemberLevel(
      { dudx, dvdx, dudy, dvdy }, this->Internal->Texels.Sampling.Density);
    levels[0] = level.x;
    levels[1] = level.y;
  }
}

//------------------------------------------------------------------------------
int vtkRank1TextureSampler::GetNearestLevel(double dudx, double dvdx, double dudy, double dvdy)
{
  int member[2];
  this->GetNearestMember(dudx, dvdx, dudy, dvdy, member);
  return member[0] < 0 ? -1 : member[0] + this->Internal->Texels.Sampling.Counts.x * member[1];
}

//------------------------------------------------------------------------------
void vtkRank1TextureSampler::GetNearestMember(
  double dudx, double dvdx, double dudy, double dvdy, int member[2])
{
  member[0] = member[1] = -1;
  const glm::dvec4 footprint(dudx, dvdx, dudy, dvdy);
  if (!std::isnan(dudx + dvdx + dudy + dvdy) && this->Prepare())
  {
    const glm::ivec2 nearest =
      bravais::GetRank1NearestMember(this->Internal->Texels.Sampling, footprint);
    member[0] = nearest.x;
    member[1] = nearest.y;
  }
}

//------------------------------------------------------------------------------
bool vtkRank1TextureSampler::Sample(
  double u, double v, double dudx, double dvdx, double dudy, double dvdy, double* value)
{
  if (!this->Prepare())
  {
    return false;
  }
  const double uv[2] = { u, v };
  const double footprint[4] = { dudx, dvdx, dudy, dvdy };
  this->Internal->Texels.Sample(1, uv, footprint, value);
  return this->CheckFile();
}

//------------------------------------------------------------------------------
bool vtkRank1TextureSampler::CheckFile()
{
  bravais::Rank1TileFile* file = this->Internal->Texels.GetFile();
  std::string why;
  return file && file->TakeFailure(why) ? this->Fail(why) : true;
}

namespace
{

/// Whether an array has so many components, and so many tuples or one for all.
bool CheckArray(const char* name, vtkDataArray* array, int components, int mostComponents,
  vtkIdType tuples, std::string& why)
{
  if (array && array->GetNumberOfComponents() >= components &&
    array->GetNumberOfComponents() <= mostComponents &&
    (tuples < 0 || array->GetNumberOfTuples() == tuples || array->GetNumberOfTuples() == 1))
  {
    return true;
  }
  why = std::string(name) + " are " +
    (array ? std::to_string(array->GetNumberOfTuples()) + " tuples of " +
          std::to_string(array->GetNumberOfComponents()) + " components"
           : std::string("no array")) +
    "; " + (tuples < 0 ? std::string("tuples") : std::to_string(tuples) + " tuples, or one,") +
    " of " + std::to_string(components) + " components were expected.";
  return false;
}

} // namespace

//------------------------------------------------------------------------------
bool vtkRank1TextureSampler::Sample(
  vtkDataArray* coordinates, vtkDataArray* footprints, vtkDataArray* values)
{
  std::string why;
  if (!values)
  {
    return this->Fail("The values are no array; an array for the result was expected.");
  }
  if (!CheckArray("The coordinates", coordinates, 2, 3, -1, why) ||
    (footprints &&
      !CheckArray("The footprints", footprints, 4, 4, coordinates->GetNumberOfTuples(), why)))
  {
    return this->Fail(why);
  }
  if (!this->Prepare())
  {
    return false;
  }
  const bravais::Rank1Texels& texels = this->Internal->Texels;
  const vtkIdType count = coordinates->GetNumberOfTuples();
  const int components = texels.GetNumberOfComponents();
  const bool single = footprints && footprints->GetNumberOfTuples() == 1;
  vtkNew<vtkDoubleArray> results; // one of the arguments may be the result
  results->SetNumberOfComponents(components);
  results->SetNumberOfTuples(count);

  constexpr vtkIdType run = 1024;
  const auto work = [&](int index)
  {
    double uv[2 * run];
    double footprint[4 * run] = {};
    const vtkIdType first = index * run;
    const vtkIdType size = std::min(run, count - first);
    for (vtkIdType i = 0; i < size; ++i)
    {
      double tuple[3];
      coordinates->GetTuple(first + i, tuple);
      std::copy_n(tuple, 2, uv + 2 * i);
      if (footprints)
      {
        footprints->GetTuple(single ? 0 : first + i, footprint + 4 * i);
      }
    }
    texels.Sample(size, uv, footprint, results->GetPointer(first * components));
  };
  const auto runs = static_cast<int>((count + run - 1) / run);
  const bool finished = runs == 0 || bravais::ForEachSlice(this, 0, runs - 1, work);
  if (!this->CheckFile() || !finished)
  {
    values->Initialize();
    return false;
  }
  const std::string name = values->GetName() ? values->GetName() : "";
  values->DeepCopy(results);
  values->SetName(name.empty() ? nullptr : name.c_str());
  return true;
}

//------------------------------------------------------------------------------
vtkIdType vtkRank1TextureSampler::GetCacheHits()
{
  bravais::Rank1TileFile* file = this->Internal->Texels.GetFile();
  return file ? file->GetHits() : 0;
}

//------------------------------------------------------------------------------
vtkIdType vtkRank1TextureSampler::GetCacheMisses()
{
  bravais::Rank1TileFile* file = this->Internal->Texels.GetFile();
  return file ? file->GetMisses() : 0;
}

//------------------------------------------------------------------------------
vtkIdType vtkRank1TextureSampler::GetCacheMemory()
{
  bravais::Rank1TileFile* file = this->Internal->Texels.GetFile();
  return file ? file->GetMemory() : 0;
}

//------------------------------------------------------------------------------
vtkIdType vtkRank1TextureSampler::GetPeakCacheMemory()
{
  bravais::Rank1TileFile* file = this->Internal->Texels.GetFile();
  return file ? file->GetPeakMemory() : 0;
}

//------------------------------------------------------------------------------
void vtkRank1TextureSampler::ResetStatistics()
{
  if (bravais::Rank1TileFile* file = this->Internal->Texels.GetFile())
  {
    file->ResetStatistics();
  }
}

//------------------------------------------------------------------------------
void vtkRank1TextureSampler::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: '" << this->FileName << "'\n";
  os << indent << "CacheSize: " << this->CacheSize << "\n";
  os << indent << "Interpolation: " << this->GetInterpolationAsString() << "\n";
  os << indent << "LevelFilter: " << this->GetLevelFilterAsString() << "\n";
}
