// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef WholeJPEG_h
#define WholeJPEG_h

#include <string>

namespace bravais
{

/// Whether a JPEG file's segments go on to the marker of the image's end. The decoder itself fills
/// up what is missing with grey and takes that for a warning.
bool IsWholeJPEG(const std::string& name);

} // namespace bravais

#endif
