// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PieceRequest.h"

#include "vtkDataObject.h"
#include "vtkExtentTranslator.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationIntegerRequestKey.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>

namespace bravais
{

using Pipeline = vtkStreamingDemandDrivenPipeline;

//------------------------------------------------------------------------------
bool IsPiece(vtkInformation* output)
{
  return Pipeline::GetUpdateNumberOfPieces(output) > 1;
}

//------------------------------------------------------------------------------
void GetPieceExtent(vtkInformation* output, int extent[6])
{
  Pipeline::GetUpdateExtent(output, extent);
  if (!IsPiece(output))
  {
    return;
  }
  // As vtkStreamingDemandDrivenPipeline does before it calls RequestData.
  const int mode = output->Has(vtkExtentTranslator::UPDATE_SPLIT_MODE())
    ? output->Get(vtkExtentTranslator::UPDATE_SPLIT_MODE())
    : static_cast<int>(vtkExtentTranslator::BLOCK_MODE);
  int whole[6];
  std::copy_n(extent, 6, whole);
  vtkNew<vtkExtentTranslator> translator;
  translator->PieceToExtentThreadSafe(Pipeline::GetUpdatePiece(output),
    Pipeline::GetUpdateNumberOfPieces(output), Pipeline::GetUpdateGhostLevel(output), whole, extent,
    mode, 0);
}

//------------------------------------------------------------------------------
void RequestExtent(vtkInformation* input, const int extent[6])
{
  input->Set(Pipeline::UPDATE_EXTENT(), extent, 6);
  input->Set(Pipeline::UPDATE_PIECE_NUMBER(), 0);
  input->Set(Pipeline::UPDATE_NUMBER_OF_PIECES(), 1);
  input->Set(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
}

//------------------------------------------------------------------------------
void RequestWholeExtent(vtkInformation* input)
{
  int whole[6] = { 0, -1, 0, -1, 0, -1 };
  input->Get(Pipeline::WHOLE_EXTENT(), whole);
  RequestExtent(input, whole);
}

//------------------------------------------------------------------------------
void RefuseInformation(vtkInformationVector* outputs)
{
  vtkDataObject* output = vtkDataObject::GetData(outputs);
  if (vtkImageData::SafeDownCast(output))
  {
    const int nothing[6] = { 0, -1, 0, -1, 0, -1 };
    outputs->GetInformationObject(0)->Set(Pipeline::WHOLE_EXTENT(), nothing, 6);
  }
  if (output)
  {
    output->Initialize();
  }
}

} // namespace bravais
