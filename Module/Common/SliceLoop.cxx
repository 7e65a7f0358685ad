// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SliceLoop.h"

#include "vtkAlgorithm.h"
#include "vtkSMPTools.h"

#include <atomic>
#include <thread>

namespace bravais
{

//------------------------------------------------------------------------------
bool ForEachSlice(vtkAlgorithm* self, int first, int last, const std::function<void(int)>& work,
  double begin, double end)
{
  constexpr double smallest = 0.01; // of the loop, between two reports
  const double total = static_cast<double>(last) - first + 1.0;
  const std::thread::id caller = std::this_thread::get_id();
  std::atomic<vtkIdType> finished{ 0 };
  double reported = 0.0; // the caller's alone
  const auto loop = [&](vtkIdType from, vtkIdType to)
  {
    for (vtkIdType k = from; k < to && !self->GetAbortExecute(); ++k)
    {
      work(static_cast<int>(k));
      const double share = static_cast<double>(++finished) / total;
      if (std::this_thread::get_id() == caller && share - reported >= smallest)
      {
        reported = share;
        self->UpdateProgress(begin + share * (end - begin));
      }
    }
  };
  self->UpdateProgress(begin);
  vtkSMPTools::For(first, vtkIdType{ last } + 1, 1, loop);
  if (self->GetAbortExecute())
  {
    return false;
  }
  self->UpdateProgress(end);
  return !self->GetAbortExecute();
}

//------------------------------------------------------------------------------
bool ForEachSliceInOrder(vtkAlgorithm* self, int first, int last,
  const std::function<void(int)>& work, double begin, double end)
{
  const double total = static_cast<double>(last) - first + 1.0;
  for (vtkIdType k = first; k <= last && !self->GetAbortExecute(); ++k)
  {
    self->UpdateProgress(begin + static_cast<double>(k - first) / total * (end - begin));
    work(static_cast<int>(k));
  }
  if (self->GetAbortExecute())
  {
    return false;
  }
  self->UpdateProgress(end);
  return !self->GetAbortExecute();
}

} // namespace bravais
