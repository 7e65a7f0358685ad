// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkBCCProgress.h"

#include "vtkBCCPictureState.h"
#include "vtkBCCVolumeMapper.h"

#include "vtkCamera.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"
#include "vtk_glew.h"

#include <algorithm>
#include <utility>
#include <vector>

struct vtkBCCProgress::Entry
{
  vtkWeakPointer<vtkRenderer> Renderer;
  vtkWeakPointer<vtkVolume> Volume;
  bool LeftEye;
  std::unique_ptr<vtkBCCProgressiveFrame> Frame;
  unsigned long Drawn = 0; // the number of its last picture
  bool Complete = false;
  bool Counts = false;
};

vtkBCCProgress::vtkBCCProgress() = default;
vtkBCCProgress::~vtkBCCProgress() = default;

//------------------------------------------------------------------------------
vtkBCCProgress::Entry& vtkBCCProgress::Find(vtkRenderer* renderer, vtkVolume* volume)
{
  this->Entries.remove_if([](const Entry& entry) { return !entry.Renderer || !entry.Volume; });
  const bool left = renderer->GetActiveCamera()->GetLeftEye() != 0;
  const auto found = std::find_if(this->Entries.begin(), this->Entries.end(),
    [&](const Entry& entry)
    { return entry.Renderer == renderer && entry.Volume == volume && entry.LeftEye == left; });
  if (found != this->Entries.end())
  {
    return *found;
  }
  this->Entries.emplace_back();
  Entry& entry = this->Entries.back();
  entry.Renderer = renderer;
  entry.Volume = volume;
  entry.LeftEye = left;
  return entry;
}

//------------------------------------------------------------------------------
vtkBCCProgressiveFrame* vtkBCCProgress::StartPass(
  vtkRenderer* renderer, vtkVolume* volume, vtkBCCVolumeMapper* mapper, bool depth)
{
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  vtkBCCProgressiveFrame::Layout layout;
  window->GetState()->vtkglGetIntegerv(GL_VIEWPORT, layout.Viewport.data());
  const int size = mapper->GetProgressivePatternSize();
  layout.Log2BlockSize = size == 8 ? 3 : (size == 4 ? 2 : 1);
  layout.Depth = depth;
  std::vector<double> state = vtkBCCPictureState::Get(renderer, volume, mapper);
  state.push_back(static_cast<double>(mapper->GetCoefficientTime()));
  Entry& entry = this->Find(renderer, volume);
  if (!entry.Frame)
  {
    entry.Frame = std::make_unique<vtkBCCProgressiveFrame>();
  }
  entry.Frame->Prepare(window, layout, std::move(state));
  return entry.Frame.get();
}

//------------------------------------------------------------------------------
bool vtkBCCProgress::Finish(vtkRenderer* renderer, vtkVolume* volume, bool complete)
{
  Entry& drawn = this->Find(renderer, volume);
  for (Entry& entry : this->Entries)
  {
    entry.Counts = entry.Counts && entry.Drawn >= drawn.Drawn;
  }
  drawn.Drawn = ++this->Count;
  drawn.Complete = complete;
  drawn.Counts = true;
  const bool before = this->Complete;
  this->Complete = std::all_of(this->Entries.begin(), this->Entries.end(),
    [](const Entry& entry) { return entry.Complete || !entry.Counts; });
  return this->Complete && !before;
}

//------------------------------------------------------------------------------
void vtkBCCProgress::Release()
{
  for (Entry& entry : this->Entries)
  {
    entry.Frame.reset();
  }
}
