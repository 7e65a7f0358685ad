// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CommandLine.h"

#include <cmath>
#include <map>

namespace
{

using Names = std::map<std::string, int>;

const Names Kernels = { { "bcc4", 4 }, { "bcc7", 7 }, { "bcc8", 8 }, { "bcc12", 12 } };

const Names Prefilters = { { "none", 0 }, { "quasi-interpolation", 1 }, { "interpolation", 2 },
  { "projection", 3 } };

std::string FindName(const Names& names, int value)
{
  for (const auto& [name, number] : names)
  {
    if (number == value)
    {
      return name;
    }
  }
  return "unknown";
}

/// An option that takes one of some names.
void AddChoice(CLI::App& app, const std::string& flags, int& value, const Names& names,
  const std::string& description)
{
  std::string list;
  for (const auto& [name, number] : names)
  {
    list += (list.empty() ? "" : ", ") + name;
  }
  app.add_option(flags, value, description + ": " + list)
    ->transform(CLI::Transformer(names, CLI::ignore_case).description(""))
    ->type_name("NAME")
    ->default_str(FindName(names, value))
    ->check(CLI::Validator(
      [names, list](std::string& text)
      {
        for (const auto& [name, number] : names)
        {
          if (text == std::to_string(number))
          {
            return std::string();
          }
        }
        return "'" + text + "' is none of " + list;
      },
      ""));
}

} // namespace

CLI::Validator IsFinite()
{
  return CLI::Validator(
    [](std::string& text)
    {
      double value = 0.0;
      const bool number = CLI::detail::lexical_cast(text, value);
      return number && std::isfinite(value) ? std::string() : text + " is not a finite number";
    },
    "");
}

void AddVolumeOptions(CLI::App& app, VolumeOptions& options)
{
  app.add_option("volume", options.Path, "File: .vti, .mhd, .nii, .nii.gz, .nrrd or legacy .vtk")
    ->required()
    ->type_name("");
  app.add_option("-r,--ratio", options.Ratio, "BCC samples per sample of the file")
    ->check(IsFinite())
    ->type_name("NUMBER")
    ->capture_default_str()
    ->group("Sampling");
  AddChoice(app, "-k,--kernel", options.Kernel, Kernels, "Box-spline");
  AddChoice(app, "-p,--prefilter", options.Prefilter, Prefilters, "Samples to coefficients");
  app.get_option("--kernel")->group("Sampling");
  app.get_option("--prefilter")->group("Sampling");
}

void AddViewOptions(CLI::App& app, View& view)
{
  const auto add = [&app](const std::string& name, auto& numbers, int count,
                     const std::string& type, const std::string& description)
  {
    app
      .add_option_function<std::vector<double>>(
        name,
        [&numbers](const std::vector<double>& values)
        { std::copy(values.begin(), values.end(), numbers); },
        description)
      ->expected(count)
      ->check(IsFinite())
      ->type_name(type)
      ->group("View");
  };
  add("--from", view.From, 3, "X Y Z", "Direction from the volume to the eye [0.55 -1 0.35]");
  add("--up", view.Up, 3, "X Y Z", "Direction that is up [0 0 1]");
  add(
    "--focus", view.Focus, 3, "X Y Z", "Middle of the picture, in fractions of the box [0.5 ...]");
  add("--crop", view.Crop, 6, "X0 X1 Y0 Y1 Z0 Z1", "Part to draw, in fractions of the box");
  app.add_option("--zoom", view.Zoom, "Magnification; at 1 all of the volume is seen")
    ->check(IsFinite() & CLI::PositiveNumber)
    ->type_name("NUMBER")
    ->capture_default_str()
    ->group("View");
}

std::string NameOfKernel(int kernel)
{
  return FindName(Kernels, kernel);
}

std::string NameOfPrefilter(int prefilter)
{
  return FindName(Prefilters, prefilter);
}
