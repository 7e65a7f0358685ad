// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "StretchDescent.h"

#include <glm/geometric.hpp>

#include <Eigen/SparseCholesky>

#include <cmath>
#include <deque>
#include <limits>

namespace bravais
{

namespace
{

using Matrix = Eigen::SparseMatrix<double>;
using Places = Eigen::MatrixX2d;

std::size_t Index(int n)
{
  return static_cast<std::size_t>(n);
}

double Cross(const glm::dvec2& a, const glm::dvec2& b)
{
  return a.x * b.y - a.y * b.x;
}

double Dot(const Places& a, const Places& b)
{
  return a.cwiseProduct(b).sum();
}

} // namespace

//------------------------------------------------------------------------------
struct StretchDescent::Internals
{
  const TriangleTopology& Mesh;
  const std::vector<TriangleShape>& Shapes;
  std::vector<int> Unknowns; // of vertices, -1 where fixed
  int Count = 0;
  Eigen::SimplicialLDLT<Matrix> Factors;
  bool Analyzed = false;

  std::array<int, 3> GetUnknowns(int triangle) const
  {
    const Triangle& t = this->Mesh.GetTriangles()[Index(triangle)];
    return { { this->Unknowns[Index(t[0])], this->Unknowns[Index(t[1])],
      this->Unknowns[Index(t[2])] } };
  }
  int GetNumberOfTriangles() const { return static_cast<int>(this->Shapes.size()); }

  double GetDistortion(const SurfaceParameters& parameters) const
  {
    double sum = 0.0;
    for (int t = 0; t < this->GetNumberOfTriangles(); ++t)
    {
      sum += bravais::GetDistortion(this->Shapes[Index(t)], GetCorners(this->Mesh, parameters, t));
    }
    return sum;
  }

  Places GetGradient(const SurfaceParameters& parameters) const
  {
    Places gradient = Places::Zero(this->Count, 2);
    for (int t = 0; t < this->GetNumberOfTriangles(); ++t)
    {
      const TriangleShape& shape = this->Shapes[Index(t)];
      const auto u = GetCorners(this->Mesh, parameters, t);
      const glm::dvec2 edges[3] = { u[2] - u[1], u[0] - u[2], u[1] - u[0] };
      const DistortionFactor factor(shape.Area, Cross(edges[0], edges[1]));
      const double m = -(shape.Squares[0] * glm::dot(edges[1], edges[2]) +
        shape.Squares[1] * glm::dot(edges[2], edges[0]) +
        shape.Squares[2] * glm::dot(edges[0], edges[1]));
      const std::array<int, 3> unknowns = this->GetUnknowns(t);
      for (std::size_t k = 0; k < 3; ++k)
      {
        if (unknowns[k] >= 0)
        {
          const glm::dvec2& a = edges[k];
          const glm::dvec2& b = edges[(k + 1) % 3];
          const glm::dvec2& c = edges[(k + 2) % 3];
          const double sign = parameters.GetCorner(3 * t + static_cast<int>(k)).Sign;
          const glm::dvec2 numerator = -(shape.Squares[k] * (c - b) +
            (shape.Squares[(k + 2) % 3] - shape.Squares[(k + 1) % 3]) * a);
          const glm::dvec2 part = sign * 0.5 * shape.Area *
            (factor.Value * numerator + m * factor.First * glm::dvec2(-a.y, a.x));
          gradient(unknowns[k], 0) += part.x;
          gradient(unknowns[k], 1) += part.y;
        }
      }
    }
    return gradient;
  }

  bool Factorize(const SurfaceParameters& parameters)
  {
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(12 * this->Shapes.size());
    for (int t = 0; t < this->GetNumberOfTriangles(); ++t)
    {
      const auto u = GetCorners(this->Mesh, parameters, t);
      const double area = Cross(u[1] - u[0], u[2] - u[0]);
      const double weight = bravais::GetDistortion(this->Shapes[Index(t)], u) / (area * area);
      const std::array<int, 3> unknowns = this->GetUnknowns(t);
      for (std::size_t k = 0; k < 3; ++k)
      {
        const std::size_t l = (k + 1) % 3;
        const std::size_t m = (k + 2) % 3;
        const double w = weight * glm::dot(u[k] - u[m], u[l] - u[m]); // between k and l
        const double sign = parameters.GetCorner(3 * t + static_cast<int>(k)).Sign *
          parameters.GetCorner(3 * t + static_cast<int>(l)).Sign;
        if (unknowns[k] >= 0)
        {
          entries.emplace_back(unknowns[k], unknowns[k], w);
        }
        if (unknowns[l] >= 0)
        {
          entries.emplace_back(unknowns[l], unknowns[l], w);
        }
        if (unknowns[k] >= 0 && unknowns[l] >= 0)
        {
          entries.emplace_back(unknowns[k], unknowns[l], -sign * w);
          entries.emplace_back(unknowns[l], unknowns[k], -sign * w);
        }
      }
    }
    Matrix matrix(this->Count, this->Count);
    matrix.setFromTriplets(entries.begin(), entries.end());
    if (!this->Analyzed)
    {
      this->Factors.analyzePattern(matrix);
      this->Analyzed = true;
    }
    this->Factors.factorize(matrix);
    return this->Factors.info() == Eigen::Success;
  }

  void Move(const Places& step, double length, SurfaceParameters& parameters) const
  {
    for (std::size_t vertex = 0; vertex < this->Unknowns.size(); ++vertex)
    {
      if (const int n = this->Unknowns[vertex]; n >= 0)
      {
        parameters.Places[vertex] += length * glm::dvec2(step(n, 0), step(n, 1));
      }
    }
  }
};

//------------------------------------------------------------------------------
StretchDescent::StretchDescent(const TriangleTopology& mesh,
  const std::vector<TriangleShape>& shapes, const SurfaceParameters& parameters)
  : Members(new Internals{ mesh, shapes, {}, 0, {}, false })
{
  for (int vertex = 0; vertex < mesh.GetNumberOfVertices(); ++vertex)
  {
    const bool free = !parameters.Fixed[Index(vertex)] && mesh.GetOutgoing(vertex) >= 0;
    this->Members->Unknowns.push_back(free ? this->Members->Count++ : -1);
  }
}

StretchDescent::~StretchDescent() = default;

//------------------------------------------------------------------------------
double StretchDescent::Descend(int steps, SurfaceParameters& parameters)
{
  Internals& m = *this->Members;
  const double start = m.GetDistortion(parameters);
  if (m.Count == 0 || !std::isfinite(start) || !m.Factorize(parameters))
  {
    return 0.0;
  }
  struct Pair
  {
    Places Step, Change;
    double Product;
  };
  std::deque<Pair> history;
  double value = start;
  Places gradient = m.GetGradient(parameters);
  for (int n = 0; n < steps; ++n)
  {
    Places direction = gradient;
    std::vector<double> alpha(history.size());
    for (std::size_t k = history.size(); k-- > 0;)
    {
      alpha[k] = Dot(history[k].Step, direction) / history[k].Product;
      direction -= alpha[k] * history[k].Change;
    }
    direction = m.Factors.solve(direction).eval();
    for (std::size_t k = 0; k < history.size(); ++k)
    {
      const double beta = Dot(history[k].Change, direction) / history[k].Product;
      direction += (alpha[k] - beta) * history[k].Step;
    }
    direction = -direction;
    const double slope = Dot(gradient, direction);
    if (!(slope < 0.0))
    {
      break;
    }
    const std::vector<glm::dvec2> before = parameters.Places;
    double length = 1.0;
    double next = std::numeric_limits<double>::infinity();
    for (int half = 0; half < 40; ++half, length *= 0.5)
    {
      parameters.Places = before;
      m.Move(direction, length, parameters);
      next = m.GetDistortion(parameters);
      if (next <= value + 1e-4 * length * slope)
      {
        break;
      }
      next = std::numeric_limits<double>::infinity();
    }
    if (!std::isfinite(next))
    {
      parameters.Places = before;
      break;
    }
    const Places latest = m.GetGradient(parameters);
    Pair pair{ length * direction, latest - gradient, 0.0 };
    pair.Product = Dot(pair.Step, pair.Change);
    if (pair.Product > 0.0)
    {
      history.push_back(std::move(pair));
      if (history.size() > 8)
      {
        history.pop_front();
      }
    }
    value = next;
    gradient = latest;
  }
  return 1.0 - value / start;
}

} // namespace bravais
