// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef CommandLine_h
#define CommandLine_h

/// \file
/// The options that the programs have in common.

#include "Scene.h"

#include <CLI/CLI.hpp>

#include <string>

/// What is read from the command line about the volume and its reconstruction.
struct VolumeOptions
{
  std::string Path;
  double Ratio = 1.0;
  int Kernel = 7;
  int Prefilter = 1;
};

void AddVolumeOptions(CLI::App& app, VolumeOptions& options);
void AddViewOptions(CLI::App& app, View& view);

/// Accepts finite numbers only.
CLI::Validator IsFinite();

/// bcc7 for 7, and so on.
std::string NameOfKernel(int kernel);
std::string NameOfPrefilter(int prefilter);

#endif
