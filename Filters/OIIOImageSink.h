// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OIIOImageSink_h
#define OIIOImageSink_h

#include <OpenImageIO/imageio.h>

#include <string>

namespace bravais
{

/// An image file being written, under another name until it is complete. What is not complete is
/// removed.
class OIIOImageSink
{
public:
  OIIOImageSink() = default;
  OIIOImageSink(const OIIOImageSink&) = delete;
  void operator=(const OIIOImageSink&) = delete;
  ~OIIOImageSink();

  /// Starts a file of the format of its extension. False, with a sentence in `why`, where the
  /// format cannot store just what the header says: its type, channels, tiles and compression.
  bool Open(const std::string& name, const OIIO::ImageSpec& spec, std::string& why);

  OIIO::ImageOutput& GetOutput() { return *this->Output; }

  /// Gives the file its name.
  bool Close(std::string& why);

  /// What OpenImageIO says that went wrong.
  std::string Explain(const std::string& what);

private:
  bool CheckFormat(const OIIO::ImageSpec& spec, std::string& why) const;

  /// Writes a small picture and reads it, since some formats make another type of what they are
  /// given without a word, and OpenImageIO does not read all that it writes.
  bool TryPicture(OIIO::ImageSpec spec, std::string& why);
  bool CheckHeader(
    const OIIO::ImageSpec& spec, const OIIO::ImageSpec& actual, std::string& why) const;

  std::string Name;
  std::string PartName;
  OIIO::ImageOutput::unique_ptr Output;
};

} // namespace bravais

#endif
