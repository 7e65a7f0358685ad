#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Builds Bravais and draws a CT of a head on the BCC lattice, beside VTK's own mapper on a Cartesian
# grid. The pictures are in build/release/demo. Installs the packages it needs; no display needed.
#
#   ./demo.sh
set -euo pipefail
cd "$(dirname "$0")"
source Module/CMake/shell.sh
source Examples/data.sh

if [ $# -gt 0 ]; then
  echo "Usage: $0" >&2
  exit 2
fi

bravais_install_packages
bravais_build release -DBRAVAIS_BUILD_TESTING=OFF

build=$PWD/build/release
if path=$(bravais_fetch_head "$build/data"); then
  volume=("$path" "${bravais_head_options[@]}")
elif echo "There is no CT; trying an MRI instead." >&2 &&
  path=$(bravais_fetch_brain "$build/data"); then
  volume=("$path" "${bravais_brain_options[@]}")
else
  echo "There is no MRI either; drawing the generated Marschner-Lobb function alone." >&2
  volume=()
fi

bravais_start_display
bravais_say "Drawing"
"$build/bin/BCCDemo" "${volume[@]}" --output "$build/demo"
