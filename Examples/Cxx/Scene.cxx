// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene.h"

#include "vtkBCCLattice.h"
#include "vtkBCCVolumeMapper.h"
#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkInteractorStyleTrackballCamera.h"
#include "vtkLight.h"
#include "vtkOpenGLGPUVolumeRayCastMapper.h"
#include "vtkPNGWriter.h"
#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"
#include "vtkTextActor.h"
#include "vtkTextProperty.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"
#include "vtkWindowToImageFilter.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace
{

/// A light that moves with the camera, at (x, y, z) in a view where the camera is at (0, 0, 1).
void AddLight(vtkRenderer* renderer, double x, double y, double z, double intensity, double red,
  double green, double blue)
{
  vtkNew<vtkLight> light;
  light->SetLightTypeToCameraLight();
  light->SetPosition(x, y, z);
  light->SetFocalPoint(0.0, 0.0, 0.0);
  light->SetIntensity(intensity);
  light->SetColor(red, green, blue);
  renderer->AddLight(light);
}

void SetCropping(vtkVolumeMapper* mapper, const double box[6], const double crop[6])
{
  double planes[6];
  for (int p = 0; p < 6; ++p)
  {
    const double* side = box + p / 2 * 2;
    planes[p] = side[0] + crop[p] * (side[1] - side[0]);
  }
  mapper->SetCroppingRegionPlanes(planes);
  mapper->SetCroppingRegionFlagsToSubVolume();
  mapper->SetCropping(!std::equal(planes, planes + 6, box));
}

} // namespace

Scene::Scene(int width, int height, bool offScreen)
{
  this->Renderer->GradientBackgroundOn();
  this->Renderer->SetBackground(0.05, 0.06, 0.09);
  this->Renderer->SetBackground2(0.22, 0.27, 0.36);
  this->Renderer->SetTwoSidedLighting(true);
  this->Renderer->SetAutomaticLightCreation(false);
  AddLight(this->Renderer, -0.6, 0.7, 1.0, 1.05, 1.0, 0.97, 0.92);
  AddLight(this->Renderer, 1.0, 0.1, 0.7, 0.45, 0.85, 0.92, 1.0);
  this->Window->SetOffScreenRendering(offScreen);
  this->Window->SetMultiSamples(0);
  this->Window->SetSize(width, height);
  this->Window->AddRenderer(this->Renderer);
}

Scene::~Scene() = default;

void Scene::Show(
  vtkImageData* volume, Mode mode, const std::vector<Surface>& surfaces, int kernel, int prefilter)
{
  const double* spacing = volume->GetSpacing();
  const double edge = std::cbrt(spacing[0] * spacing[1] * spacing[2]);
  if (vtkBCCLattice::IsBCC(volume))
  {
    const auto mapper = vtkSmartPointer<vtkBCCVolumeMapper>::New();
    mapper->SetKernel(kernel);
    mapper->SetPrefilter(prefilter);
    this->Mapper = mapper;
  }
  else
  {
    this->Mapper = vtkSmartPointer<vtkOpenGLGPUVolumeRayCastMapper>::New();
  }
  this->Mapper->SetInputData(volume);
  this->Mapper->AutoAdjustSampleDistancesOff();
  this->Mapper->SetSampleDistance(static_cast<float>(0.5 * edge));
  SetMode(this->Mapper, mode);

  double range[2];
  volume->GetScalarRange(range);
  vtkNew<vtkVolume> prop;
  prop->SetMapper(this->Mapper);
  prop->SetProperty(MakeAppearance(mode, surfaces, range[0], range[1], edge));
  this->Renderer->RemoveAllViewProps();
  this->Renderer->AddVolume(prop);
}

void Scene::LookFrom(const View& view)
{
  double box[6];
  std::copy_n(this->Mapper->GetBounds(), 6, box);
  SetCropping(this->Mapper, box, view.Crop);
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  camera->SetViewAngle(20.0);
  camera->SetFocalPoint(0.0, 0.0, 0.0);
  camera->SetPosition(view.From);
  camera->SetViewUp(view.Up);
  this->Renderer->ResetCamera(box);
  double shift[3];
  for (int a = 0; a < 3; ++a)
  {
    const double* side = box + 2 * a;
    shift[a] = (view.Focus[a] - 0.5) * (side[1] - side[0]);
  }
  double* eye = camera->GetPosition();
  camera->SetPosition(eye[0] + shift[0], eye[1] + shift[1], eye[2] + shift[2]);
  double* focus = camera->GetFocalPoint();
  camera->SetFocalPoint(focus[0] + shift[0], focus[1] + shift[1], focus[2] + shift[2]);
  camera->Zoom(view.Zoom);
  this->Renderer->ResetCameraClippingRange(box);
}

void Scene::SetLabel(const std::string& text)
{
  const int height = this->Window->GetSize()[1];
  vtkTextProperty* style = this->Label->GetTextProperty();
  style->SetFontFamilyToArial();
  style->SetFontSize(std::max(8, height / 27));
  style->SetColor(0.85, 0.88, 0.92);
  this->Label->SetPosition(height / 40.0, height / 40.0);
  this->Label->SetInput(text.c_str());
  this->Renderer->AddViewProp(this->Label);
}

double Scene::Time()
{
  const int width = this->Window->GetSize()[0];
  const int height = this->Window->GetSize()[1];
  this->Window->SetSize(std::max(1, width / 16), std::max(1, height / 16));
  this->Window->Render();
  this->Window->SetSize(width, height);
  this->Window->WaitForCompletion();
  const auto begin = std::chrono::steady_clock::now();
  this->Window->Render();
  this->Window->WaitForCompletion();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

vtkSmartPointer<vtkImageData> Scene::Grab()
{
  vtkNew<vtkWindowToImageFilter> grabber;
  grabber->SetInput(this->Window);
  grabber->ReadFrontBufferOff();
  grabber->ShouldRerenderOff();
  grabber->Update();
  return grabber->GetOutput();
}

vtkRenderWindow* Scene::GetWindow()
{
  return this->Window;
}

vtkGPUVolumeRayCastMapper* Scene::GetMapper()
{
  return this->Mapper;
}

void Scene::Interact(const std::string& title)
{
  vtkNew<vtkRenderWindowInteractor> interactor;
  vtkNew<vtkInteractorStyleTrackballCamera> style;
  interactor->SetInteractorStyle(style);
  interactor->SetRenderWindow(this->Window);
  this->Window->SetWindowName(title.c_str());
  this->Window->Render();
  interactor->Start();
}

bool WritePicture(vtkImageData* picture, const std::string& path)
{
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputData(picture);
  writer->SetCompressionLevel(9);
  writer->SetFileName(path.c_str());
  writer->Write();
  return writer->GetErrorCode() == 0;
}
