// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "BCCLowPass.h"

#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <cmath>

namespace bravais
{
namespace
{

constexpr std::int64_t Together = 8; // lines in LineNumbers

/// Calls work(numbers, l) for the lines l .. l + 7 of `count` samples, as many as there are, with
/// room for `size` numbers. Lines and their samples are so far apart.
template <class T, class F>
void ForEachEight(T* samples, std::int64_t lines, std::int64_t lineStride, std::int64_t count,
  std::int64_t stride, std::int64_t size, const F& work)
{
  std::vector<LineNumbers> numbers(size);
  for (std::int64_t begin = 0; begin < lines; begin += Together)
  {
    const std::int64_t used = std::min(Together, lines - begin);
    for (std::int64_t n = 0; n < count; ++n)
    {
      const T* first = samples + begin * lineStride + n * stride;
      for (std::int64_t l = 0; l < used; ++l)
      {
        numbers[n].Values[l] = first[l * lineStride];
      }
    }
    work(numbers.data(), begin);
    for (std::int64_t n = 0; n < count; ++n)
    {
      T* first = samples + begin * lineStride + n * stride;
      for (std::int64_t l = 0; l < used; ++l)
      {
        first[l * lineStride] = static_cast<T>(numbers[n].Values[l]);
      }
    }
  }
}

/// 1 up to 0.4, 0 from 1/2 on.
double GetPairResponse(double sum)
{
  const double t = std::clamp(10.0 * (sum - 0.4), 0.0, 1.0);
  return t < 1.0 ? 0.5 + 0.5 * std::cos(glm::pi<double>() * t) : 0.0;
}

} // namespace

BCCLowPass::BCCLowPass(const glm::ivec3& dimensions, const glm::dvec3& step)
  : Dimensions(dimensions)
  , Step(step)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    // Coset 0 of such a line are as many samples as there are, in a period of 2 (count - 1).
    this->Transforms.emplace_back(2 * (std::int64_t{ dimensions[axis] } - 1));
  }
}

double BCCLowPass::GetResponse(const glm::dvec3& frequency)
{
  const double x = std::abs(frequency.x);
  const double y = std::abs(frequency.y);
  const double z = std::abs(frequency.z);
  return GetPairResponse(x + y) * GetPairResponse(x + z) * GetPairResponse(y + z);
}

template <class T>
void BCCLowPass::Apply(int pass, int part, T* samples) const
{
  if (pass == 1)
  {
    this->FilterSlab(part, samples);
  }
  else
  {
    const std::int64_t size = std::int64_t{ this->Dimensions.x } * this->Dimensions.y;
    this->TransformLayer(pass == 0, samples + part * size);
  }
}

template <class T>
void BCCLowPass::TransformLayer(bool forward, T* layer) const
{
  const std::int64_t nx = this->Dimensions.x;
  const std::int64_t ny = this->Dimensions.y;
  const auto transform = [&](int axis)
  {
    const MirrorTransform& along = this->Transforms[axis];
    const auto work = [&](LineNumbers* lines, std::int64_t)
    { forward ? along.Forward(0, lines) : along.Inverse(0, lines); };
    const std::int64_t size = along.GetBufferSize();
    axis == 0 ? ForEachEight(layer, ny, nx, nx, 1, size, work)
              : ForEachEight(layer, nx, 1, ny, nx, size, work);
  };
  transform(forward ? 0 : 1);
  transform(forward ? 1 : 0);
}

template <class T>
void BCCLowPass::FilterSlab(int j, T* samples) const
{
  const std::int64_t nx = this->Dimensions.x;
  const std::int64_t nz = this->Dimensions.z;
  const MirrorTransform& along = this->Transforms[2];
  double scale = 1.0;
  for (const MirrorTransform& transform : this->Transforms)
  {
    scale /= static_cast<double>(transform.GetScale());
  }
  const glm::dvec3 unit = 1.0 / (this->Step * glm::dvec3(2 * (this->Dimensions - 1)));
  const auto work = [&](LineNumbers* lines, std::int64_t i)
  {
    along.Forward(0, lines);
    for (std::int64_t k = 0; k < nz; ++k)
    {
      for (std::int64_t l = 0; l < Together; ++l)
      {
        lines[k].Values[l] *= scale * GetResponse(unit * glm::dvec3(i + l, j, k));
      }
    }
    along.Inverse(0, lines);
  };
  ForEachEight(samples + j * nx, nx, 1, nz, nx * this->Dimensions.y, along.GetBufferSize(), work);
}

template void BCCLowPass::Apply(int, int, float*) const;
template void BCCLowPass::Apply(int, int, double*) const;

} // namespace bravais
