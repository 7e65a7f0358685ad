// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TriangleTopology_h
#define TriangleTopology_h

/// \file
/// Who is next to whom in a triangle mesh. Half-edge 3 t + k goes from corner k of triangle t to
/// the next corner; its twin is the same edge in the other triangle.

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace bravais
{

using Triangle = std::array<int, 3>;

/// A connected, oriented mesh whose every edge has one or two triangles and whose every vertex has
/// one fan of them.
class TriangleTopology
{
public:
  /// Takes triangles of vertices 0 to vertices - 1, and turns some of them round so that all have
  /// one sense, that of most. False if they are not as said above; then `why` tells what was found
  /// and what was expected.
  bool Set(int vertices, std::vector<Triangle> triangles, std::string& why);

  int GetNumberOfVertices() const { return this->Vertices; }
  const std::vector<Triangle>& GetTriangles() const { return this->Triangles; }
  int GetNumberOfHalfEdges() const { return static_cast<int>(3 * this->Triangles.size()); }

  int GetOrigin(int h) const
  {
    return this->Triangles[static_cast<std::size_t>(h / 3)][static_cast<std::size_t>(h % 3)];
  }
  int GetEnd(int h) const { return this->GetOrigin(GetNext(h)); }
  static int GetNext(int h) { return h % 3 == 2 ? h - 2 : h + 1; }
  static int GetPrevious(int h) { return h % 3 == 0 ? h + 2 : h - 1; }
  /// -1 at the boundary.
  int GetTwin(int h) const { return this->Twins[static_cast<std::size_t>(h)]; }
  /// A half-edge that starts there: at the boundary, the one that has no twin.
  int GetOutgoing(int vertex) const { return this->Outgoing[static_cast<std::size_t>(vertex)]; }

  int GetGenus() const;
  int GetNumberOfBoundaries() const { return static_cast<int>(this->Boundaries.size()); }
  /// Vertices of a boundary, in the order of its triangles' sense.
  const std::vector<int>& GetBoundary(int n) const
  {
    return this->Boundaries[static_cast<std::size_t>(n)];
  }

private:
  bool PairHalfEdges(std::string& why);
  bool Orient(std::string& why);
  bool FindFans(std::string& why);
  void FindBoundaries();

  int Vertices = 0;
  std::vector<Triangle> Triangles;
  std::vector<int> Twins;
  std::vector<int> Outgoing;
  std::vector<std::vector<int>> Boundaries;
};

} // namespace bravais

#endif
