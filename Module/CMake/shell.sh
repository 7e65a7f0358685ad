# SPDX-FileCopyrightText: Copyright (c) The Bravais authors
# SPDX-License-Identifier: BSD-3-Clause
# shellcheck shell=bash
#
# What demo.sh and test.sh share; sourced by them from the project's root folder.
#
#   bravais_install_packages [<package>...]  packages.txt and the named ones, those that are missing
#   bravais_fetch_paraview                   ParaView, unpacked into build/paraview-packages
#   bravais_start_display                    an X server of its own, stopped when the script ends
#   bravais_build <preset> [<option>...]     configure and build a preset on all processors

bravais_say() {
  printf '\n-- %s\n' "$*"
}

bravais_as_root() {
  if [ "$(id -u)" -eq 0 ]; then
    "$@"
  elif command -v sudo >/dev/null; then
    sudo "$@"
  else
    echo "Installing packages needs root or sudo: $*" >&2
    return 1
  fi
}

bravais_install_packages() {
  local wanted missing=() package
  mapfile -t wanted <Module/CMake/packages.txt
  for package in "${wanted[@]}" "$@"; do
    [ "$(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null)" = installed ] ||
      missing+=("$package")
  done
  if [ "${#missing[@]}" -gt 0 ]; then
    bravais_say "Installing ${missing[*]}"
    bravais_as_root env DEBIAN_FRONTEND=noninteractive apt-get -qq update
    bravais_as_root env DEBIAN_FRONTEND=noninteractive apt-get -qq install -y \
      --no-install-recommends "${missing[@]}" >/dev/null
  fi
}

# ParaView's Python package conflicts with VTK's, so that both cannot be installed: ParaView is only
# unpacked, beside the libraries and Qt headers that it and its CMake package need.
bravais_fetch_paraview() {
  local packages wanted
  packages=$PWD/build/paraview-packages
  mapfile -t wanted <Module/ParaView/packages.txt
  bravais_install_packages "${wanted[@]}"
  [ -e "$packages/complete" ] && return
  bravais_say "Fetching ParaView into $packages"
  rm -rf "$packages"
  mkdir -p "$packages/downloads"
  local names=(paraview paraview-dev python3-paraview mricron-data) # the last has an MRI of a brain
  (cd "$packages/downloads" &&
    { apt-get -qq download "${names[@]}" 2>/dev/null ||
      { bravais_as_root apt-get -qq update && apt-get -qq download "${names[@]}"; }; })
  local file
  for file in "$packages"/downloads/*.deb; do
    dpkg-deb --extract "$file" "$packages"
  done
  rm -r "$packages/downloads"
  touch "$packages/complete"
}

# Rendering goes to Mesa's software renderer, so that the pictures are the same everywhere.
bravais_start_display() {
  local number
  number=$(mktemp)
  # Without -noreset the server starts anew whenever its last client leaves, and refuses the next.
  Xvfb -displayfd 3 -screen 0 1280x1024x24 -nolisten tcp -noreset 3>"$number" >/dev/null 2>&1 &
  # shellcheck disable=SC2064  # the process as it is now
  trap "kill $! 2>/dev/null; rm -f '$number'" EXIT
  for _ in $(seq 300); do
    [ -s "$number" ] && break
    sleep 0.1
  done
  if [ ! -s "$number" ]; then
    echo "Xvfb did not start within 30 seconds." >&2
    return 1
  fi
  DISPLAY=":$(cat "$number")"
  export DISPLAY LIBGL_ALWAYS_SOFTWARE=1
}

bravais_build() {
  local preset=$1
  shift
  if command -v ccache >/dev/null; then
    export CMAKE_C_COMPILER_LAUNCHER=ccache CMAKE_CXX_COMPILER_LAUNCHER=ccache
  fi
  bravais_say "Building ($preset)"
  cmake --preset "$preset" --log-level=WARNING "$@"
  cmake --build --preset "$preset" --parallel "$(nproc)"
}
