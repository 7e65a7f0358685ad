// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRank1TextureFileWriter.h"

#include "OIIOChannels.h"
#include "OIIOImageSink.h"
#include "PictureRows.h"
#include "Rank1Levels.h"
#include "Rank1TileFile.h"
#include "Rank1TileRows.h"

#include "vtkAlgorithmOutput.h"
#include "vtkDataObject.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkMatrix3x3.h"
#include "vtkObjectFactory.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <cmath>
#include <map>

vtkStandardNewMacro(vtkRank1TextureFileWriter);

//------------------------------------------------------------------------------
vtkRank1TextureFileWriter::vtkRank1TextureFileWriter()
{
  this->SetNumberOfInputPorts(1);
  this->SetNumberOfOutputPorts(0);
}

//------------------------------------------------------------------------------
const char* vtkRank1TextureFileWriter::GetLayoutAsString()
{
  return this->Layout == Locality ? "Locality" : "Korobov";
}

//------------------------------------------------------------------------------
const char* vtkRank1TextureFileWriter::GetBoundaryModeAsString()
{
  constexpr const char* names[] = { "Periodic", "Clamp", "Mirror" };
  return names[this->BoundaryMode];
}

//------------------------------------------------------------------------------
int vtkRank1TextureFileWriter::FillInputPortInformation(int vtkNotUsed(port), vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  return 1;
}

//------------------------------------------------------------------------------
void vtkRank1TextureFileWriter::SetInputData(vtkDataObject* picture)
{
  this->SetInputDataInternal(0, picture);
}

//------------------------------------------------------------------------------
bool vtkRank1TextureFileWriter::Write()
{
  this->SetAbortExecute(0);
  std::string why;
  const bool written = this->WriteFile(why);
  if (!written && !why.empty())
  {
    vtkErrorMacro(<< why);
  }
  return written;
}

namespace
{

using Pipeline = vtkStreamingDemandDrivenPipeline;

std::optional<bravais::Rank1Picture> GetPicture(vtkInformation* info, std::string& why)
{
  int whole[6] = { 0, -1, 0, -1, 0, -1 };
  double spacing[3] = { 1.0, 1.0, 1.0 };
  double origin[3] = { 0.0, 0.0, 0.0 };
  double direction[9];
  vtkMatrix3x3::Identity(direction);
  info->Get(Pipeline::WHOLE_EXTENT(), whole);
  if (info->Has(vtkDataObject::SPACING()))
  {
    info->Get(vtkDataObject::SPACING(), spacing);
  }
  if (info->Has(vtkDataObject::ORIGIN()))
  {
    info->Get(vtkDataObject::ORIGIN(), origin);
  }
  return bravais::Rank1Picture::Create(whole, origin, spacing, direction, why);
}

/// Powers of two that make about square tiles, of as many texels as the picture has pixels.
void ChooseTiles(const bravais::Rank1Picture& picture, double n, int tiles[2])
{
  const double width = picture.Domain[1] - picture.Domain[0];
  const double height = picture.Domain[3] - picture.Domain[2];
  const double count = static_cast<double>(picture.Pixels[0]) * picture.Pixels[1] / n;
  const auto power = [](double number)
  { return 1 << static_cast<int>(std::clamp(std::floor(std::log2(number) + 0.5), 0.0, 20.0)); };
  tiles[0] = power(std::sqrt(count * width / height));
  tiles[1] = power(count / tiles[0]);
}

/// The r-set on its way to the file, one row of the file's tiles after the other.
class Writer
{
public:
  Writer(vtkAlgorithm* self, bravais::PictureRows& picture,
    const std::vector<bravais::Rank1LevelPlan>& plans, const bravais::Rank1TileLayout& layout,
    bravais::OIIOImageSink& sink)
    : Self(self)
    , Picture(picture)
    , Plans(plans)
    , Layout(layout)
    , Sink(sink)
  {
  }

  /// Texels of type F from pixels of type T.
  template <class T, class F>
  bool Execute(std::int64_t mostBytes, std::string& why)
  {
    const auto columns = static_cast<int>(this->Layout.Columns.size());
    const auto rows = static_cast<int>(this->Layout.Rows.size());
    for (int j = 0; j < rows; ++j)
    {
      std::vector<bravais::Rank1TileRows> members;
      for (int i = 0; i < columns; ++i)
      {
        members.emplace_back(this->Plans[i + columns * j], this->Picture);
      }
      if (!this->ExecuteRow<T, F>(members, j, mostBytes, why))
      {
        return false;
      }
    }
    this->Self->UpdateProgress(1.0);
    return true;
  }

private:
  /// Rows of the picture that are worked on together: a row of tiles, or as many as fit.
  int GetStep(int reach, int j, std::int64_t rowBytes, std::int64_t mostBytes) const
  {
    const int height = this->Picture.GetHeight();
    const std::int64_t fit = mostBytes / rowBytes - 2 * std::int64_t{ reach };
    const double tile = std::max(16.0, static_cast<double>(height) / this->Layout.Rows[j]);
    const std::int64_t least = std::max(16, reach); // else most is read again and again
    return static_cast<int>(std::min<std::int64_t>(
      height, std::max(least, std::min<std::int64_t>(fit, std::ceil(tile)))));
  }

  /// All members (i, j) of one j, whose tiles come in the same order.
  template <class T, class F>
  bool ExecuteRow(const std::vector<bravais::Rank1TileRows>& members, int j, std::int64_t mostBytes,
    std::string& why)
  {
    int reach = 0;
    for (const bravais::Rank1TileRows& member : members)
    {
      reach = std::max(reach, member.GetReach());
    }
    const int components = this->Picture.GetNumberOfComponents();
    const int height = this->Picture.GetHeight();
    const std::int64_t rowBytes =
      std::int64_t{ this->Picture.GetWidth() } * components * static_cast<int>(sizeof(T));
    const int step = this->GetStep(reach, j, rowBytes, mostBytes);
    const int width = this->Layout.GetTotal(this->Layout.Columns);
    const std::size_t tileValues = static_cast<std::size_t>(this->Layout.GetPixels()) * components;
    std::map<int, std::vector<F>> tileRows; // those begun and not complete
    int next = 0;                           // the first row of tiles that was not written
    for (int first = 0; first < height; first += std::min(step, height - first))
    {
      const int last = first + std::min(step, height - first);
      if (!this->Picture.Fetch(first - reach, last + reach, why) || this->Self->GetAbortExecute())
      {
        return false;
      }
      int range[2];
      members[0].GetTileRows(first, last, range);
      range[0] = std::max(range[0], next); // rounding may touch one that is complete
      for (int y = range[0]; y < range[1]; ++y)
      {
        tileRows[y].resize(tileValues * width);
      }
      int offset = 0;
      for (const bravais::Rank1TileRows& member : members)
      {
        member.Execute<T, F>(this->Picture, first, last, range,
          [&](int x, int y) { return tileRows.at(y).data() + (offset + x) * tileValues; });
        offset += member.GetColumns();
      }
      for (; !tileRows.empty() && (last == height || members[0].IsComplete(next, last)); ++next)
      {
        if (!this->WriteTiles(tileRows.begin()->second, tileValues, j, next, why))
        {
          return false;
        }
        tileRows.erase(tileRows.begin());
      }
      const double share = static_cast<double>(last) / height;
      this->Self->UpdateProgress((j + share) / static_cast<double>(this->Layout.Rows.size()));
    }
    return true;
  }

  template <class F>
  bool WriteTiles(
    const std::vector<F>& values, std::size_t tileValues, int j, int tileRow, std::string& why)
  {
    const int count = this->Layout.GetTotal(this->Layout.Columns);
    const int row = this->Layout.GetFirst(this->Layout.Rows, j) + tileRow;
    for (int column = 0; column < count; ++column)
    {
      if (!this->Sink.GetOutput().write_tile(column * this->Layout.TileSize[0],
            row * this->Layout.TileSize[1], 0, OIIO::BaseTypeFromC<F>::value,
            values.data() + column * tileValues))
      {
        why = this->Sink.Explain("cannot be written");
        return false;
      }
    }
    return true;
  }

  vtkAlgorithm* Self;
  bravais::PictureRows& Picture;
  const std::vector<bravais::Rank1LevelPlan>& Plans;
  const bravais::Rank1TileLayout& Layout;
  bravais::OIIOImageSink& Sink;
};

} // namespace

//------------------------------------------------------------------------------
bool vtkRank1TextureFileWriter::WriteFile(std::string& why)
{
  if (this->GetNumberOfInputConnections(0) == 0)
  {
    why = "There is no input; an image was expected.";
    return false;
  }
  if (this->FileName.empty())
  {
    why = "FileName is not set; the name of a file was expected.";
    return false;
  }
  vtkAlgorithm* source = this->GetInputAlgorithm(0, 0);
  const int port = this->GetInputConnection(0, 0)->GetIndex();
  if (!source->GetExecutive()->UpdateInformation())
  {
    return false; // the input has told why
  }
  const auto picture = GetPicture(source->GetOutputInformation(port), why);
  if (!picture)
  {
    return false;
  }
  bravais::Rank1ResampleParameters parameters;
  parameters.NumberOfPoints = this->NumberOfPoints == 0 ? 4096 : this->NumberOfPoints;
  std::copy_n(this->Tiles, 2, parameters.Tiles);
  if (parameters.NumberOfPoints < 0)
  {
    why = "NumberOfPoints is " + std::to_string(parameters.NumberOfPoints) +
      "; a positive number, or 0 for 4096, was expected.";
    return false;
  }
  if (this->Tiles[0] == 0 && this->Tiles[1] == 0)
  {
    ChooseTiles(*picture, static_cast<double>(parameters.NumberOfPoints), parameters.Tiles);
  }
  std::copy_n(this->Generator, 2, parameters.Generator);
  parameters.Layout = static_cast<bravais::Rank1Layout>(this->Layout);
  const auto plans = bravais::PlanRank1RSet(*picture, parameters, why);
  if (!plans)
  {
    return false;
  }
  const auto& lattice = plans->front().Lattice;
  const auto layout = bravais::Rank1TileLayout::Create(
    { lattice.GetNumberOfPoints(), lattice.GetGenerator().x, lattice.GetGenerator().y },
    parameters.Tiles, picture->Domain);
  const std::int64_t size[2] = { std::int64_t{ layout.TileSize[0] } *
      layout.GetTotal(layout.Columns),
    std::int64_t{ layout.TileSize[1] } * layout.GetTotal(layout.Rows) };
  if (std::max(size[0], size[1]) > VTK_INT_MAX)
  {
    why = "The r-set of " + std::to_string(parameters.Tiles[0]) + " x " +
      std::to_string(parameters.Tiles[1]) + " tiles of " +
      std::to_string(parameters.NumberOfPoints) + " texels would be an image of " +
      std::to_string(size[0]) + " x " + std::to_string(size[1]) +
      " pixels; less than 2^31 each way were expected.";
    return false;
  }
  bravais::PictureRows rows(source, port, static_cast<bravais::Rank1Boundary>(this->BoundaryMode));
  if (!rows.Begin(why))
  {
    return false;
  }
  const int type = rows.GetType() == VTK_DOUBLE ? VTK_FLOAT : rows.GetType();
  if (type != VTK_UNSIGNED_CHAR && type != VTK_UNSIGNED_SHORT && type != VTK_FLOAT)
  {
    why = std::string("The input's scalars are of type ") +
      vtkImageScalarTypeNameMacro(rows.GetType()) +
      "; unsigned char, unsigned short, float or double was expected.";
    return false;
  }
  OIIO::ImageSpec spec(static_cast<int>(size[0]), static_cast<int>(size[1]),
    rows.GetNumberOfComponents(), bravais::FromVTKType(type));
  spec.channelnames = bravais::NameOIIOChannels(spec.nchannels);
  spec.tile_width = layout.TileSize[0];
  spec.tile_height = layout.TileSize[1];
  spec.tile_depth = 1;
  spec.attribute("ImageDescription", layout.Describe());
  spec.attribute("oiio:UnassociatedAlpha", 1); // opacity is not to change colours
  if (!this->Compression.empty())
  {
    spec.attribute("compression", this->Compression);
  }
  bravais::OIIOImageSink sink;
  if (!sink.Open(this->FileName, spec, why))
  {
    return false;
  }
  Writer writer(this, rows, *plans, layout, sink);
  const std::int64_t mostBytes = std::int64_t{ this->MemoryLimit } << 20;
  bool written = false;
  switch (rows.GetType())
  {
    case VTK_UNSIGNED_CHAR:
      written = writer.Execute<unsigned char, unsigned char>(mostBytes, why);
      break;
    case VTK_UNSIGNED_SHORT:
      written = writer.Execute<unsigned short, unsigned short>(mostBytes, why);
      break;
    case VTK_FLOAT:
      written = writer.Execute<float, float>(mostBytes, why);
      break;
    default:
      written = writer.Execute<double, float>(mostBytes, why);
  }
  return written && sink.Close(why);
}

//------------------------------------------------------------------------------
void vtkRank1TextureFileWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: '" << this->FileName << "'\n";
  os << indent << "Compression: '" << this->Compression << "'\n";
  os << indent << "NumberOfPoints: " << this->NumberOfPoints << "\n";
  os << indent << "Tiles: (" << this->Tiles[0] << ", " << this->Tiles[1] << ")\n";
  os << indent << "Generator: (" << this->Generator[0] << ", " << this->Generator[1] << ")\n";
  os << indent << "Layout: " << this->GetLayoutAsString() << "\n";
  os << indent << "BoundaryMode: " << this->GetBoundaryModeAsString() << "\n";
  os << indent << "MemoryLimit: " << this->MemoryLimit << "\n";
}
