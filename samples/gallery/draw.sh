#!/usr/bin/env bash
# Draws a picture of each stock brush into this folder: ./dev gallery [BRUSH...]; with names these alone.
set -euo pipefail
cd "$(dirname -- "${BASH_SOURCE[0]}")/../.."

burin=build/release/bin/burin
wanted=" $* "
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

replay() { "$burin" replay "$@" --show-every 0 >/dev/null; }

# picture BRUSH STROKE [OPTION...]: the sample stroke drawn with org.burin.BRUSH and options of `burin replay`
# on the surface that `surface` names.
surface=(--mesh samples/meshes/ewer.obj --subdivide 6)
picture() {
  local brush=$1 stroke=samples/strokes/$2.stroke
  shift 2
  [[ "$wanted" = "  " || "$wanted" = *" $brush "* ]] || return 0
  printf '%s\n' "$brush"
  replay "$stroke" --brush "org.burin.$brush" "${surface[@]}" --png "samples/gallery/$brush.png" \
    --view 0,-.15,-1 --fov 12 --width 520 --height 390 "$@"
}

picture bark wave --radius .14
picture bead wave --radius .11 --param form=beads
picture crease wave --radius .16
picture groove wave --radius .16 --param width=.6
picture rope wave --radius .12
picture scales wave --radius .16 --param stamp=samples/stamps/scales.exr
picture stitches wave --radius .11 --param length=1.7

# under STROKE OPTION...: a surface with something on it, for brushes that change what is there.
under() {
  local stroke=samples/strokes/$1.stroke
  shift
  replay "$stroke" --mesh samples/meshes/ewer.obj --subdivide 6 --save-mesh "$work/under.ply" "$@"
  surface=(--mesh "$work/under.ply")
}

under wave --radius .2 --brush org.burin.groove --param depth=-.15
picture pinch wave --radius .15 --param amount=1 --param lift=.1

under wave --radius .18 --brush org.burin.scales --param stamp=samples/stamps/scales.exr
picture flatten wave --radius .12
picture smooth wave --radius .12 --param passes=60
