// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef BCCResponse_h
#define BCCResponse_h

#include "BCCPrefilter.h"

#include <array>
#include <cstdint>
#include <vector>

namespace bravais
{

/// The frequency response Q(w) of the prefilters Interpolation and Projection, at the frequencies
/// of a mirrored volume.
///
/// With K the kernel, scaled to sum 1 over the lattice, and K^ its Fourier transform over det G,
/// so that K^(0) = 1,
///   Interpolation  Q = 1 / S,     S(w) = sum over lattice points j of K(j) exp(-i w.j),
///   Projection     Q = K^ / A,    A(w) = sum over the dual lattice of |K^(w + 2 pi k)|^2,
/// w being, in K^, that one of all w + 2 pi k in the Voronoi cell of the dual lattice (a rhombic
/// dodecahedron): the signal that the samples stand for is band-limited to it. By Poisson's
/// formula A is a finite sum as S is, with the autocorrelation of K in K's place.
///
/// Projection is singular where A vanishes: for BCC7 and BCC12 at the alternating component,
/// w = (pi, 0, 0), the vertices of the Voronoi cell where four faces meet. There Q is 0, as in a
/// pseudo-inverse: the component is left out, since no coefficients can make it. The same is done
/// where A < SingularValue, so that the gain never exceeds SingularValue^(-1/2) = 1e5. For BCC7
/// that is no other frequency, unless a volume is more than 10,000 samples long. For BCC12, whose
/// A falls with the eighth power of the distance d to the vertex, it is d < 0.05 pi. Little is
/// lost: of a component on an axis a spline can hold half the energy at the vertex, and two thirds
/// at d = 0.05 pi. A higher limit costs accuracy on smooth data; a lower one brings none, but
/// larger coefficients, which even so alternate between the cosets far beyond the spline's values.
///
/// Where the even coset has one frequency w the lattice has two, w and w' = w + (pi, 0, 0): with
/// spectra F0 and F1 of the samples on the two cosets, the whole spectrum is F0 + F1 at w and
/// F0 - F1 at w'. So a filter is two numbers at each w:
///   F0' = Same F0 + Other F1,  F1' = Same F1 + Other F0,
///   Same = (Q(w) + Q(w')) / 2, Other = (Q(w) - Q(w')) / 2.
class BCCResponse
{
public:
  static constexpr double SingularValue = 1e-10;

  struct Value
  {
    double Same;
    double Other;
  };

  /// For frequencies w = pi (m.x / last.x, m.y / last.y, m.z / last.z) with last the coordinates
  /// of the far mirrors, 0 <= m <= last / 2 on each axis.
  BCCResponse(BCCKernel kernel, BCCPrefilter prefilter, const std::array<std::int64_t, 3>& last);

  /// The filter at all frequencies along z, into last.z / 2 + 1 values.
  void GetColumn(std::int64_t mx, std::int64_t my, Value* column) const;

private:
  static constexpr int Reach = 8; // kernels and autocorrelations vanish at coordinates beyond 7

  struct Frequency
  {
    explicit Frequency(double w);

    double W;
    double HalfSine, HalfCosine;       // of W / 2
    double Sinc, ShiftedSinc;          // sin(t) / t of W and W - pi
    std::array<double, Reach> Cosines; // of 0, W, 2 W, ..
  };

  /// A set of lattice points (+-X, +-Y, +-Z) with the sum of their values.
  struct Term
  {
    int X, Y, Z;
    double Weight;
  };

  /// Of w.d / 2 for the four directions d of S1.
  struct Diagonals
  {
    Diagonals(const Frequency& x, const Frequency& y, const Frequency& z);

    double Sines[4];
    double Cosines[4];
  };

  double GetTransform(
    const Frequency& x, const Frequency& y, const Frequency& z, const Diagonals& diagonals) const;
  double GetShiftedTransform(
    const Frequency& x, const Frequency& y, const Frequency& z, const Diagonals& diagonals) const;
  double GetPower(double diagonals, double axes) const;

  BCCKernel Kernel;
  BCCPrefilter Prefilter;
  std::array<std::vector<Frequency>, 3> Axes;
  std::vector<Term> Terms;
};

} // namespace bravais

#endif
