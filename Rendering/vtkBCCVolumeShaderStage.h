// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkBCCVolumeShaderStage
 * @brief   puts BCC splines into the shaders of VTK's volume ray caster
 *
 * VTK composes a ray caster's fragment shader from tags, before and after which it asks the
 * vtkOpenGLRenderPass objects in the volume's property keys. For the time of one rendering this
 * object is one of them. It
 * - replaces the tag of gradients, and those of isosurface blending when roots are refined;
 * - redirects the texture look-ups that VTK wrote to the spline;
 * - fills VTK's texture with the coefficients whenever VTK has made it anew, and sets uniforms.
 *
 * The coefficients on the GPU so belong to VTK's mapper, which releases them with its own
 * resources. The bricks are the stage's.
 */

#ifndef vtkBCCVolumeShaderStage_h
#define vtkBCCVolumeShaderStage_h

#include "vtkBCCBrickTexture.h"
#include "vtkBCCCoefficientBuffer.h"
#include "vtkBCCShaderCheck.h"
#include "vtkBCCShaderOptions.h"
#include "vtkBravaisABINamespace.h"

#include "vtkOpenGLRenderPass.h"
#include "vtkWeakPointer.h"

#include <memory>

VTK_ABI_NAMESPACE_BEGIN
class vtkBCCProgressiveFrame;
class vtkBCCVolumeInput;
class vtkGPUVolumeRayCastMapper;
class vtkMatrix4x4;
class vtkRenderer;
class vtkVolume;
class vtkVolumeTexture;

class vtkBCCVolumeShaderStage : public vtkOpenGLRenderPass
{
public:
  static vtkBCCVolumeShaderStage* New();
  vtkTypeMacro(vtkBCCVolumeShaderStage, vtkOpenGLRenderPass);

  /// Enters the property keys of the volume for one frame that shows this input.
  void Begin(vtkRenderer* renderer, vtkVolume* volume, const vtkBCCShaderOptions& options,
    vtkBCCVolumeInput& input);
  /// If it is to be traced pass by pass: where to. Ends with End().
  void SetTarget(vtkBCCProgressiveFrame* target) { this->Target = target; }
  /// Leaves them.
  void End();

  /// What the driver has said of the shader in use, if that does not compile.
  const std::string& GetShaderLog() const { return this->Check.Log; }

  /// Bytes that the bricks take on the GPU.
  vtkIdType GetBrickMemory() const { return this->Bricks.GetSize(); }

  /// Releases what VTK does not know of.
  void ReleaseGraphicsResources(vtkWindow* window) override;

  void Render(const vtkRenderState*) override {} // It is no pass of its own.
  bool PreReplaceShaderValues(std::string& vertex, std::string& geometry, std::string& fragment,
    vtkAbstractMapper* mapper, vtkProp* prop) override;
  bool PostReplaceShaderValues(std::string& vertex, std::string& geometry, std::string& fragment,
    vtkAbstractMapper* mapper, vtkProp* prop) override;
  bool SetShaderParameters(vtkShaderProgram* program, vtkAbstractMapper* mapper, vtkProp* prop,
    vtkOpenGLVertexArrayObject* array = nullptr) override;
  vtkMTimeType GetShaderStageMTime() override { return this->GetMTime(); }

protected:
  vtkBCCVolumeShaderStage();
  ~vtkBCCVolumeShaderStage() override;

private:
  vtkBCCVolumeShaderStage(const vtkBCCVolumeShaderStage&) = delete;
  void operator=(const vtkBCCVolumeShaderStage&) = delete;

  bool FillTexture(vtkVolumeTexture* texture);
  void SetCells(vtkVolumeTexture* texture) const;
  void SetRayUniforms(vtkShaderProgram* program, vtkMatrix4x4* textureToDataset);
  void SetVolumeUniforms(vtkShaderProgram* program, vtkGPUVolumeRayCastMapper* mapper);
  void SetPieceUniforms(vtkShaderProgram* program);
  void SetColorUniforms(vtkShaderProgram* program, const vtkVolumeTexture* texture) const;
  void SetCropping(vtkShaderProgram* program, vtkGPUVolumeRayCastMapper* mapper,
    vtkMatrix4x4* textureToDataset) const;

  vtkBCCShaderOptions Current;
  vtkRenderer* Renderer = nullptr;
  vtkVolume* Volume = nullptr;
  vtkBCCVolumeInput* Input = nullptr;
  vtkBCCBrickTexture Bricks;
  vtkBCCCoefficientBuffer Coefficients;
  float Normalizer = 1.0f; // of stored coefficients, where VTK takes values for colours, or 0
  vtkBCCShaderCheck Check;
  vtkBCCProgressiveFrame* Target = nullptr;

  struct DepthState;
  std::unique_ptr<DepthState> Saved;

  vtkWeakPointer<vtkVolumeTexture> Filled;
  vtkMTimeType FilledTime = 0;
};
VTK_ABI_NAMESPACE_END

#endif
// VTK-HeaderTest-Exclude: vtkBCCVolumeShaderStage.h
