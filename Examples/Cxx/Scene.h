// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Scene_h
#define Scene_h

/// \file
/// A window with one volume in it: its mapper, camera, lights and picture.

#include "Appearance.h"

#include "vtkNew.h"
#include "vtkSmartPointer.h"

#include <string>

class vtkGPUVolumeRayCastMapper;
class vtkImageData;
class vtkRenderWindow;
class vtkRenderer;
class vtkTextActor;

/// Where a volume is looked at from.
struct View
{
  double From[3] = { 0.55, -1.0, 0.35 }; ///< from the centre towards the eye
  double Up[3] = { 0.0, 0.0, 1.0 };      ///< what is up in the picture
  double Focus[3] = { 0.5, 0.5, 0.5 };   ///< what is in its middle, in fractions of the box
  double Zoom = 1.0;                     ///< at 1 all of the box is in the picture
  double Crop[6] = { 0, 1, 0, 1, 0, 1 }; ///< the part that is drawn, in fractions of the box
};

class Scene
{
public:
  Scene(int width, int height, bool offScreen);
  ~Scene();

  /// Puts a volume into the window, instead of the former. A BCC volume is drawn by
  /// vtkBCCVolumeMapper, any other by VTK's own mapper, which is trilinear. Rays advance by half of
  /// the edge of a cube with one sample in it, the same for both.
  void Show(vtkImageData* volume, Mode mode, const std::vector<Surface>& surfaces, int kernel,
    int prefilter);

  void LookFrom(const View& view);

  /// A line at the foot of the picture.
  void SetLabel(const std::string& text);

  /// Draws, once in small to make everything ready and once more; seconds that the latter took.
  double Time();

  /// The picture as it is seen. Null after an error.
  vtkSmartPointer<vtkImageData> Grab();

  vtkRenderWindow* GetWindow();

  /// What draws the volume; null before Show.
  vtkGPUVolumeRayCastMapper* GetMapper();

  /// Lets the user turn the volume about until the window is closed.
  void Interact(const std::string& title);

private:
  Scene(const Scene&) = delete;
  void operator=(const Scene&) = delete;

  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkTextActor> Label;
  vtkSmartPointer<vtkGPUVolumeRayCastMapper> Mapper;
};

/// False if the file could not be written.
bool WritePicture(vtkImageData* picture, const std::string& path);

#endif
