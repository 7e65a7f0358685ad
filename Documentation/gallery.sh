#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Makes the pictures of the documentation anew: those of gallery.md by the Python that stands there,
# tutorial.md's likewise, and those of the other pages by the example programs. Takes the build that
# ./test.sh or ./demo.sh left, or makes one. Files come from Debian's packages, which are unpacked
# into the build folder and not installed. No display needed.
#
#   ./Documentation/gallery.sh [<folder>]       into a folder, by default Documentation
#   ./Documentation/gallery.sh --data <folder>  only the files that gallery.md's Python reads
set -euo pipefail
case "$#:${1-}" in
  0:) folder=$(dirname "$0") ;;
  2:--data) folder=$2 ;;
  1:-* | [!1]:*)
    echo "Usage: $0 [<folder> | --data <folder>]" >&2
    exit 2
    ;;
  *) folder=$1 ;;
esac
folder=$(realpath -m "$folder")
cd "$(dirname "$0")/.."
source Module/CMake/shell.sh
source Examples/data.sh

# fetch_data <unpacked> <folder>: what gallery.md names, out of packages that are unpacked elsewhere
fetch_data() {
  local head bunny portrait skull
  head=$(bravais_fetch_brain "$1")
  bunny=$(bravais_fetch_bunny "$1")
  portrait=$(bravais_fetch_portrait "$1")
  skull=$(bravais_fetch_head "$1")
  mkdir -p "$2"
  cp "$head" "$2/head.nii.gz"
  cp "${head/ch2/ch2bet}" "$2/brain.nii.gz"
  cp "$bunny" "$2/bunny.obj"
  cp "$portrait" "$2/portrait.png"
  cp "${skull%.mhd}.raw" "$2/skull.raw"
  sed 's/cranium.raw/skull.raw/' "$skull" >"$2/skull.mhd"
}

# run_blocks <page>: a page's blocks of Python in the current folder, all in one program after the
# other; each block of the gallery is a program of its own
run_blocks() {
  awk '/^```python$/ { ++n; on = 1; next } /^```$/ { on = 0 }
    on { print > sprintf("block-%02d.py", n) }' "$1"
  if [ "$(basename "$1")" = gallery.md ]; then
    local block
    for block in block-*.py; do
      /usr/bin/python3 "$block"
    done
  else
    cat block-*.py | /usr/bin/python3 -
  fi
  rm block-*.py
}

# draw_gallery <work> <folder>
draw_gallery() {
  bravais_say "Drawing the gallery"
  (cd "$1" && run_blocks "$documentation/gallery.md")
  mkdir -p "$2/gallery"
  local picture
  for picture in $(grep -o '](gallery/[a-z0-9-]*\.png)' "$documentation/gallery.md" | tr -d '])('); do
    cp "$1/$(basename "$picture")" "$2/$picture"
  done
}

# example <name> <argument>...
example() {
  /usr/bin/python3 "Examples/Python/$1.py" "${@:2}"
}

# draw_pages <work> <folder>
draw_pages() {
  bravais_say "Drawing the pictures of the other pages"
  (cd "$1" && run_blocks "$documentation/tutorial.md")
  cp "$1/head.png" "$2/tutorial.png"
  "$build/bin/BCCDemo" --output "$1/demo" --size 450
  cp "$1/demo/marschner-lobb.png" "$2"
  example BayerFigures "$2"
  example DitherPhotograph "$1" "$1/portrait.png"
  cp "$1/dither-photograph-color.png" "$2/dither-photograph.png"
  example DitherVolume "$1" --download
  cp "$1/dither-volume.png" "$2"
  example GeometryImageFlyThrough "$1" "$1/bunny.obj" --pictures 50
  cp "$1/geometry-image-fly-through-50.png" "$2/geometry-image-fly-through.png"
  example LocalityMaskSession "$2" "$1/bunny.obj"
  example ProgressiveViewer --size 260 --output "$2/progressive.png"
  example Rank1AgainstSquare "$1" --download
  cp "$1/rank1-against-square.png" "$2"
  example Rank1Lattices "$2"
  example Rank1LookUps "$1" "$1/portrait.png"
  cp "$1/rank1-look-ups.png" "$2"
  example TextureAliasing "$2"
}

bravais_install_packages
preset=release
[ -e build/release/build.ninja ] || [ ! -e build/strict/build.ninja ] || preset=strict
build=$PWD/build/$preset
if [ "${1-}" = --data ]; then
  fetch_data "$build/data" "$folder"
  exit
fi
[ -e "$build/build.ninja" ] || bravais_build "$preset" -DBRAVAIS_BUILD_TESTING=OFF
cmake --build --preset "$preset" --parallel "$(nproc)" >/dev/null
documentation=$PWD/Documentation
export PYTHONPATH=$build/lib/python3/dist-packages PYTHONDONTWRITEBYTECODE=1
fetch_data "$build/data" "$build/gallery"
ln -sfn ../data "$build/gallery/data" # where the examples look for what is there already
bravais_start_display
mkdir -p "$folder"
draw_gallery "$build/gallery" "$folder"
draw_pages "$build/gallery" "$folder"
bravais_say "Pictures: $folder"
