// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PictureTable.h"

#include <algorithm>
#include <array>
#include <iomanip>
#include <ostream>
#include <sstream>

namespace
{

constexpr int Columns = 6;
using Cells = std::array<std::string, Columns>;

std::string Format(double value, int digits)
{
  std::ostringstream text;
  text << std::fixed << std::setprecision(digits) << value;
  return text.str();
}

Cells MakeCells(const PictureRow& row)
{
  return { row.Picture, row.Kernel, row.Prefilter, std::to_string(row.Samples),
    Format(row.Seconds, 2), row.Error ? Format(*row.Error, 5) : std::string() };
}

} // namespace

void PictureTable::Print(std::ostream& stream) const
{
  std::vector<Cells> lines = { { "picture", "kernel", "prefilter", "samples", "frame (s)",
    "RMS error" } };
  for (const PictureRow& row : this->Rows)
  {
    lines.push_back(MakeCells(row));
  }
  std::array<std::size_t, Columns> widths{};
  for (const Cells& cells : lines)
  {
    for (int c = 0; c < Columns; ++c)
    {
      widths[c] = std::max(widths[c], cells[c].size());
    }
  }
  for (std::size_t line = 0; line < lines.size(); ++line)
  {
    for (int c = 0; c < Columns; ++c)
    {
      stream << (c > 0 ? "  " : "") << (c < 3 ? std::left : std::right)
             << std::setw(static_cast<int>(widths[c])) << lines[line][c];
    }
    stream << '\n';
    if (line == 0)
    {
      for (int c = 0; c < Columns; ++c)
      {
        stream << (c > 0 ? "  " : "") << std::string(widths[c], '-');
      }
      stream << '\n';
    }
  }
  stream << std::flush;
}
