#!/bin/sh
# Draws the pictures of charts in docs/concepts.md: charts.sh BURIN
set -e
burin=$(realpath "$1")
docs=$(realpath "$(dirname "$0")/..")
folder=$(mktemp -d)
trap 'rm -r "$folder"' EXIT
cd "$folder"
printf 'v -1.5 -0.75 0\nv 1.5 -0.75 0\nv 1.5 0.75 0\nv -1.5 0.75 0\nt interpolateboundary 1/0/0 1\nf 1 2 3 4\n' >plane.obj

# draw NAME X,Y...: the chart of a stroke through the points, on the plane from above.
draw() {
  name=$1
  shift
  {
    echo '{"burin_stroke": 1, "space": "object"}'
    echo '{"begin": {"brush": "org.burin.groove", "radius": 0.22}, "fields": ["x", "y", "z"]}'
    printf '[%s, 0]\n' "$@"
    echo '{"end": true}'
  } >"$name.stroke"
  "$burin" chart "$name.stroke" --mesh plane.obj --subdivide 8 --view 0,0,-1 --up 0,1,0 --width 800 --height 400 \
    --png "$docs/$name.png"
}

# shellcheck disable=SC2046  # words are points
draw chart_shapes $(awk 'BEGIN {
  for (i = 0; i <= 20; i++) printf "%g,%g ", -1.15 + 0.04 * i, -0.4 + 0.04 * i
  for (i = 1; i <= 20; i++) printf "%g,%g ", -0.35 + 0.03 * i, 0.4 - 0.04 * i
  for (i = 1; i <= 40; i++) { a = -1.5708 + i * 0.09; printf "%g,%g ", 0.55 + 0.42 * cos(a), 0.02 + 0.42 * sin(a) }
}')
# shellcheck disable=SC2046
draw chart_sheets $(awk 'BEGIN {
  for (i = 0; i <= 120; i++) { s = -1.8 + 3.6 * i / 120; printf "%g,%g ", 0.42 * (s * s * s - 1.8 * s), 0.42 - 0.27 * s * s }
}')
