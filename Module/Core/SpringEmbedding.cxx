// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SpringEmbedding.h"

#include <Eigen/SparseCholesky>

#include <algorithm>
#include <cmath>

namespace bravais
{

namespace
{

std::size_t Index(int n)
{
  return static_cast<std::size_t>(n);
}

} // namespace

//------------------------------------------------------------------------------
struct SpringEmbedding::Internals
{
  using Matrix = Eigen::SparseMatrix<double>;

  const TriangleTopology& Mesh;
  std::vector<int> Unknowns; // of vertices, -1 where fixed
  int Count = 0;
  Eigen::SimplicialLDLT<Matrix> Factors;
  bool Analyzed = false;
};

//------------------------------------------------------------------------------
SpringEmbedding::SpringEmbedding(const TriangleTopology& mesh, const SurfaceParameters& parameters)
  : Members(new Internals{ mesh, {}, 0, {}, false })
{
  for (int vertex = 0; vertex < mesh.GetNumberOfVertices(); ++vertex)
  {
    const bool free = !parameters.Fixed[Index(vertex)] && mesh.GetOutgoing(vertex) >= 0;
    this->Members->Unknowns.push_back(free ? this->Members->Count++ : -1);
  }
}

SpringEmbedding::~SpringEmbedding() = default;

//------------------------------------------------------------------------------
bool SpringEmbedding::Solve(const std::vector<double>& weights, SurfaceParameters& parameters)
{
  Internals& m = *this->Members;
  if (m.Count == 0)
  {
    return true;
  }
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(2 * weights.size());
  Eigen::MatrixX2d right = Eigen::MatrixX2d::Zero(m.Count, 2);
  for (int h = 0; h < m.Mesh.GetNumberOfHalfEdges(); ++h)
  {
    const int row = m.Unknowns[Index(m.Mesh.GetOrigin(h))];
    if (row < 0)
    {
      continue;
    }
    const int end = m.Mesh.GetEnd(h);
    const int column = m.Unknowns[Index(end)];
    const double weight = weights[Index(h)];
    const HalfTurn turn =
      parameters.GetCorner(h).Invert() * parameters.GetCorner(TriangleTopology::GetNext(h));
    const glm::dvec2 shift = column < 0 ? turn(parameters.Places[Index(end)]) : turn.Shift;
    right(row, 0) += weight * shift.x;
    right(row, 1) += weight * shift.y;
    entries.emplace_back(row, row, weight);
    if (column >= 0)
    {
      entries.emplace_back(row, column, -weight * turn.Sign);
    }
  }
  Internals::Matrix matrix(m.Count, m.Count);
  matrix.setFromTriplets(entries.begin(), entries.end());
  if (!m.Analyzed)
  {
    m.Factors.analyzePattern(matrix);
    m.Analyzed = true;
  }
  m.Factors.factorize(matrix);
  if (m.Factors.info() != Eigen::Success)
  {
    return false;
  }
  const Eigen::MatrixX2d solution = m.Factors.solve(right);
  if (!solution.allFinite())
  {
    return false;
  }
  for (std::size_t vertex = 0; vertex < m.Unknowns.size(); ++vertex)
  {
    if (const int row = m.Unknowns[vertex]; row >= 0)
    {
      parameters.Places[vertex] = { solution(row, 0), solution(row, 1) };
    }
  }
  return true;
}

//------------------------------------------------------------------------------
std::vector<double> GetConformalWeights(
  const TriangleTopology& mesh, const std::vector<TriangleShape>& shapes)
{
  constexpr double least = 0.02;
  constexpr double most = 50.0;
  std::vector<double> weights(Index(mesh.GetNumberOfHalfEdges()));
  const auto getCotangent = [&](int h)
  {
    const TriangleShape& shape = shapes[Index(h / 3)];
    const std::size_t k = Index(TriangleTopology::GetPrevious(h) % 3); // the corner opposite
    const double sum = shape.Squares[(k + 1) % 3] + shape.Squares[(k + 2) % 3] - shape.Squares[k];
    return std::clamp(sum / (8.0 * shape.Area), -most, most); // half the cotangent
  };
  for (int h = 0; h < mesh.GetNumberOfHalfEdges(); ++h)
  {
    const int twin = mesh.GetTwin(h);
    const double sum = getCotangent(h) + (twin >= 0 ? getCotangent(twin) : 0.0);
    weights[Index(h)] = std::clamp(sum, least, most);
  }
  return weights;
}

//------------------------------------------------------------------------------
void WeakenStretched(const TriangleTopology& mesh, const std::vector<TriangleShape>& shapes,
  const SurfaceParameters& parameters, std::vector<double>& weights)
{
  std::vector<double> stretch(Index(mesh.GetNumberOfVertices()), 0.0);
  std::vector<double> area(stretch.size(), 0.0);
  std::vector<double> sums;
  double most = 1.0; // of stretch to area
  for (std::size_t t = 0; t < shapes.size(); ++t)
  {
    sums.push_back(GetStretch(shapes[t], GetCorners(mesh, parameters, static_cast<int>(t))));
    most = std::isfinite(sums[t]) ? std::max(most, sums[t] / shapes[t].Area) : most;
  }
  for (std::size_t t = 0; t < shapes.size(); ++t)
  {
    for (const int vertex : mesh.GetTriangles()[t])
    {
      stretch[Index(vertex)] += std::isfinite(sums[t]) ? sums[t] : 100.0 * most * shapes[t].Area;
      area[Index(vertex)] += shapes[t].Area;
    }
  }
  double mean = 0.0;
  for (std::size_t v = 0; v < stretch.size(); ++v)
  {
    stretch[v] = area[v] > 0.0 && stretch[v] > 0.0 ? 0.5 * std::log(stretch[v] / area[v]) : 0.0;
    mean += stretch[v] / static_cast<double>(stretch.size());
  }
  for (double& s : stretch)
  {
    s = std::exp(mean - s);
  }
  for (int h = 0; h < mesh.GetNumberOfHalfEdges(); ++h)
  {
    weights[Index(h)] *= stretch[Index(mesh.GetOrigin(h))] * stretch[Index(mesh.GetEnd(h))];
  }
}

} // namespace bravais
