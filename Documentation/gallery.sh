#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Makes the pictures of gallery.md anew, by running the commands that stand there.
set -euo pipefail
cd "$(dirname "$0")/.."
source Module/CMake/shell.sh
source Examples/data.sh

bravais_install_packages
bravais_build release -DBRAVAIS_BUILD_TESTING=OFF
build=$PWD/build/release
HEAD_MRI=$(bravais_fetch_brain "$build/data")
BRAIN_MRI=${HEAD_MRI/ch2/ch2bet}
PICTURES=$build/pictures
BUNNY=$(bravais_fetch_bunny "$build/data")
export HEAD_MRI BRAIN_MRI PICTURES BUNNY
export PATH=$build/bin:$PWD/Examples/Python:/usr/bin:$PATH
export PYTHONPATH=$build/lib/python3/dist-packages PYTHONDONTWRITEBYTECODE=1
bravais_start_display
cd Documentation
sed -n '/^```sh$/,/^```$/p' gallery.md | sed '/^```/d' | bash -euxo pipefail
