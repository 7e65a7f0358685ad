// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Gallery_h
#define Gallery_h

/// \file
/// Pictures drawn one after another into a folder, with progress on the way and a table of them.

#include "PictureTable.h"
#include "Scene.h"

#include <string>
#include <vector>

class vtkImageData;

/// One volume as it is to be drawn. Kernel and prefilter matter to BCC volumes only.
struct Drawing
{
  std::string Name; ///< the file's, without .png
  vtkImageData* Volume = nullptr;
  Mode How = Mode::IsoSurface;
  std::vector<Surface> Surfaces;
  View Look;
  int Kernel = 7;
  int Prefilter = 1;
  std::optional<double> Error;
  std::string Label; ///< by default kernel and prefilter
};

class Gallery
{
public:
  /// Pictures of size x size in a folder, which is made; `total` of them are announced.
  Gallery(const std::string& folder, int size, int total);

  /// Says what is going on.
  void Say(const std::string& text);

  /// Draws, writes and enters a picture into the table. It is labelled.
  /// Null after an error, with a sentence.
  vtkSmartPointer<vtkImageData> Draw(const Drawing& drawing, std::string& why);

  /// Writes pictures side by side, in rows of some number, each shrunk by a whole factor.
  bool WriteMontage(const std::string& name,
    const std::vector<vtkSmartPointer<vtkImageData>>& pictures, int columns, int shrink,
    std::string& why);

  const PictureTable& GetTable() const { return this->Table; }

private:
  bool Write(vtkImageData* picture, const std::string& name, std::string& why);

  std::string Folder;
  int Total;
  int Count = 0;
  Scene Stage;
  PictureTable Table;
};

#endif
