#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
#
#   install_debian.sh <build folder> <scratch root>
#
# Makes the Debian package of a build, looks whether it names what it needs, and unpacks it into an
# empty scratch root.
set -euo pipefail
build=$1 root=$2

rm -rf "$root" "$root.packages"
(cd "$build" && cpack -G DEB -B "$root.packages")
package=$(echo "$root.packages"/*.deb)
for needed in libvtk9.1 python3-vtk9 python3-numpy; do
  if ! dpkg-deb --field "$package" Depends | grep -q "$needed"; then
    echo "The package does not depend on $needed." >&2
    exit 1
  fi
done
dpkg-deb --extract "$package" "$root"
