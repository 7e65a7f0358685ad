#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
"""Writes the polynomials of the box-splines bcc4, bcc7 and bcc8, for C++ and for GLSL.

    GenerateBoxSplines.py            writes the files below
    GenerateBoxSplines.py --check    fails, and names the file, where one differs

On the reference tetrahedron 1 >= x >= y >= z >= 0 (Kim and Lee, Real-time BCC Volume Isosurface
Ray Casting on the GPU, eq. 17) each spline is one polynomial, whose coefficients are integer
combinations of the coefficients c of the lattice points in the stencil. All arithmetic here is
rational:

1. The box-spline is evaluated by its recurrence (de Boor, Hoellig, Riemenschneider, Box Splines,
   I (42)) at as many points inside the tetrahedron as the polynomial has coefficients, for every
   lattice point, and scaled by 4 = det G so that the shifts sum to 1.
2. Interpolation at these points gives each lattice point's polynomial.
3. The sums that many monomials share are factored out, the most frequent pair of terms first.
"""

import itertools
import pathlib
import re
import sys
from fractions import Fraction

ROOT = pathlib.Path(__file__).resolve().parents[2]

SHELL_1 = [(-1, 1, 1), (1, -1, 1), (1, 1, -1), (-1, -1, -1)]
SHELL_2 = [(2, 0, 0), (0, 2, 0), (0, 0, 2)]
# kernel: directions, their multiplicities, polynomial degree
BOX_SPLINES = {
    4: (SHELL_1, (1,) * 4, 1),
    7: (SHELL_1 + SHELL_2, (1,) * 7, 4),
    8: (SHELL_1, (2,) * 4, 5),
}


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def determinant(a, b, c):
    return sum(u * v for u, v in zip(a, cross(b, c)))


class Recurrence:
    """Values of a box-spline, times an integer that clears all denominators.

    Points are integers, in units of 1 / unit. Every determinant of three of the directions divides
    8, so t = 8 unit t' is an integer for the coordinates t' of a point in such a basis, and each
    step (m - 3) M(x) = sum t' M_without(x) + (k - t') M_without(x - direction) multiplies the
    scale by 8 unit.
    """

    def __init__(self, directions, unit):
        self.directions = directions
        self.unit = unit
        self.values = {}
        self.frames = {}

    def frame(self, multiplicities):
        """The box of the support, and the linear forms 8 t' that the first basis has."""
        if multiplicities not in self.frames:
            steps = [[k * d[q] * self.unit for k, d in zip(multiplicities, self.directions)] for q in range(3)]
            box = [(sum(min(v, 0) for v in s), sum(max(v, 0) for v in s)) for s in steps]
            used = [i for i, k in enumerate(multiplicities) if k]
            found = None
            for triple in itertools.combinations(used, 3):
                a, b, c = (self.directions[i] for i in triple)
                volume = determinant(a, b, c)
                if volume:
                    forms = [[v * 8 // volume for v in cross(*pair)] for pair in ((b, c), (c, a), (a, b))]
                    found = (box, used, 8 // abs(volume), dict(zip(triple, forms)))
                    break
            self.frames[multiplicities] = found
        return self.frames[multiplicities]

    def value(self, multiplicities, x):
        key = (multiplicities, x)
        if key not in self.values:
            self.values[key] = self.compute(multiplicities, x)
        return self.values[key]

    def compute(self, multiplicities, x):
        frame = self.frame(multiplicities)
        if frame is None:
            return 0
        box, used, density, forms = frame
        if not all(low < v < high for v, (low, high) in zip(x, box)):
            return 0
        t = {i: f[0] * x[0] + f[1] * x[1] + f[2] * x[2] for i, f in forms.items()}
        one = 8 * self.unit
        if sum(multiplicities) == 3:
            return density if all(0 <= v < one for v in t.values()) else 0
        total = 0
        for i in used:
            k = multiplicities[i]
            rest = multiplicities[:i] + (k - 1,) + multiplicities[i + 1 :]
            near = t.get(i, 0)
            far = k * one - near
            if near:
                total += near * self.value(rest, x)
            if far:
                shift = self.directions[i]
                total += far * self.value(rest, tuple(x[q] - self.unit * shift[q] for q in range(3)))
        return total

    def scale(self, multiplicities):
        steps = sum(multiplicities) - 3
        scale = 8
        for step in range(1, steps + 1):
            scale *= step * 8 * self.unit
        return scale


def lattice_points(reach):
    span = range(-reach, reach + 1)
    return [p for p in itertools.product(span, repeat=3) if p[0] % 2 == p[1] % 2 == p[2] % 2]


def monomials(degree):
    return [m for m in itertools.product(range(degree + 1), repeat=3) if sum(m) <= degree]


def power(point, monomial):
    return point[0] ** monomial[0] * point[1] ** monomial[1] * point[2] ** monomial[2]


def inverse(matrix):
    size = len(matrix)
    rows = [[Fraction(v) for v in row] + [Fraction(i == j) for j in range(size)] for i, row in enumerate(matrix)]
    for i in range(size):
        pivot = next(r for r in range(i, size) if rows[r][i])
        rows[i], rows[pivot] = rows[pivot], rows[i]
        rows[i] = [v / rows[i][i] for v in rows[i]]
        for r in range(size):
            f = rows[r][i]
            if r != i and f:
                rows[r] = [a - f * b if b else a for a, b in zip(rows[r], rows[i])]
    return [row[size:] for row in rows]


def stencil_polynomials(kernel):
    """{lattice point: {monomial: coefficient}} on the reference tetrahedron."""
    directions, multiplicities, degree = BOX_SPLINES[kernel]
    # Points with barycentric coordinates (e + 1) / (degree + 4) lie inside, off every knot plane.
    size = degree + 4
    unit = 2 * size
    points = []
    for e in itertools.product(range(1, degree + 2), repeat=3):
        if sum(e) <= degree + 3:
            points.append((e[0] + e[1] + e[2], e[1] + e[2], e[2]))
    spline = Recurrence(directions, unit)
    # The recurrence's box-spline starts at 0; half the sum of the directions is its centre.
    centre = [size * sum(k * d[q] for k, d in zip(multiplicities, directions)) for q in range(3)]
    powers = monomials(degree)
    solve = inverse([[power([Fraction(v, size) for v in p], m) for m in powers] for p in points])
    scale = Fraction(4, spline.scale(multiplicities))
    result = {}
    for j in lattice_points(4):
        values = [
            spline.value(multiplicities, tuple(2 * p[q] - unit * j[q] + centre[q] for q in range(3)))
            for p in points
        ]
        if any(values):
            terms = ((m, sum(a * b for a, b in zip(row, values)) * scale) for m, row in zip(powers, solve))
            result[j] = {m: c for m, c in terms if c}
    return result


def fetch_order(points):
    """Even points from (0, 0, 0), then odd points from (1, 1, 1), each next to the one before
    where that can be."""
    order = []
    for start in ((0, 0, 0), (1, 1, 1)):
        left = sorted(p for p in points if p[0] % 2 == start[0])
        here = start
        while left:
            here = min(left, key=lambda p: (sum(abs(a - b) for a, b in zip(p, here)), crowding(p, left), p))
            left.remove(here)
            order.append(here)
    return order


def crowding(point, others):
    """Number of neighbours along the axes: corners are visited first, not left behind."""
    return sum(sum(abs(a - b) for a, b in zip(point, q)) == 2 for q in others)


class Sums:
    """Rows of integer combinations, with the pairs that several rows share factored out."""

    def __init__(self, rows):
        self.rows = {k: dict(r) for k, r in rows.items()}
        self.pairs = []
        self.factor()

    def factor(self):
        while True:
            count = {}
            for row in self.rows.values():
                for (a, ca), (b, cb) in itertools.combinations(sorted(row.items()), 2):
                    key = (a, b, cb / ca)
                    count[key] = count.get(key, 0) + 1
            best = max(count, key=lambda k: (count[k], abs(k[2]) == 1, k), default=None)
            if best is None or count[best] < 2:
                return
            a, b, ratio = best
            name = ("t", len(self.pairs))
            self.pairs.append((name, a, b, ratio))
            for row in self.rows.values():
                if a in row and b in row and row[b] / row[a] == ratio:
                    row[name] = row.pop(a)
                    del row[b]


def name_of(variable):
    return f"c[{variable[1]}]" if variable[0] == "c" else f"t{variable[1]}"


def combination(terms):
    """Source text of a sum of integer multiples of variables, those of one size in brackets."""
    groups = {}
    for variable, factor in terms:
        assert factor.denominator == 1
        groups.setdefault(abs(factor), []).append((variable, factor > 0))
    text = ""
    # A group that leads with a plus comes first, where there is one.
    for size, members in sorted(groups.items(), key=lambda g: (not any(p for _, p in g[1]), g[0])):
        members = sorted(members, key=lambda m: not m[1])
        positive = members[0][1]
        inner = members[0][0]
        for variable, plus in members[1:]:
            inner += (" + " if plus == positive else " - ") + variable
        if size != 1:
            inner = f"T({size}.0) * " + (f"({inner})" if len(members) > 1 else inner)
        elif not positive and len(members) > 1:
            inner = f"({inner})"
        if text:
            text += (" + " if positive else " - ") + inner
        else:
            text = inner if positive else f"T(-1.0) * {inner}" if size == 1 else inner.replace("T(", "T(-", 1)
    return text


def horner(terms, axis=0):
    """Source text of a polynomial {monomial: text of its coefficient}, nested x, y, z."""
    if axis == 3:
        return terms[()]
    powers = {}
    for m, text in terms.items():
        powers.setdefault(m[0], {})[m[1:]] = text
    variable = "xyz"[axis]
    text = ""
    for p in range(max(powers), -1, -1):
        inner = horner(powers[p], axis + 1) if p in powers else ""
        if text:
            text = f"({text}) * {variable}" if " " in text else f"{text} * {variable}"
            text += f" + {inner}" if inner else ""
        else:
            text = inner
    return text


def derivative(terms, axis):
    result = {}
    for m, text in terms.items():
        if m[axis]:
            lower = m[:axis] + (m[axis] - 1,) + m[axis + 1 :]
            result[lower] = text if m[axis] == 1 else f"T({m[axis]}.0) * {text}"
    return result


class Kernel:
    """One box-spline's stencil and the statements that evaluate it."""

    def __init__(self, kernel):
        self.kernel = kernel
        polynomials = stencil_polynomials(kernel)
        self.stencil = fetch_order(list(polynomials))
        self.even = sum(p[0] % 2 == 0 for p in self.stencil)
        denominators = [c.denominator for p in polynomials.values() for c in p.values()]
        self.scale = 1
        for d in denominators:
            self.scale = self.scale * d // gcd(self.scale, d)
        self.monomials = [
            (i, *m, int(c * self.scale)) for i, j in enumerate(self.stencil) for m, c in sorted(polynomials[j].items())
        ]
        rows = {}
        for i, j in enumerate(self.stencil):
            for m, c in polynomials[j].items():
                rows.setdefault(m, {})[("c", i)] = c * self.scale
        self.sums = Sums(rows)

    def polynomial(self):
        """Statements: the shared sums, the monomials' coefficients, gradient and value."""
        lines = []
        for name, a, b, ratio in self.sums.pairs:
            # The pair stands for a + ratio b; ratios below one are scaled up where they are used.
            text = combination([(name_of(a), Fraction(1)), (name_of(b), ratio)]) if ratio.denominator == 1 else None
            if text is None:
                text = f"{name_of(a)} {'-' if ratio < 0 else '+'} T({float(abs(ratio))!r}) * {name_of(b)}"
            lines.append(f"T {name_of(name)} = {text};")
        terms = {}
        for m in sorted(self.sums.rows):
            row = self.sums.rows[m]
            name = f"m{m[0]}{m[1]}{m[2]}"
            lines.append(f"T {name} = {combination([(name_of(v), f) for v, f in sorted(row.items())])};")
            terms[m] = name
        for axis, g in enumerate(("gx", "gy", "gz")):
            lines.append(f"{g} = {self.scaled(horner(derivative(terms, axis)))};")
        lines.append(f"return {self.scaled(horner(terms))};")
        return lines

    def scaled(self, text):
        return f"T(1.0 / {self.scale}.0) * ({text})"

    def fetches(self):
        """Statements that read the stencil in its order, stepping along the axes."""
        lines = []
        for i, point in enumerate(self.stencil):
            if i in (0, self.even):
                lines.append(f"o = {'even' if i == 0 else 'odd'};")
                here = (0, 0, 0) if i == 0 else (1, 1, 1)
            steps = [(point[q] - here[q]) // 2 for q in range(3)]
            text = "".join(f" {'+' if s > 0 else '-'} s{q}" for q, s in enumerate(steps) for _ in range(abs(s)))
            if text:
                lines.append(f"o = o{text};")
            lines.append(f"c[{i}] = FETCH(o);")
            here = point
        return lines


def gcd(a, b):
    while b:
        a, b = b, a % b
    return a


def wrap(lines, indent="  "):
    """Breaks long statements at spaces, 100 columns."""
    out = []
    for line in lines:
        text = indent + line
        while len(text) > 100:
            cut = text.rfind(" ", 0, 100)
            out.append(text[:cut])
            text = indent + "  " + text[cut + 1 :]
        out.append(text)
    return "\n".join(out)


HEAD = """// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
// Generated by Module/Core/GenerateBoxSplines.py, do not edit.
"""


def stencil_text(kernel):
    cells = [", ".join(str(v) for v in p) for p in kernel.stencil]
    rows = [" ".join(f"{{ {c} }}," for c in cells[i : i + 6]) for i in range(0, len(cells), 6)]
    return "\n".join("  " + r for r in rows)


def monomials_text(kernel):
    cells = ["{ " + ", ".join(str(v) for v in m) + " }," for m in kernel.monomials]
    return "\n".join("  " + " ".join(cells[i : i + 5]) for i in range(0, len(cells), 5))


def cpp_file(kernel):
    k, n = kernel.kernel, len(kernel.stencil)
    polynomial = wrap(kernel.polynomial())
    fetches = wrap([line.replace("FETCH", "fetch") for line in kernel.fetches()])
    return f"""{HEAD}// For BoxSpline.h, and once more for each instruction set in BCCSplineRows.cxx: no guard.
// clang-format off

/// The {n} lattice points whose bcc{k} kernels cover the reference tetrahedron 1 >= x >= y >= z >= 0,
/// in the order in which they are fetched: {kernel.even} even points, then {n - kernel.even} odd ones.
inline constexpr int BCC{k}Stencil[{n}][3] = {{
{stencil_text(kernel)}
}};

/// The kernels' polynomials there: place in the stencil, powers of x, y and z, factor times
/// BCC{k}Scale.
inline constexpr short BCC{k}Monomials[{len(kernel.monomials)}][5] = {{
{monomials_text(kernel)}
}};
inline constexpr int BCC{k}Scale = {kernel.scale};

/// Fetches the stencil's coefficients from the places of the even point (0, 0, 0) and the odd point
/// (1, 1, 1) by steps s0, s1, s2 of 2 along the tetrahedron's axes.
template <class O, class Fetch, class T>
inline void BCC{k}Fetch(O even, O odd, O s0, O s1, O s2, const Fetch& fetch, T* c)
{{
  static_cast<void>(s1);
  O o = even;
{fetches.replace("  o = even;", "", 1).lstrip(chr(10))}
}}

/// The spline's value at (x, y, z) in the reference tetrahedron from its stencil's coefficients, and
/// its gradient along the tetrahedron's axes.
template <class T>
inline T BCC{k}Polynomial(T x, T y, T z, const T* c, T& gx, T& gy, T& gz)
{{
  static_cast<void>(x), static_cast<void>(y), static_cast<void>(z);
{polynomial}
}}

// clang-format on
"""


def glsl_statement(line):
    """GLSL multiplies vectors by plain numbers."""
    line = re.sub(r"T\(([-0-9.]+)\)", r"\1", line)
    line = re.sub(r"T\((1\.0 / [0-9.]+)\)", r"(\1)", line)
    return re.sub(r"^T ", "BCC_VALUE ", line)


def glsl_file(kernel):
    k, n = kernel.kernel, len(kernel.stencil)
    polynomial = wrap([glsl_statement(line) for line in kernel.polynomial()])
    fetches = wrap([line.replace("FETCH", "BCCCoefficient") for line in kernel.fetches()])
    return f"""{HEAD}
// BCC_VALUE is float, or vec2 .. vec4 for that many components at once; BCC_TEXEL is int or ivec3.
// The twin is Module/Core/BCC{k}Polynomial.inl.

// Fetches the stencil's coefficients from the texels of the even point (0, 0, 0) and the odd point
// (1, 1, 1) by steps s0, s1, s2 of 2 along the reference tetrahedron's axes.
void BCC{k}Fetch(BCC_TEXEL even, BCC_TEXEL odd, BCC_TEXEL s0, BCC_TEXEL s1, BCC_TEXEL s2,
  out BCC_VALUE c[{n}])
{{
  BCC_TEXEL o;
{fetches}
}}

// The spline's value at (x, y, z) in the reference tetrahedron 1 >= x >= y >= z >= 0 from its
// stencil's coefficients, and its gradient along the tetrahedron's axes.
BCC_VALUE BCC{k}Polynomial(float x, float y, float z, BCC_VALUE c[{n}],
  out BCC_VALUE gx, out BCC_VALUE gy, out BCC_VALUE gz)
{{
{polynomial}
}}
"""


def main():
    check = sys.argv[1:] == ["--check"]
    stale = []
    for number in BOX_SPLINES:
        kernel = Kernel(number)
        files = {
            ROOT / "Module" / "Core" / f"BCC{number}Polynomial.inl": cpp_file(kernel),
            ROOT / "Rendering" / "GLSL" / f"bcc{number}Polynomial.glsl": glsl_file(kernel),
        }
        for path, text in files.items():
            if not check:
                path.parent.mkdir(exist_ok=True)
                path.write_text(text)
            elif not path.exists() or path.read_text() != text:
                stale.append(str(path.relative_to(ROOT)))
    for path in stale:
        print(f"{path} is not what GenerateBoxSplines.py writes")
    return 1 if stale else 0


if __name__ == "__main__":
    sys.exit(main())
