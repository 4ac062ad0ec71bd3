#!/usr/bin/env bash
# Draws a picture of each stock brush into this folder: ./dev gallery [BRUSH...]
# With names, these alone. Run at the root of the sources, after a build.
set -euo pipefail

burin=build/release/bin/burin
wanted=("$@")

is_wanted() {
  [ ${#wanted[@]} -gt 0 ] || return 0
  local name
  for name in "${wanted[@]}"; do [ "$name" != "$1" ] || return 0; done
  return 1
}

# picture BRUSH STROKE [OPTION...]: the sample stroke drawn with org.burin.BRUSH and options of `burin replay`.
picture() {
  local brush=$1 stroke=$2
  shift 2
  is_wanted "$brush" || return 0
  printf '%s\n' "$brush"
  "$burin" replay "samples/strokes/$stroke.stroke" --brush "org.burin.$brush" --radius .1 \
    --mesh samples/meshes/ewer.obj --subdivide 6 --show-every 0 --view 0,-.15,-1 --fov 25 \
    --width 640 --height 480 --png "samples/gallery/$brush.png" "$@" >/dev/null
}

picture groove wave
picture crease wave
picture bead wave
picture rope wave
picture stitches wave
picture pinch wave
