#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Builds with warnings as errors and runs every test. Installs the packages it needs.
#
#   ./test.sh            everything
#   ./test.sh paraview   the plugin, in ParaView itself: the last stage of everything
#   ./test.sh sanitize   the core and filter tests under AddressSanitizer and
#                        UndefinedBehaviorSanitizer
set -euo pipefail
cd "$(dirname "$0")"
source Module/CMake/shell.sh

# Builds a preset and runs its tests.
run() {
  bravais_build "$1"
  bravais_say "Testing ($1)"
  ctest --preset "$1" --parallel "$(nproc)"
}

bravais_install_packages
bravais_start_display
case "${1-}" in
  "")
    run strict
    bravais_fetch_paraview
    run paraview
    ;;
  paraview)
    bravais_fetch_paraview
    run paraview
    ;;
  sanitize) run sanitize ;;
  *)
    echo "Usage: $0 [paraview|sanitize]" >&2
    exit 2
    ;;
esac
