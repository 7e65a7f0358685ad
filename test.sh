#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Builds with warnings as errors and runs every test. Installs the packages it needs.
#
#   ./test.sh            everything
#   ./test.sh sanitize   the core and filter tests under AddressSanitizer and
#                        UndefinedBehaviorSanitizer
set -euo pipefail
cd "$(dirname "$0")"
source Module/CMake/shell.sh

case "${1-}" in
  "") preset=strict ;;
  sanitize) preset=sanitize ;;
  *)
    echo "Usage: $0 [sanitize]" >&2
    exit 2
    ;;
esac

bravais_install_packages
bravais_build "$preset"
bravais_start_display
bravais_say "Testing ($preset)"
ctest --preset "$preset" --parallel "$(nproc)"
