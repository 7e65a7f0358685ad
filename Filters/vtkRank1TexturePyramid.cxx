// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRank1TexturePyramid.h"

#include "ImageChecks.h"
#include "PieceRequest.h"
#include "Rank1Levels.h"

#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkDataObjectTree.h"
#include "vtkDataObjectTreeIterator.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMatrix3x3.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <vector>

vtkStandardNewMacro(vtkRank1TexturePyramid);

//------------------------------------------------------------------------------
const char* vtkRank1TexturePyramid::GetKindAsString()
{
  return this->Kind == RSet ? "RSet" : "MipLevels";
}

//------------------------------------------------------------------------------
const char* vtkRank1TexturePyramid::GetLayoutAsString()
{
  return this->Layout == Locality ? "Locality" : "Korobov";
}

//------------------------------------------------------------------------------
const char* vtkRank1TexturePyramid::GetFilterAsString()
{
  constexpr const char* names[] = { "Box", "Bilinear", "Bicubic", "Nearest", "Automatic" };
  return names[this->Filter];
}

//------------------------------------------------------------------------------
const char* vtkRank1TexturePyramid::GetBoundaryModeAsString()
{
  constexpr const char* names[] = { "Periodic", "Clamp", "Mirror" };
  return names[this->BoundaryMode];
}

//------------------------------------------------------------------------------
int vtkRank1TexturePyramid::FillInputPortInformation(int vtkNotUsed(port), vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  // Else VTK would put this filter's blocks and those of the input into one output.
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  return 1;
}

//------------------------------------------------------------------------------
int vtkRank1TexturePyramid::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*)
{
  bravais::RequestWholeExtent(inputVector[0]->GetInformationObject(0));
  return 1;
}

namespace
{

bravais::Rank1ResampleParameters GetParameters(vtkRank1TexturePyramid* self)
{
  bravais::Rank1ResampleParameters parameters;
  parameters.NumberOfPoints = self->GetNumberOfPoints();
  std::copy_n(self->GetTiles(), 2, parameters.Tiles);
  std::copy_n(self->GetGenerator(), 2, parameters.Generator);
  parameters.Layout = static_cast<bravais::Rank1Layout>(self->GetLayout());
  if (self->GetFilter() != vtkRank1TexturePyramid::Automatic)
  {
    parameters.Filter = static_cast<bravais::Rank1Filter>(self->GetFilter());
  }
  parameters.Boundary = static_cast<bravais::Rank1Boundary>(self->GetBoundaryMode());
  return parameters;
}

/// The extent (n, S, T) of a level, and how many texels it has.
double GetExtent(const bravais::Rank1LevelPlan& plan, int extent[6])
{
  const vtkIdType dimensions[3] = { plan.Parameters.NumberOfPoints, plan.Parameters.Tiles[0],
    plan.Parameters.Tiles[1] };
  double texels = 1.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    extent[2 * axis] = 0;
    extent[2 * axis + 1] = static_cast<int>(dimensions[axis]) - 1;
    texels *= static_cast<double>(dimensions[axis]);
  }
  return texels;
}

/// A picture, and where its levels are to be.
struct Picture
{
  vtkImageData* Image;
  vtkMultiBlockDataSet* Levels;
};

/// Makes `output` a tree like `input`, with a pyramid for each image.
bool ListPictures(vtkDataObject* input, vtkMultiBlockDataSet* output,
  std::vector<Picture>& pictures, std::string& why)
{
  if (auto* image = vtkImageData::SafeDownCast(input))
  {
    pictures.push_back({ image, output });
    return true;
  }
  auto* tree = vtkDataObjectTree::SafeDownCast(input);
  if (!tree)
  {
    why = std::string("The input is or holds a ") + input->GetClassName() +
      "; a picture, or a vtkMultiBlockDataSet of pictures, was expected.";
    return false;
  }
  vtkSmartPointer<vtkDataObjectTreeIterator> child;
  child.TakeReference(tree->NewTreeIterator());
  child->TraverseSubTreeOff();
  child->VisitOnlyLeavesOff();
  child->SkipEmptyNodesOff();
  unsigned int block = 0;
  for (child->InitTraversal(); !child->IsDoneWithTraversal(); child->GoToNextItem(), ++block)
  {
    output->SetNumberOfBlocks(block + 1);
    if (child->HasCurrentMetaData())
    {
      output->GetMetaData(block)->Copy(child->GetCurrentMetaData(), 1);
    }
    if (vtkDataObject* object = child->GetCurrentDataObject())
    {
      vtkNew<vtkMultiBlockDataSet> own;
      output->SetBlock(block, own);
      if (!ListPictures(object, own, pictures, why))
      {
        return false;
      }
    }
  }
  return true;
}

} // namespace

//------------------------------------------------------------------------------
bool vtkRank1TexturePyramid::MakeLevels(
  vtkImageData* image, vtkMultiBlockDataSet* levels, double begin, double end, std::string& why)
{
  double* direction = image->GetDirectionMatrix()->GetData();
  const auto picture = bravais::Rank1Picture::Create(
    image->GetExtent(), image->GetOrigin(), image->GetSpacing(), direction, why);
  int dimensions[3];
  const bravais::Rank1ResampleParameters parameters = GetParameters(this);
  if (!picture || !bravais::CheckRank1Input(image, why) ||
    !bravais::FindRank1Dimensions(*picture, parameters, dimensions, why))
  {
    return false;
  }
  vtkDataArray* pixels = image->GetPointData()->GetScalars();
  const int bytes = pixels->GetNumberOfComponents() * pixels->GetDataTypeSize();
  const int whole[6] = { 0, dimensions[0] - 1, 0, dimensions[1] - 1, 0, dimensions[2] - 1 };
  const int copies = this->Kind == RSet ? 4 : 2; // 4/3, rounded up
  if (!bravais::CheckMemory(whole, copies * bytes, why))
  {
    return false;
  }
  const auto plans = this->Kind == RSet
    ? bravais::PlanRank1RSet(*picture, parameters, why)
    : bravais::PlanRank1MipLevels(*picture, parameters, this->NumberOfLevels, why);
  if (!plans)
  {
    return false;
  }

  const double local[3] = { 0.0, 0.0, picture->Z };
  double origin[3];
  vtkMatrix3x3::MultiplyPoint(direction, local, origin);
  const double length = end - begin;
  double total = 0.0;
  int extent[6];
  for (const bravais::Rank1LevelPlan& plan : *plans)
  {
    total += GetExtent(plan, extent);
  }
  for (unsigned int block = 0; block < plans->size(); ++block)
  {
    const bravais::Rank1LevelPlan& plan = (*plans)[block];
    const double next = std::min(end, begin + GetExtent(plan, extent) / total * length);
    vtkNew<vtkImageData> level;
    level->SetOrigin(origin);
    level->SetDirectionMatrix(direction);
    levels->SetBlock(block, level);
    levels->GetMetaData(block)->Set(vtkCompositeDataSet::NAME(), plan.Name.c_str());
    if (!bravais::ResampleToRank1(
          this, *picture, plan.Parameters, plan.Lattice, pixels, extent, level, begin, next))
    {
      return false; // aborted
    }
    begin = next;
  }
  return true;
}

//------------------------------------------------------------------------------
int vtkRank1TexturePyramid::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataObject* input = vtkDataObject::GetData(inputVector[0]);
  vtkMultiBlockDataSet* output = vtkMultiBlockDataSet::GetData(outputVector);
  output->Initialize();
  const auto fail = [&](const std::string& why)
  {
    vtkErrorMacro(<< why);
    output->Initialize();
    return 0;
  };
  if (!input)
  {
    return fail("There is no input image; a picture was expected.");
  }
  if (this->NumberOfLevels < 0)
  {
    return fail("NumberOfLevels is " + std::to_string(this->NumberOfLevels) +
      "; a positive number, or 0 for all levels, was expected.");
  }
  std::string why;
  std::vector<Picture> pictures;
  if (!bravais::CheckRank1Parameters(GetParameters(this), why) ||
    !ListPictures(input, output, pictures, why))
  {
    return fail(why);
  }
  const auto count = static_cast<double>(pictures.size());
  for (std::size_t index = 0; index < pictures.size(); ++index)
  {
    const auto place = static_cast<double>(index);
    const Picture& picture = pictures[index];
    if (!this->MakeLevels(picture.Image, picture.Levels, place / count, (place + 1) / count, why))
    {
      if (!why.empty())
      {
        return fail(pictures.size() == 1 ? why
                                         : "Of picture " + std::to_string(index + 1) + " of " +
              std::to_string(pictures.size()) + ": " + why);
      }
      output->Initialize(); // aborted
      return 1;
    }
  }
  this->UpdateProgress(1.0);
  return 1;
}

//------------------------------------------------------------------------------
void vtkRank1TexturePyramid::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Kind: " << this->GetKindAsString() << "\n";
  os << indent << "NumberOfLevels: " << this->NumberOfLevels << "\n";
  os << indent << "NumberOfPoints: " << this->NumberOfPoints << "\n";
  os << indent << "Tiles: (" << this->Tiles[0] << ", " << this->Tiles[1] << ")\n";
  os << indent << "Generator: (" << this->Generator[0] << ", " << this->Generator[1] << ")\n";
  os << indent << "Layout: " << this->GetLayoutAsString() << "\n";
  os << indent << "Filter: " << this->GetFilterAsString() << "\n";
  os << indent << "BoundaryMode: " << this->GetBoundaryModeAsString() << "\n";
}
