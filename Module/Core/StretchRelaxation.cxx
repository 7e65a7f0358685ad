// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "StretchRelaxation.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <limits>

namespace bravais
{

namespace
{

std::size_t Index(int n)
{
  return static_cast<std::size_t>(n);
}

double Cross(const glm::dvec2& a, const glm::dvec2& b)
{
  return a.x * b.y - a.y * b.x;
}

/// A triangle at a vertex: its other corners, and the squares of its edges.
struct Wedge
{
  glm::dvec2 Next, Last;
  double Across;         // of the edge opposite to the vertex
  double ToNext, ToLast; // of those at the vertex
  double Area;
};

/// Value, gradient and second derivatives of the distortion round a vertex.
struct Model
{
  double Value = 0.0;
  glm::dvec2 Gradient{ 0.0 };
  double XX = 0.0, XY = 0.0, YY = 0.0;
};

/// M of DistortionFactor.
double GetNumerator(const Wedge& w, const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c)
{
  return -(w.Across * glm::dot(b, c) + w.ToLast * glm::dot(c, a) + w.ToNext * glm::dot(a, b));
}

double Evaluate(const std::vector<Wedge>& ring, const glm::dvec2& u)
{
  double sum = 0.0;
  for (const Wedge& w : ring)
  {
    const glm::dvec2 a = w.Last - w.Next;
    const glm::dvec2 b = u - w.Last;
    const glm::dvec2 c = w.Next - u;
    const double d = Cross(a, b);
    if (!(d > 0.0))
    {
      return std::numeric_limits<double>::infinity();
    }
    sum += 0.5 * w.Area * GetNumerator(w, a, b, c) * DistortionFactor(w.Area, d).Value;
  }
  return sum;
}

Model Expand(const std::vector<Wedge>& ring, const glm::dvec2& u)
{
  Model model;
  for (const Wedge& w : ring)
  {
    const glm::dvec2 a = w.Last - w.Next;
    const glm::dvec2 b = u - w.Last;
    const glm::dvec2 c = w.Next - u;
    const DistortionFactor f(w.Area, Cross(a, b));
    const double m = GetNumerator(w, a, b, c);
    const glm::dvec2 gd(-a.y, a.x);
    const glm::dvec2 gm = -(w.Across * (c - b) + (w.ToNext - w.ToLast) * a);
    const double half = 0.5 * w.Area;
    const double hm = 2.0 * w.Across * f.Value;
    model.Value += half * m * f.Value;
    model.Gradient += half * (f.Value * gm + m * f.First * gd);
    model.XX += half * (hm + 2.0 * f.First * gm.x * gd.x + m * f.Second * gd.x * gd.x);
    model.XY += half * (f.First * (gm.x * gd.y + gm.y * gd.x) + m * f.Second * gd.x * gd.y);
    model.YY += half * (hm + 2.0 * f.First * gm.y * gd.y + m * f.Second * gd.y * gd.y);
  }
  return model;
}

/// Newton's step, downhill in any case.
glm::dvec2 GetStep(const Model& m)
{
  const double trace = m.XX + m.YY;
  const double determinant = m.XX * m.YY - m.XY * m.XY;
  const double root = std::sqrt(std::max(0.25 * trace * trace - determinant, 0.0));
  const double least = 0.5 * trace - root;
  const double most = 0.5 * trace + root;
  const double shift = std::max(1e-3 * std::abs(most) - least, 0.0);
  const double xx = m.XX + shift;
  const double yy = m.YY + shift;
  const double scale = 1.0 / (xx * yy - m.XY * m.XY);
  return -scale *
    glm::dvec2(yy * m.Gradient.x - m.XY * m.Gradient.y, xx * m.Gradient.y - m.XY * m.Gradient.x);
}

} // namespace

//------------------------------------------------------------------------------
double RelaxStretch(const TriangleTopology& mesh, const std::vector<TriangleShape>& shapes,
  SurfaceParameters& parameters)
{
  double removed = 0.0;
  std::vector<Wedge> ring;
  for (int vertex = 0; vertex < mesh.GetNumberOfVertices(); ++vertex)
  {
    if (parameters.Fixed[Index(vertex)] || mesh.GetOutgoing(vertex) < 0)
    {
      continue;
    }
    ring.clear();
    const int first = mesh.GetOutgoing(vertex);
    int h = first;
    do
    {
      const int next = TriangleTopology::GetNext(h);
      const int last = TriangleTopology::GetPrevious(h);
      const HalfTurn turn = parameters.GetCorner(h).Invert();
      const TriangleShape& shape = shapes[Index(h / 3)];
      ring.push_back(
        { turn(parameters.GetCorner(next)(parameters.Places[Index(mesh.GetOrigin(next))])),
          turn(parameters.GetCorner(last)(parameters.Places[Index(mesh.GetOrigin(last))])),
          shape.Squares[Index(h % 3)], shape.Squares[Index(last % 3)],
          shape.Squares[Index(next % 3)], shape.Area });
      h = mesh.GetTwin(last);
    } while (h != first);
    glm::dvec2& u = parameters.Places[Index(vertex)];
    const Model model = Expand(ring, u);
    const glm::dvec2 step = GetStep(model);
    double length = 1.0;
    for (int half = 0; half < 8; ++half, length *= 0.5)
    {
      const double value = Evaluate(ring, u + length * step);
      if (value < model.Value)
      {
        u += length * step;
        removed += model.Value - value;
        break;
      }
    }
  }
  return removed;
}

} // namespace bravais
