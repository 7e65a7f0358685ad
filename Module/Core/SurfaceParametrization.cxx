// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceParametrization.h"

#include "FoldedCut.h"
#include "StretchDescent.h"
#include "StretchRelaxation.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace bravais
{

namespace
{

/// The same order of tips round the rim begins with the first of them.
std::array<int, 4> Rotate(std::array<int, 4> tips)
{
  std::rotate(tips.begin(), std::min_element(tips.begin(), tips.end()), tips.end());
  return tips;
}

} // namespace

//------------------------------------------------------------------------------
SurfaceParametrization::SurfaceParametrization(const TriangleTopology& mesh,
  const std::vector<glm::dvec3>& points, const glm::dvec2& size, Progress progress)
  : Mesh(mesh)
  , Points(points)
  , Size(size)
  , Shapes(GetShapes(mesh, points))
  , Tell(std::move(progress))
{
  double area = 0.0;
  for (const TriangleShape& shape : this->Shapes)
  {
    area += shape.Area;
  }
  for (TriangleShape& shape : this->Shapes)
  {
    const double scale = size.x * size.y / area;
    shape.Area *= scale;
    for (double& square : shape.Squares)
    {
      square *= scale;
    }
  }
}

//------------------------------------------------------------------------------
bool SurfaceParametrization::Report(double part)
{
  this->Stopped = this->Stopped || !this->Tell(part);
  return !this->Stopped;
}

//------------------------------------------------------------------------------
std::vector<SurfaceParameters> SurfaceParametrization::FindLayouts() const
{
  // The tree's root decides in which order the tips come.
  const std::array<int, 4> tips = FindTips(this->Mesh, this->Points);
  const std::array<glm::dvec2, 4> folds = GetFolds(this->Size);
  std::vector<SurfaceParameters> layouts;
  std::vector<std::array<int, 4>> orders;
  for (const int root : tips)
  {
    FoldedCut cut = CutToTips(this->Mesh, this->Points, root, tips, this->Size);
    const std::array<int, 4> order = Rotate(cut.Tips);
    if (std::find(orders.begin(), orders.end(), order) != orders.end())
    {
      continue;
    }
    orders.push_back(order);
    SurfaceParameters& layout = layouts.emplace_back();
    layout.Size = this->Size;
    layout.Corners = std::move(cut.Corners);
    layout.Fixed.assign(this->Points.size(), 0);
    layout.Places.assign(this->Points.size(), glm::dvec2(0.0));
    for (std::size_t n = 0; n < 4; ++n)
    {
      layout.Fixed[static_cast<std::size_t>(cut.Tips[n])] = 1;
      layout.Places[static_cast<std::size_t>(cut.Tips[n])] = folds[n];
    }
  }
  return layouts;
}

//------------------------------------------------------------------------------
bool SurfaceParametrization::Embed(
  SpringEmbedding& springs, SurfaceParameters& parameters, std::vector<double>& weights) const
{
  // Far from the fixed vertices, parts of the surface can shrink below what double precision tells
  // apart; weaker springs there let them grow.
  constexpr int attempts = 40;
  for (int n = 0; n < attempts && springs.Solve(weights, parameters); ++n)
  {
    if (CountFlipped(this->Mesh, parameters) == 0)
    {
      return true;
    }
    WeakenStretched(this->Mesh, this->Shapes, parameters, weights);
  }
  return false;
}

//------------------------------------------------------------------------------
double SurfaceParametrization::Loosen(SpringEmbedding& springs, int solves,
  SurfaceParameters& parameters, std::vector<double>& weights) const
{
  // The stretch need not fall all the way: the best of all is kept.
  double best = GetStretch(this->Mesh, this->Shapes, parameters);
  SurfaceParameters latest = parameters;
  for (int n = 0; n < solves; ++n)
  {
    WeakenStretched(this->Mesh, this->Shapes, latest, weights);
    if (!springs.Solve(weights, latest) || CountFlipped(this->Mesh, latest) > 0)
    {
      break;
    }
    const double stretch = GetStretch(this->Mesh, this->Shapes, latest);
    if (stretch < best)
    {
      best = stretch;
      parameters.Places = latest.Places;
    }
  }
  return best;
}

//------------------------------------------------------------------------------
bool SurfaceParametrization::Descend(int rounds, SurfaceParameters& parameters)
{
  constexpr int steps = 20;
  constexpr double least = 0.01; // of the distortion, removed by a round that is worth the next one
  StretchDescent descent(this->Mesh, this->Shapes, parameters);
  for (int n = 0; n < rounds; ++n)
  {
    RelaxStretch(this->Mesh, this->Shapes, parameters);
    const double removed = descent.Descend(steps, parameters);
    RelaxStretch(this->Mesh, this->Shapes, parameters);
    if (!this->Report(0.4 + 0.5 * (n + 1) / rounds))
    {
      return false;
    }
    if (removed < least)
    {
      break;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
std::optional<SurfaceParameters> SurfaceParametrization::Execute(int rounds)
{
  constexpr int solves = 7;
  const std::vector<SurfaceParameters> layouts = this->FindLayouts();
  std::optional<SurfaceParameters> best;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t n = 0; n < layouts.size(); ++n)
  {
    if (!this->Report(0.05 + 0.35 * static_cast<double>(n) / static_cast<double>(layouts.size())))
    {
      return std::nullopt;
    }
    SurfaceParameters parameters = layouts[n];
    std::vector<double> weights = GetConformalWeights(this->Mesh, this->Shapes);
    SpringEmbedding springs(this->Mesh, parameters);
    if (this->Embed(springs, parameters, weights))
    {
      const double stretch = this->Loosen(springs, solves, parameters, weights);
      if (stretch < least)
      {
        least = stretch;
        best = std::move(parameters);
      }
    }
  }
  if (!best || !this->Report(0.4) || !this->Descend(rounds, *best))
  {
    return std::nullopt;
  }
  return best;
}

//------------------------------------------------------------------------------
std::optional<SurfaceParameters> SurfaceParametrization::Execute(
  int rounds, SurfaceParameters start)
{
  constexpr int solves = 8;
  std::vector<double> weights = GetConformalWeights(this->Mesh, this->Shapes);
  SpringEmbedding springs(this->Mesh, start);
  if (!this->Report(0.05) || !this->Embed(springs, start, weights))
  {
    return std::nullopt;
  }
  this->Loosen(springs, solves, start, weights);
  if (!this->Report(0.4) || !this->Descend(rounds, start))
  {
    return std::nullopt;
  }
  return start;
}

} // namespace bravais
