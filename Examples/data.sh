# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
# shellcheck shell=bash
#
# Volumes, a mesh and a photograph that Debian's packages hold; sourced after Module/CMake/shell.sh
# from the project's root folder. The packages are unpacked into the build tree, not installed.
#
#   bravais_fetch_head <folder>    prints the path of a CT of a head, bravais_head_options its view
#   bravais_fetch_brain <folder>   the same of an MRI of a head (Colin 27)
#   bravais_fetch_bunny <folder>   that of a mesh, Stanford's bunny
#   bravais_fetch_portrait <folder>  that of a photograph of 512 x 512 pixels (NASA)
# All fail with a message if the file cannot be had or is not the expected one.

bravais_head_options=(--inner 300 --outer -300 --isolate -300 --from 0.6 1 0.2 --zoom 1.7
  --focus 0.5 0.54 0.48 --detail 0.6 0.85 0.24 --detail-zoom 6)
bravais_brain_options=(--inner 95 --outer 30 --isolate 25 --from 0.6 1 0.2 --zoom 1.2
  --detail 0.5 0.8 0.45 --detail-zoom 5)

bravais_has() {
  [ -f "$1" ] && echo "$2  $1" | sha256sum --check --status
}

# bravais_unpack <folder> <package> <file> <sha256>
bravais_unpack() {
  local folder=$1 package=$2 file=$3 sum=$4
  bravais_has "$folder/$file" "$sum" && return
  bravais_say "Fetching $package" >&2
  mkdir -p "$folder"
  if ! (cd "$folder" && rm -f "${package}"_*.deb &&
    apt-get -qq download "$package" 2>/dev/null && dpkg-deb -x "${package}"_*.deb . &&
    rm -f "${package}"_*.deb); then
    echo "The package $package cannot be had." >&2
    return 1
  fi
  if ! bravais_has "$folder/$file" "$sum"; then
    echo "$package: $file is not the expected one (SHA-256)." >&2
    return 1
  fi
}

bravais_fetch_head() {
  local project=usr/share/doc/invesalius-examples/examples/Cranium.inv3
  local matrix=d87fd5e6aaf2c4fdf4f3fe28ee3335192fc2464ed8e9682fc78530cb837938da
  if ! bravais_has "$1/cranium.raw" "$matrix"; then
    bravais_unpack "$1" invesalius-examples "$project" \
      3b34f11f7c4f557f4c65cd6543c412a2f6ceb0cfecfd9c41184420e02d9b7e2a &&
      /usr/bin/python3 Examples/Python/ConvertInVesalius.py "$1/$project" "$1/cranium.mhd" ||
      return 1
  fi
  bravais_has "$1/cranium.raw" "$matrix" && echo "$1/cranium.mhd"
}

bravais_fetch_brain() {
  local file=usr/share/mricron/templates/ch2.nii.gz
  bravais_unpack "$1" mricron-data "$file" \
    a009051127f64dc3dd554d5f5b589870ea72106d9642c21b4e7093e478cfc309 &&
    echo "$1/$file"
}

bravais_fetch_bunny() {
  local file=usr/share/glmark2/models/bunny.obj
  bravais_unpack "$1" glmark2-data "$file" \
    bff773d28c62e80187b2dfa8c6c8cc771a4c7707ddcdcf2e515913d322d1f548 &&
    echo "$1/$file"
}

bravais_fetch_portrait() {
  local file=usr/lib/python3/dist-packages/imageio/resources/images/astronaut.png
  bravais_unpack "$1" python3-imageio "$file" \
    b6d8f15b9103f9f9368608886d396d9ce92b10989aee1539a1e37dd1a415b9dd &&
    echo "$1/$file"
}
