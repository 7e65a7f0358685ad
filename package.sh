#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Makes a Debian package of the library, its headers and the Python package, and says where it is.
# Installs the packages it needs.
set -euo pipefail
cd "$(dirname "$0")"
source Module/CMake/shell.sh

bravais_install_packages
bravais_build release
bravais_say "Packaging"
(cd build/release && cpack)
