// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DemoVolume.h"

#include "ErrorLog.h"
#include "Gallery.h"
#include "Resample.h"

#include "vtkImageData.h"

namespace
{

std::string DescribeDimensions(vtkImageData* volume)
{
  const int* n = volume->GetDimensions();
  return std::to_string(n[0]) + " x " + std::to_string(n[1]) + " x " + std::to_string(n[2]);
}

} // namespace

bool DrawVolume(Gallery& gallery, vtkImageData* image, const DemoOptions& options, std::string& why)
{
  gallery.Say("Resampling " + DescribeDimensions(image) + " samples to the BCC lattice");
  const vtkSmartPointer<vtkImageData> bcc = ResampleToBCC(image, options.Volume.Ratio);
  if (!bcc)
  {
    why = ErrorLog::TakeFirstError();
    return false;
  }
  gallery.Say("Resampling to a Cartesian grid with as many samples");
  const vtkSmartPointer<vtkImageData> cartesian =
    ResampleToCartesian(image, bcc->GetNumberOfPoints());
  gallery.Say("BCC: " + DescribeDimensions(bcc) + ", Cartesian: " + DescribeDimensions(cartesian));

  const std::vector<Surface> both = MakeSurfaces({ options.Outer, options.Inner });
  const Surface skin = { both[0].Value, both[0].Color, 1.0 };
  const std::vector<Surface> bone = { both[1] };
  const std::string kernel = NameOfKernel(options.Volume.Kernel);
  Drawing drawing;
  drawing.Kernel = options.Volume.Kernel;
  drawing.Prefilter = options.Volume.Prefilter;
  drawing.Look = options.Look;
  const auto draw = [&](const std::string& name, vtkImageData* volume, Mode mode,
                      const std::vector<Surface>& surfaces)
  {
    drawing.Name = name;
    drawing.Volume = volume;
    drawing.How = mode;
    drawing.Surfaces = surfaces;
    return gallery.Draw(drawing, why);
  };
  if (!draw("outer-" + kernel, bcc, Mode::IsoSurface, { skin }) ||
    !draw("composite-" + kernel, bcc, Mode::Composite, both))
  {
    return false;
  }
  const auto whole = draw("inner-" + kernel, bcc, Mode::IsoSurface, bone);
  const auto wholeLinear =
    whole ? draw("inner-trilinear", cartesian, Mode::IsoSurface, bone) : nullptr;
  drawing.Look = options.Detail;
  const auto detail = wholeLinear ? draw("detail-" + kernel, bcc, Mode::IsoSurface, bone) : nullptr;
  const auto detailLinear =
    detail ? draw("detail-trilinear", cartesian, Mode::IsoSurface, bone) : nullptr;
  return detailLinear &&
    gallery.WriteMontage("inner-side-by-side", { whole, wholeLinear }, 2, 1, why) &&
    gallery.WriteMontage("detail-side-by-side", { detail, detailLinear }, 2, 1, why);
}
