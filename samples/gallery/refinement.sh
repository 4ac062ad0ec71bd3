#!/usr/bin/env bash
# samples/gallery/refinement.sh: draws samples/gallery/refinement.png: a groove on a box of 12 triangles, and
# lettering on a plate with round corners of 204 triangles, both split where the strokes need it.
set -euo pipefail
cd "$(dirname -- "${BASH_SOURCE[0]}")/../.."

burin=build/release/bin/burin
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

printf '%s\n' 'v 0 0 0' 'v 2 0 0' 'v 2 1 0' 'v 0 1 0' 'v 0 0 1' 'v 2 0 1' 'v 2 1 1' 'v 0 1 1' \
  'f 1 4 3 2' 'f 5 6 7 8' 'f 1 2 6 5' 'f 2 3 7 6' 'f 3 4 8 7' 'f 4 1 5 8' >"$work/box.obj"

# Two polygons of 52 corners and the sides between them.
awk 'BEGIN {
  n = 52
  for (z = 0; z < 2; ++z) for (i = 0; i < n; ++i) {
    corner = int(i / 13); a = (corner - 1 + i % 13 / 12) * 1.570796
    x = corner < 2 ? 1.7 : .3; y = corner == 1 || corner == 2 ? .7 : .3
    printf "v %.6f %.6f %g\n", x + .3 * cos(a), y + .3 * sin(a), .4 * z
  }
  printf "f"; for (i = n; i > 0; --i) printf " %d", i; print ""
  printf "f"; for (i = 1; i <= n; ++i) printf " %d", n + i; print ""
  for (i = 1; i <= n; ++i) { j = i % n + 1; print "f", i, j, n + j, n + i }
}' >"$work/plate.obj"

# stroke BRUSH RADIUS X,Y,Z...: straight from place to place.
stroke() {
  printf '{"burin_stroke":1,"space":"object"}\n{"begin":{"brush":"org.burin.%s","radius":0%s},"fields":["x","y","z"]}\n' "$1" "$2"
  shift 2
  printf '%s\n' "$@" | awk -F, 'NR > 1 { for (i = 0; i < 40; ++i) { s = i / 40
    printf "[%.6f,%.6f,%.6f]\n", x + s * ($1 - x), y + s * ($2 - y), z + s * ($3 - z) } }
    { x = $1; y = $2; z = $3 } END { printf "[%.6f,%.6f,%.6f]\n{\"end\":true}\n", x, y, z }'
}
stroke groove .15 1,.3,1 1.6,.3,1 2,.55,1 2,.75,.6 2,1,.5 1.3,1,.4 >"$work/groove.stroke"
stroke text .22 .3,.5,.4 1.7,.5,.4 >"$work/text.stroke"

size=(--width 640 --height 480)
"$burin" replay "$work/groove.stroke" --mesh "$work/box.obj" --refine auto --param depth=.3 --view=-1,-.7,-.8 "${size[@]}" --png "$work/1.png"
"$burin" replay "$work/text.stroke" --mesh "$work/plate.obj" --refine edge:.004 --param text=Burin --param size=1.5 \
  --view=.1,.3,-1 "${size[@]}" --png "$work/2.png"
oiiotool "$work/1.png" "$work/2.png" --mosaic 2x1 -o samples/gallery/refinement.png
