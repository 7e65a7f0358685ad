#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
"""Values of the BCC kernels and of their autocorrelations at lattice points, exactly.

    GeneratePrefilterTables.py            writes BCCPrefilterTables.h beside this file
    GeneratePrefilterTables.py --check    fails where that is not what it would write

A kernel is det G = 4 times a centred box-spline M. The autocorrelation of a box-spline that is
even is the box-spline with each direction taken twice, so one evaluation serves both tables. It
follows the recurrence of de Boor, Hoellig and Riemenschneider, Box Splines, I (42): with x the sum
of t_d d over the directions d,

    (m - n) M(x) = sum over d of t_d M_d(x) + (1 - t_d) M_d(x - d),    M_d: M without d,

down to n directions, whose M is 1 / |det| on their half-open parallelepiped and 0 elsewhere. A
lattice point lies on knot planes, where the lower splines jump. So the recursion is run for
x + e v with v in no knot plane and e > 0 infinitesimal: e counts where it decides whether a point
is inside a parallelepiped, and vanishes in the weights t. There a set of directions that does not
span the space contributes 0. All splines asked for are continuous, hence the limit is the value.

All is integer arithmetic: the recursion is carried on (m - n)! M, times 8 a level.
"""

import io
import itertools
import math
import pathlib
import sys
from fractions import Fraction
from functools import lru_cache

S1 = ((1, 1, 1), (-1, 1, 1), (1, -1, 1), (1, 1, -1))
S2 = ((2, 0, 0), (0, 2, 0), (0, 0, 2))
KERNELS = {"BCC4": S1, "BCC7": S1 + S2, "BCC8": S1 * 2, "BCC12": S2 * 4}
SHIFT = (1, 3, 10)  # v, in no plane that two of the directions span: checked below
WEIGHT = 8  # a multiple of all determinants, so that WEIGHT t is an integer


def det(a, b, c):
    return (a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0])
            + a[2] * (b[0] * c[1] - b[1] * c[0]))


def coordinates(basis, x):
    """det and the numerators of x in the basis, by Cramer's rule."""
    a, b, c = basis
    return det(a, b, c), (det(x, b, c), det(a, x, c), det(a, b, x))


for pair in itertools.combinations(S1 + S2, 2):
    assert det(*pair, SHIFT) != 0


@lru_cache(maxsize=None)
def basis_of(directions):
    """The indices of three directions that span the space, or None."""
    distinct = [i for i, (_, count) in enumerate(directions) if count]
    for triple in itertools.combinations(distinct, 3):
        if det(*(directions[i][0] for i in triple)):
            return triple
    return None


@lru_cache(maxsize=None)
def without(directions, index):
    d, count = directions[index]
    return directions[:index] + ((d, count - 1),) + directions[index + 1:]


@lru_cache(maxsize=None)
def recursion(directions, x):
    """WEIGHT^(m - n + 1) (m - n)! times the uncentred box-spline at x + e v."""
    triple = basis_of(directions)
    if triple is None:
        return 0
    basis = [directions[i][0] for i in triple]
    volume, numerators = coordinates(basis, x)
    if sum(count for _, count in directions) == 3:
        _, steps = coordinates(basis, SHIFT)
        for t, step in zip(numerators, steps):
            t, step = (t, step) if volume > 0 else (-t, -step)
            inside = 0 < t < abs(volume) or (t == 0 and step > 0) or (t == abs(volume) and step < 0)
            if not inside:
                return 0
        return WEIGHT // abs(volume)
    result = 0
    for index, (d, count) in enumerate(directions):
        if not count:
            continue
        # One of the count equal directions carries t, the others 0.
        t = WEIGHT * numerators[triple.index(index)] // volume if index in triple else 0
        lower = without(directions, index)
        here = recursion(lower, x) if t else 0
        there = recursion(lower, tuple(p - q for p, q in zip(x, d)))
        result += t * here + (count * WEIGHT - t) * there
    return result


def value(directions, x):
    """4 M(x), M centred at 0."""
    m = len(directions)
    center = [sum(d[a] for d in directions) // 2 for a in range(3)]
    counted = tuple((d, directions.count(d)) for d in dict.fromkeys(directions))
    scaled = recursion(counted, tuple(p + c for p, c in zip(x, center)))
    return Fraction(4 * scaled, WEIGHT ** (m - 2) * math.factorial(m - 3))


@lru_cache(maxsize=None)
def b_spline(order, x):
    """The centred cardinal B-spline of that order, at a rational x."""
    terms = ((-1) ** i * math.comb(order, i) * max(x + Fraction(order, 2) - i, 0) ** (order - 1)
             for i in range(order + 1))
    return sum(terms, Fraction(0)) / math.factorial(order - 1)


def separable(order, x):
    """4 M(x) for S2 taken `order` times."""
    return 4 * math.prod((b_spline(order, Fraction(p, 2)) / 2 for p in x), start=Fraction(1))


def orbit(point):
    """The images of a point under permutations and signs of its coordinates."""
    return {tuple(s * p for s, p in zip(signs, permuted))
            for permuted in itertools.permutations(point)
            for signs in itertools.product((1, -1), repeat=3)}


def table(directions):
    """(x >= y >= z >= 0, value) of each orbit of lattice points where the value is not 0."""
    reach = max(sum(abs(d[a]) for d in directions) for a in range(3)) // 2
    rows = []
    for x, y, z in itertools.product(range(reach + 1), repeat=3):
        if x >= y >= z and x % 2 == y % 2 == z % 2:
            if set(directions) == set(S2):
                v = separable(len(directions) // 3, (x, y, z))
            else:
                v = value(directions, (x, y, z))
            if v:
                rows.append(((x, y, z), v))
    check(directions, rows)
    return sorted(rows, key=lambda row: (row[0][0] ** 2 + row[0][1] ** 2 + row[0][2] ** 2, row[0]))


def moment(rows, powers):
    return sum(v * math.prod(p ** e for p, e in zip(point, powers))
               for representative, v in rows for point in orbit(representative))


def check(directions, rows):
    """What the Strang-Fix conditions tell of any values at lattice points: up to the degree below
    the approximation order they have the moments of the kernel itself, so for order >= 6 those of
    the sum of independent uniform variables along the directions."""
    distinct = set(directions)
    # The least number of directions whose removal leaves a plane.
    order = min(sum(1 for d in directions if det(*pair, d)) for pair in
                itertools.combinations(distinct, 2))
    variance = [[sum(Fraction(d[a] * d[b], 12) for d in directions) for b in range(3)]
                for a in range(3)]
    assert order >= 2 and moment(rows, (0, 0, 0)) == 1
    assert all(v > 0 for _, v in rows)
    if order >= 4:
        assert moment(rows, (2, 0, 0)) == variance[0][0] and variance[0][1] == 0
    if order >= 6:
        fourth = sum(Fraction(d[0] ** 4, 120) for d in directions)  # minus the fourth cumulant
        assert moment(rows, (4, 0, 0)) == 3 * variance[0][0] ** 2 - fourth
        mixed = sum(Fraction(d[0] ** 2 * d[1] ** 2, 120) for d in directions)
        assert moment(rows, (2, 2, 0)) == variance[0][0] ** 2 - mixed
    if set(S2) <= distinct:
        # The shifts of each coset sum to 1/2: the alternating component is lost.
        odd = sum(len(orbit(point)) * v for point, v in rows if point[0] % 2)
        assert odd == Fraction(1, 2)


def write(name, brief, rows, out):
    out.write(f"\n/// {brief}\ninline constexpr BCCOrbit {name}[] = {{\n")
    for (x, y, z), v in rows:
        out.write(f"  {{ {x}, {y}, {z}, {float(v)!r} }}, // {v}\n")
    out.write("};\n")


def generate():
    out = io.StringIO()
    out.write("""// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause

// Written by GeneratePrefilterTables.py: edit that.

#ifndef BCCPrefilterTables_h
#define BCCPrefilterTables_h

// clang-format off
namespace bravais
{

/// The value at (X, Y, Z), X >= Y >= Z >= 0, and at all its images under permutations and signs.
struct BCCOrbit
{
  int X, Y, Z;
  double Value;
};
""")
    for name, directions in KERNELS.items():
        write(f"{name}Samples", f"{name} at the lattice points, sum 1.", table(directions), out)
        write(f"{name}Autocorrelation",
              f"{name}'s autocorrelation at the lattice points, scaled to sum 1.",
              table(directions * 2), out)
    out.write("""
} // namespace bravais
// clang-format on

#endif
""")
    return out.getvalue()


def main():
    path = pathlib.Path(__file__).with_name("BCCPrefilterTables.h")
    text = generate()
    if sys.argv[1:] == ["--check"]:
        if path.exists() and path.read_text() == text:
            return 0
        print(f"{path.name} is not what GeneratePrefilterTables.py writes")
        return 1
    path.write_text(text)
    return 0


if __name__ == "__main__":
    sys.exit(main())
