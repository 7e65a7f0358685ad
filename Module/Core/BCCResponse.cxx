// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause

#include "BCCResponse.h"

#include "BCCPrefilterTables.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace bravais
{
namespace
{

constexpr double Pi = 3.14159265358979323846;

struct OrbitTable
{
  template <std::size_t N>
  OrbitTable(const BCCOrbit (&orbits)[N])
    : Begin(orbits)
    , End(orbits + N)
  {
  }

  const BCCOrbit* begin() const { return this->Begin; }
  const BCCOrbit* end() const { return this->End; }

  const BCCOrbit* Begin;
  const BCCOrbit* End;
};

OrbitTable GetTable(BCCKernel kernel, BCCPrefilter prefilter)
{
  const bool samples = prefilter == BCCPrefilter::Interpolation;
  switch (kernel)
  {
    case BCCKernel::BCC4:
      return samples ? OrbitTable(BCC4Samples) : OrbitTable(BCC4Autocorrelation);
    case BCCKernel::BCC7:
      return samples ? OrbitTable(BCC7Samples) : OrbitTable(BCC7Autocorrelation);
    case BCCKernel::BCC8:
      return samples ? OrbitTable(BCC8Samples) : OrbitTable(BCC8Autocorrelation);
    case BCCKernel::BCC12:
      break;
  }
  return samples ? OrbitTable(BCC12Samples) : OrbitTable(BCC12Autocorrelation);
}

/// The product of sin(t) / t over some t in -pi .. pi, given the |sin(t)|.
template <std::size_t N>
double MultiplySincs(const double (&angles)[N], const double (&sines)[N])
{
  double numerator = 1.0;
  double denominator = 1.0;
  for (std::size_t n = 0; n < N; ++n)
  {
    const double square = angles[n] * angles[n];
    const bool small = square < 1e-4;
    numerator *= small ? 1.0 - square / 6.0 * (1.0 - square / 20.0) : sines[n];
    denominator *= small ? 1.0 : angles[n];
  }
  return std::abs(numerator / denominator);
}

} // namespace

BCCResponse::Frequency::Frequency(double w)
  : W(w)
  , HalfSine(std::sin(0.5 * w))
  , HalfCosine(std::cos(0.5 * w))
  , Sinc(MultiplySincs({ w }, { std::sin(w) }))
  , ShiftedSinc(MultiplySincs({ w - Pi }, { std::sin(w) }))
{
  for (int n = 0; n < Reach; ++n)
  {
    this->Cosines[n] = std::cos(n * w);
  }
}

BCCResponse::BCCResponse(
  BCCKernel kernel, BCCPrefilter prefilter, const std::array<std::int64_t, 3>& last)
  : Kernel(kernel)
  , Prefilter(prefilter)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    for (std::int64_t m = 0; m <= last[axis] / 2; ++m)
    {
      this->Axes[axis].emplace_back(Pi * static_cast<double>(m) / static_cast<double>(last[axis]));
    }
  }
  for (const BCCOrbit& orbit : GetTable(kernel, prefilter))
  {
    const double signs =
      (orbit.X == 0 ? 1.0 : 2.0) * (orbit.Y == 0 ? 1.0 : 2.0) * (orbit.Z == 0 ? 1.0 : 2.0);
    std::array<int, 3> point = { orbit.Z, orbit.Y, orbit.X };
    do
    {
      this->Terms.push_back({ point[0], point[1], point[2], signs * orbit.Value });
    } while (std::next_permutation(point.begin(), point.end()));
  }
}

void BCCResponse::GetColumn(std::int64_t mx, std::int64_t my, Value* column) const
{
  const Frequency& x = this->Axes[0][mx];
  const Frequency& y = this->Axes[1][my];
  std::array<double, Reach> byZ = {};
  for (const Term& term : this->Terms)
  {
    byZ[term.Z] += term.Weight * x.Cosines[term.X] * y.Cosines[term.Y];
  }
  for (const Frequency& z : this->Axes[2])
  {
    double even = 0.0;
    double odd = 0.0;
    for (int n = 0; n < Reach; n += 2)
    {
      even += byZ[n] * z.Cosines[n];
      odd += byZ[n + 1] * z.Cosines[n + 1];
    }
    double q = 1.0 / (even + odd);
    double shifted = 1.0 / (even - odd);
    if (this->Prefilter == BCCPrefilter::Projection)
    {
      const Diagonals diagonals(x, y, z);
      q = even + odd < SingularValue ? 0.0 : q * this->GetTransform(x, y, z, diagonals);
      shifted =
        even - odd < SingularValue ? 0.0 : shifted * this->GetShiftedTransform(x, y, z, diagonals);
    }
    *column++ = { 0.5 * (q + shifted), 0.5 * (q - shifted) };
  }
}

BCCResponse::Diagonals::Diagonals(const Frequency& x, const Frequency& y, const Frequency& z)
{
  for (const int n : { 0, 2 }) // (x + y) / 2 and (x - y) / 2
  {
    const double sign = 1.0 - n;
    const double sine = x.HalfSine * y.HalfCosine + sign * x.HalfCosine * y.HalfSine;
    const double cosine = x.HalfCosine * y.HalfCosine - sign * x.HalfSine * y.HalfSine;
    this->Sines[n] = sine * z.HalfCosine + cosine * z.HalfSine;
    this->Sines[n + 1] = sine * z.HalfCosine - cosine * z.HalfSine;
    this->Cosines[n] = cosine * z.HalfCosine - sine * z.HalfSine;
    this->Cosines[n + 1] = cosine * z.HalfCosine + sine * z.HalfSine;
  }
}

/// K^ from the products of the sincs along the four diagonals and along the three axes.
double BCCResponse::GetPower(double diagonals, double axes) const
{
  switch (this->Kernel)
  {
    case BCCKernel::BCC4:
      return diagonals;
    case BCCKernel::BCC7:
      return diagonals * axes;
    case BCCKernel::BCC8:
      return diagonals * diagonals;
    case BCCKernel::BCC12:
      break;
  }
  return axes * axes * axes * axes;
}

/// K^ at w, which is in the Voronoi cell, as all of [0, pi / 2]^3 is.
double BCCResponse::GetTransform(
  const Frequency& x, const Frequency& y, const Frequency& z, const Diagonals& diagonals) const
{
  const double sum = 0.5 * (x.W + y.W);
  const double difference = 0.5 * (x.W - y.W);
  const double half = 0.5 * z.W;
  return this->GetPower(
    MultiplySincs(
      { sum + half, sum - half, difference + half, difference - half }, diagonals.Sines),
    x.Sinc * y.Sinc * z.Sinc);
}

/// K^ at w', which is in the Voronoi cell once pi is taken from the largest coordinate of w. The
/// halved angles change by pi / 2, and sines become cosines.
double BCCResponse::GetShiftedTransform(
  const Frequency& x, const Frequency& y, const Frequency& z, const Diagonals& diagonals) const
{
  const double largest = std::max({ x.W, y.W, z.W });
  const bool alongX = x.W == largest;
  const bool alongY = !alongX && y.W == largest;
  const bool alongZ = !alongX && !alongY;
  const double wx = x.W - (alongX ? Pi : 0.0);
  const double wy = y.W - (alongY ? Pi : 0.0);
  const double half = 0.5 * (z.W - (alongZ ? Pi : 0.0));
  const double sum = 0.5 * (wx + wy);
  const double difference = 0.5 * (wx - wy);
  return this->GetPower(
    MultiplySincs(
      { sum + half, sum - half, difference + half, difference - half }, diagonals.Cosines),
    (alongX ? x.ShiftedSinc : x.Sinc) * (alongY ? y.ShiftedSinc : y.Sinc) *
      (alongZ ? z.ShiftedSinc : z.Sinc));
}

} // namespace bravais
