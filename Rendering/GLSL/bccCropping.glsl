// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause

// Regions of cropping, whose planes lie along the axes of the volume's own system. VTK would have
// them lie along those of texture coordinates, which turn with the image's direction matrix.

uniform float in_bccCroppingPlanes[6]; // from the texture coordinates' origin

// In the place of computeRegion(croppingPlanesTexture, texturePosition).
int BCCRegion(vec3 texturePosition)
{
  return computeRegion(in_bccCroppingPlanes, mat3(in_textureDatasetMatrix[0]) * texturePosition);
}
