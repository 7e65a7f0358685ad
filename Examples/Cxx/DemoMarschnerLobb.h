// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef DemoMarschnerLobb_h
#define DemoMarschnerLobb_h

/// \file
/// The demo's pictures of the Marschner-Lobb function on few samples, and their errors.

#include <string>

class Gallery;

/// How many pictures DrawMarschnerLobb() draws.
constexpr int MarschnerLobbPictures = 8;

/// The isosurface at 1/2 of 39 x 39 x 78 BCC samples by BCC12, BCC8 and BCC7, each with two
/// prefilters, and of 49 x 49 x 49 Cartesian samples by VTK's own mapper, with root mean square
/// errors inside the cube from -0.6 to 0.6; and, for the eye, of 8 times as many samples.
bool DrawMarschnerLobb(Gallery& gallery, std::string& why);

#endif
