# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause

# Mappers and textures, one class a line.
set(BRAVAIS_RENDERING
)

# Shader files of GLSL/, one <Name> a line for GLSL/<Name>.glsl.
set(BRAVAIS_SHADERS
)
