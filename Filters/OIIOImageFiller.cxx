// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "OIIOImageFiller.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cstring>

namespace bravais
{

namespace
{

/// One component of `count` points, from a channel of a row to a component of a row.
void CopyComponent(
  const char* from, std::size_t fromStep, char* to, std::size_t toStep, std::size_t size, int count)
{
  for (int point = 0; point < count; ++point, from += fromStep, to += toStep)
  {
    switch (size)
    {
      case 1:
        *to = *from;
        break;
      case 2:
        std::memcpy(to, from, 2);
        break;
      case 4:
        std::memcpy(to, from, 4);
        break;
      default:
        std::memcpy(to, from, 8);
    }
  }
}

} // namespace

//------------------------------------------------------------------------------
std::vector<OIIOImageFiller::Run> OIIOImageFiller::MakeRuns(const OIIO::ImageSpec& spec)
{
  std::vector<Run> runs;
  for (int channel = 0; channel < spec.nchannels; ++channel)
  {
    OIIO::TypeDesc type = spec.channelformat(channel);
    type = type == OIIO::TypeDesc::HALF ? OIIO::TypeDesc(OIIO::TypeDesc::FLOAT) : type;
    if (runs.empty() || runs.back().Type != type)
    {
      runs.push_back({ { channel, channel }, type, {} });
    }
    runs.back().Channels[1] = channel + 1;
  }
  return runs;
}

//------------------------------------------------------------------------------
OIIOImageFiller::OIIOImageFiller(
  OIIOImageFile& file, vtkImageData* output, const int extent[6], bool flip)
  : Output(output)
  , Flip(flip)
  , Runs(MakeRuns(file.GetSpec()))
{
  std::copy_n(extent, 6, this->Extent);
  this->SetFile(file);
}

//------------------------------------------------------------------------------
void OIIOImageFiller::SetFile(OIIOImageFile& file)
{
  this->File = &file;
  file.GetReadColumns(this->Extent[0], this->Extent[1], this->Columns[0], this->Columns[1]);
}

//------------------------------------------------------------------------------
void OIIOImageFiller::GetRows(int rows[2]) const
{
  const int height = this->File->GetSpec().height;
  rows[0] = this->Flip ? height - 1 - this->Extent[3] : this->Extent[2];
  rows[1] = 1 + (this->Flip ? height - 1 - this->Extent[2] : this->Extent[3]);
}

//------------------------------------------------------------------------------
bool OIIOImageFiller::ReadBlock(const int rows[2], int layer, std::string& why)
{
  for (Run& run : this->Runs)
  {
    const std::size_t points = static_cast<std::size_t>(this->Columns[1] - this->Columns[0]) *
      static_cast<std::size_t>(rows[1] - rows[0]);
    run.Values.resize(points * (run.Channels[1] - run.Channels[0]) * run.Type.size());
    if (!this->File->ReadBlock(
          this->Columns, rows, layer, run.Channels, run.Type, run.Values.data(), why))
    {
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
void OIIOImageFiller::Allocate()
{
  const OIIO::ImageSpec& spec = this->File->GetSpec();
  this->Output->SetExtent(this->Extent);
  for (const OIIOChannelArray& array : this->File->GetArrays())
  {
    vtkSmartPointer<vtkDataArray> values;
    values.TakeReference(vtkDataArray::CreateDataArray(array.Type));
    values->SetName(array.Name.c_str());
    values->SetNumberOfComponents(static_cast<int>(array.Channels.size()));
    values->SetNumberOfTuples(this->Output->GetNumberOfPoints());
    for (std::size_t component = 0; component < array.Channels.size(); ++component)
    {
      const std::size_t channel = array.Channels[component];
      values->SetComponentName(static_cast<vtkIdType>(component),
        channel < spec.channelnames.size() ? spec.channelnames[channel].c_str() : "");
    }
    vtkPointData* data = this->Output->GetPointData();
    const int place = data->AddArray(values);
    if (this->Arrays.empty())
    {
      data->SetActiveAttribute(place, vtkDataSetAttributes::SCALARS);
    }
    this->Arrays.push_back(values);
  }
}

//------------------------------------------------------------------------------
void OIIOImageFiller::StoreBlock(const int rows[2], int k)
{
  int wanted[2];
  this->GetRows(wanted);
  const int height = this->File->GetSpec().height;
  for (int row = std::max(rows[0], wanted[0]); row < std::min(rows[1], wanted[1]); ++row)
  {
    const vtkIdType j = (this->Flip ? height - 1 - row : row) - this->Extent[2];
    for (std::size_t index = 0; index < this->Arrays.size(); ++index)
    {
      this->StoreRow(index, row - rows[0], j, k - this->Extent[4]);
    }
  }
}

//------------------------------------------------------------------------------
void OIIOImageFiller::StoreRow(std::size_t index, std::size_t row, vtkIdType j, vtkIdType k)
{
  const std::vector<int>& channels = this->File->GetArrays()[index].Channels;
  const vtkIdType width = vtkIdType{ this->Extent[1] } - this->Extent[0] + 1;
  const vtkIdType height = vtkIdType{ this->Extent[3] } - this->Extent[2] + 1;
  for (const Run& run : this->Runs)
  {
    const int first = run.Channels[0];
    const int last = run.Channels[1];
    const std::size_t size = run.Type.size();
    const std::size_t fromStep = size * (last - first);
    const std::size_t toStep = size * channels.size();
    const char* from = run.Values.data() +
      (row * (this->Columns[1] - this->Columns[0]) + this->Extent[0] - this->Columns[0]) * fromStep;
    char* to = static_cast<char*>(this->Arrays[index]->GetVoidPointer(0)) +
      (k * height + j) * width * static_cast<vtkIdType>(toStep);
    bool all = fromStep == toStep;
    for (std::size_t c = 0; all && c < channels.size(); ++c)
    {
      all = channels[c] == first + static_cast<int>(c);
    }
    if (all)
    {
      std::memcpy(to, from, static_cast<std::size_t>(width) * toStep);
      continue;
    }
    for (std::size_t c = 0; c < channels.size(); ++c)
    {
      if (channels[c] >= first && channels[c] < last)
      {
        CopyComponent(from + (channels[c] - first) * size, fromStep, to + c * size, toStep, size,
          static_cast<int>(width));
      }
    }
  }
}

} // namespace bravais
