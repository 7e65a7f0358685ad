// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "OIIOChannels.h"

#include <OpenImageIO/strutil.h>

#include "vtkType.h"

#include <algorithm>
#include <utility>

namespace bravais
{

namespace
{

constexpr std::pair<int, OIIO::TypeDesc::BASETYPE> Types[] = { { VTK_UNSIGNED_CHAR,
                                                                 OIIO::TypeDesc::UINT8 },
  { VTK_SIGNED_CHAR, OIIO::TypeDesc::INT8 }, { VTK_CHAR, OIIO::TypeDesc::INT8 },
  { VTK_UNSIGNED_SHORT, OIIO::TypeDesc::UINT16 }, { VTK_SHORT, OIIO::TypeDesc::INT16 },
  { VTK_UNSIGNED_INT, OIIO::TypeDesc::UINT32 }, { VTK_INT, OIIO::TypeDesc::INT32 },
  { VTK_UNSIGNED_LONG_LONG, OIIO::TypeDesc::UINT64 }, { VTK_LONG_LONG, OIIO::TypeDesc::INT64 },
  { VTK_UNSIGNED_LONG, sizeof(long) == 8 ? OIIO::TypeDesc::UINT64 : OIIO::TypeDesc::UINT32 },
  { VTK_LONG, sizeof(long) == 8 ? OIIO::TypeDesc::INT64 : OIIO::TypeDesc::INT32 },
  { VTK_ID_TYPE, sizeof(vtkIdType) == 8 ? OIIO::TypeDesc::INT64 : OIIO::TypeDesc::INT32 },
  { VTK_FLOAT, OIIO::TypeDesc::FLOAT }, { VTK_FLOAT, OIIO::TypeDesc::HALF },
  { VTK_DOUBLE, OIIO::TypeDesc::DOUBLE } };

/// The part after the last dot, and that before it.
std::string GetChannel(const std::string& name)
{
  return name.substr(name.rfind('.') + 1); // npos + 1 is 0
}

std::string GetLayer(const std::string& name)
{
  const std::size_t dot = name.rfind('.');
  return dot == std::string::npos ? std::string() : name.substr(0, dot);
}

/// "channel" and a number is OpenImageIO's name for a channel that has none.
bool IsNameless(const std::string& name)
{
  return name.empty() ||
    (OIIO::Strutil::starts_with(name, "channel") && OIIO::Strutil::string_is_int(name.substr(7)));
}

int Find(const std::vector<std::string>& names, const char* name)
{
  const auto found = std::find(names.begin(), names.end(), name);
  return found == names.end() ? -1 : static_cast<int>(found - names.begin());
}

/// Channels that are the scalars.
std::vector<int> FindScalars(const std::vector<std::string>& names)
{
  std::vector<int> all(names.size());
  std::vector<int> plain;
  for (int channel = 0; channel < static_cast<int>(names.size()); ++channel)
  {
    all[channel] = channel;
    if (GetLayer(names[channel]).empty())
    {
      plain.push_back(channel);
    }
  }
  if (std::any_of(names.begin(), names.end(), IsNameless))
  {
    return all;
  }
  const bool coloured = Find(names, "R") >= 0 && Find(names, "G") >= 0 && Find(names, "B") >= 0;
  if (!coloured && (Find(names, "Y") < 0 || Find(names, "X") >= 0))
  {
    return plain;
  }
  std::vector<int> scalars;
  const auto wanted = coloured ? std::vector<const char*>{ "R", "G", "B", "A" }
                               : std::vector<const char*>{ "Y", "A" };
  for (const char* name : wanted)
  {
    const int channel = Find(names, name);
    if (channel >= 0)
    {
      scalars.push_back(channel);
    }
  }
  return scalars;
}

/// The array with that name and type, made where there is none.
OIIOChannelArray& GetArray(std::vector<OIIOChannelArray>& arrays, const std::string& name, int type)
{
  const auto found = std::find_if(arrays.begin(), arrays.end(),
    [&](const OIIOChannelArray& array) { return array.Name == name; });
  return found == arrays.end() ? arrays.emplace_back(OIIOChannelArray{ name, type, {} }) : *found;
}

} // namespace

//------------------------------------------------------------------------------
int ToVTKType(OIIO::TypeDesc type)
{
  for (const auto& [own, base] : Types)
  {
    if (type == OIIO::TypeDesc(base))
    {
      return own;
    }
  }
  return VTK_VOID;
}

//------------------------------------------------------------------------------
OIIO::TypeDesc FromVTKType(int type)
{
  for (const auto& [own, base] : Types)
  {
    if (type == own)
    {
      return base;
    }
  }
  return OIIO::TypeDesc::UNKNOWN;
}

//------------------------------------------------------------------------------
std::vector<OIIOChannelArray> SortOIIOChannels(const OIIO::ImageSpec& spec)
{
  std::vector<std::string> names = spec.channelnames;
  names.resize(spec.nchannels);
  const auto type = [&](int channel) { return ToVTKType(spec.channelformat(channel)); };
  std::vector<OIIOChannelArray> arrays;
  const std::vector<int> scalars = FindScalars(names);
  for (const int channel : scalars)
  {
    GetArray(arrays, "Scalars", type(scalars[0])).Channels.push_back(channel);
  }
  for (int channel = 0; channel < spec.nchannels; ++channel)
  {
    if (std::find(scalars.begin(), scalars.end(), channel) == scalars.end())
    {
      const std::string layer = GetLayer(names[channel]);
      GetArray(arrays, layer.empty() ? names[channel] : layer, type(channel))
        .Channels.push_back(channel);
    }
  }

  // Components in the order that users expect, R before G whatever the file has.
  const auto rank = [&](int channel)
  {
    const std::string name = GetChannel(names[channel]);
    const std::size_t place = std::string("RGBXYZUVA").find(name);
    return name.size() == 1 && place != std::string::npos ? place : 9;
  };
  const std::size_t count = arrays.size();
  for (std::size_t index = 0; index < count; ++index)
  {
    std::vector<int>& channels = arrays[index].Channels;
    if (index > 0 || scalars.empty())
    {
      std::stable_sort(
        channels.begin(), channels.end(), [&](int a, int b) { return rank(a) < rank(b); });
    }
    // An array has one type; channels of another get their own.
    std::vector<int> kept;
    std::vector<OIIOChannelArray> others;
    for (const int channel : channels)
    {
      if (type(channel) == arrays[index].Type)
      {
        kept.push_back(channel);
      }
      else
      {
        others.push_back({ names[channel], type(channel), { channel } });
      }
    }
    channels = kept;
    arrays.insert(arrays.end(), others.begin(), others.end());
  }
  return arrays;
}

//------------------------------------------------------------------------------
std::vector<std::string> NameOIIOChannels(int components)
{
  static const std::vector<std::string> known[] = { {}, { "Y" }, { "Y", "A" }, { "R", "G", "B" },
    { "R", "G", "B", "A" } };
  if (components <= 4)
  {
    return known[components];
  }
  std::vector<std::string> names;
  for (int component = 0; component < components; ++component)
  {
    names.push_back("channel" + std::to_string(component));
  }
  return names;
}

} // namespace bravais
