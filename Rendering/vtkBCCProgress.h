// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkBCCProgress
 * @brief   the progressive pictures of one mapper, in all its viewports
 *
 * A mapper may be drawn in several renderers, for several volumes and for both eyes, in turn. Each
 * has its own frame. Together they are complete if all are that have been drawn since the one drawn
 * last was drawn before; so a viewport that is shown no more does not count.
 */

#ifndef vtkBCCProgress_h
#define vtkBCCProgress_h

#include "vtkBCCProgressiveFrame.h"
#include "vtkBravaisABINamespace.h"

#include "vtkWeakPointer.h"

#include <list>

VTK_ABI_NAMESPACE_BEGIN
class vtkBCCVolumeMapper;
class vtkRenderer;
class vtkVolume;

class vtkBCCProgress
{
public:
  vtkBCCProgress();
  ~vtkBCCProgress();

  /// The frame of a volume in a renderer, for the eye that its camera is at, ready for the next
  /// pass of a picture as the mapper has it, with depths or without.
  vtkBCCProgressiveFrame* StartPass(
    vtkRenderer* renderer, vtkVolume* volume, vtkBCCVolumeMapper* mapper, bool depth);

  /// After the volume was drawn in the renderer, and its picture is complete or not. True if all
  /// pictures so became complete.
  bool Finish(vtkRenderer* renderer, vtkVolume* volume, bool complete);

  /// False before the first picture.
  bool IsComplete() const { return this->Complete; }

  /// Drops the frames' textures; what is complete remains so.
  void Release();

private:
  struct Entry;
  Entry& Find(vtkRenderer* renderer, vtkVolume* volume);

  std::list<Entry> Entries;
  unsigned long Count = 0; // of pictures
  bool Complete = false;
};
VTK_ABI_NAMESPACE_END

#endif
// VTK-HeaderTest-Exclude: vtkBCCProgress.h
