# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause

# One Debian package of library, headers and Python package, for /usr. package.sh makes it; cpack in
# any build folder does.

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME bravais)
set(CPACK_PACKAGE_CONTACT "The Bravais authors <bravais@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY
  "VTK module for lattices other than the Cartesian grid")
set(CPACK_PACKAGE_DESCRIPTION
  "Sampling, reconstruction and rendering on body-centred cubic and rank-1 lattices, geometry
images with locality masks, and ordered dithering, for VTK in C++ and Python.")
set(CPACK_RESOURCE_FILE_LICENSE "${CMAKE_CURRENT_SOURCE_DIR}/LICENSE")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION libs)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON) # the libraries that it is linked to, found by dpkg-shlibdeps
set(CPACK_DEBIAN_PACKAGE_DEPENDS "python3-numpy, python3-vtk9")
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "libglm-dev, libvtk9-dev") # for find_package(Bravais)
install(FILES LICENSE DESTINATION share/doc/bravais RENAME copyright)
include(CPack)
