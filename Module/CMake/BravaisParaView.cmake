# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause

# ParaView's plugin, of the modules that BravaisBuild.cmake has built against ParaView's VTK.

paraview_plugin_scan(
  PLUGIN_FILES "${CMAKE_CURRENT_SOURCE_DIR}/Module/ParaView/Plugin/paraview.plugin"
  PROVIDES_PLUGINS bravais_plugins
  ENABLE_BY_DEFAULT ON
  HIDE_PLUGINS_FROM_CACHE ON)
paraview_plugin_build(
  PLUGINS ${bravais_plugins}
  LIBRARY_SUBDIRECTORY paraview-5.11/plugins
  DISABLE_XML_DOCUMENTATION ON)
