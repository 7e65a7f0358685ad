// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkBCCPictureState.h"

#include "vtkBCCShaderCheck.h"

#include "vtkColorTransferFunction.h"
#include "vtkGPUVolumeRayCastMapper.h"
#include "vtkImageData.h"
#include "vtkImplicitFunction.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkMatrix3x3.h"
#include "vtkMatrix4x4.h"
#include "vtkOpenGLCamera.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkRenderer.h"
#include "vtkShaderProperty.h"
#include "vtkUniforms.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <initializer_list>

namespace
{

class Collector
{
public:
  std::vector<double> Values;

  void Add(std::initializer_list<double> values)
  {
    this->Values.insert(this->Values.end(), values);
  }
  void Add(const double* values, int count)
  {
    this->Values.insert(this->Values.end(), values, values + count);
  }
  void AddTime(vtkObject* object)
  {
    this->Add({ object ? static_cast<double>(object->GetMTime()) : -1.0 });
  }
};

void AddCamera(Collector& state, vtkRenderer* renderer)
{
  auto* camera = vtkOpenGLCamera::SafeDownCast(renderer->GetActiveCamera());
  vtkMatrix4x4* worldToView = nullptr;
  vtkMatrix4x4* viewToClip = nullptr;
  vtkMatrix4x4* worldToClip = nullptr;
  vtkMatrix3x3* normals = nullptr;
  camera->GetKeyMatrices(renderer, worldToView, normals, viewToClip, worldToClip);
  state.Add(worldToView->GetData(), 16);
  state.Add(viewToClip->GetData(), 16);
  state.Add(camera->GetPosition(), 3);
  state.Add(camera->GetDirectionOfProjection(), 3);
  state.Add(camera->GetClippingRange(), 2);
  state.Add({ static_cast<double>(camera->GetParallelProjection()) });
}

void AddLights(Collector& state, vtkRenderer* renderer)
{
  state.Add({ static_cast<double>(renderer->GetTwoSidedLighting()) });
  vtkLightCollection* lights = renderer->GetLights();
  vtkCollectionSimpleIterator iterator;
  lights->InitTraversal(iterator);
  while (vtkLight* light = lights->GetNextLight(iterator))
  {
    double position[3];
    double focus[3];
    light->GetTransformedPosition(position);
    light->GetTransformedFocalPoint(focus);
    state.Add(position, 3);
    state.Add(focus, 3);
    state.Add(light->GetAmbientColor(), 3);
    state.Add(light->GetDiffuseColor(), 3);
    state.Add(light->GetSpecularColor(), 3);
    state.Add(light->GetAttenuationValues(), 3);
    state.Add({ light->GetIntensity(), light->GetConeAngle(), light->GetExponent(),
      static_cast<double>(light->GetSwitch()), static_cast<double>(light->GetPositional()),
      static_cast<double>(light->GetLightType()) });
  }
}

// VTK's time of a property leaves out what slices and label maps are given.
void AddProperty(Collector& state, vtkVolumeProperty* property)
{
  state.AddTime(property);
  state.AddTime(property->GetSliceFunction());
  for (int label : property->GetLabelMapLabels())
  {
    state.AddTime(property->GetLabelScalarOpacity(label));
    state.AddTime(property->GetLabelGradientOpacity(label));
    state.AddTime(property->GetLabelColor(label));
  }
}

void AddMapper(Collector& state, vtkGPUVolumeRayCastMapper* mapper)
{
  state.AddTime(mapper);
  state.AddTime(mapper->GetMaskInput());
  if (vtkPlaneCollection* planes = mapper->GetClippingPlanes())
  {
    vtkCollectionSimpleIterator iterator;
    planes->InitTraversal(iterator);
    while (vtkPlane* plane = planes->GetNextPlane(iterator))
    {
      state.AddTime(plane);
    }
  }
}

}

//------------------------------------------------------------------------------
std::vector<double> vtkBCCPictureState::Get(
  vtkRenderer* renderer, vtkVolume* volume, vtkGPUVolumeRayCastMapper* mapper)
{
  Collector state;
  AddCamera(state, renderer);
  AddLights(state, renderer);
  AddMapper(state, mapper);
  AddProperty(state, volume->GetProperty());
  state.Add(volume->GetMatrix()->GetData(), 16);
  // Its time does not tell when replacements are cleared.
  state.Add({ static_cast<double>(vtkBCCShaderCheck::GetHash(volume)) });
  vtkShaderProperty* shader = volume->GetShaderProperty();
  state.Add({ static_cast<double>(shader->GetShaderMTime()) });
  state.AddTime(shader->GetVertexCustomUniforms());
  state.AddTime(shader->GetFragmentCustomUniforms());
  return state.Values;
}
