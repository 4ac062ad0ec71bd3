#!/usr/bin/env bash
# samples/gallery/scans.sh FOLDER: draws rope, scales, text, beads and solids over rough surfaces into
# samples/gallery/scans: three scans and a figure from FOLDER, which is not part of the project, and a furry ring,
# which this script makes.
set -euo pipefail
cd "$(dirname -- "${BASH_SOURCE[0]}")/../.."

data=${1:?usage: samples/gallery/scans.sh FOLDER, with colin27_head_t1_iso40_1mm.ply.xz and others}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# Writes a ring whose hairs and tufts are noise stretched along it, as ASCII PLY.
fur() {
  awk -v m=1000 -v n=420 '
    function hash(i, j, k) { k = sin(i * 127.1 + j * 311.7) * 43758.5453; return k - int(k) + (k < 0) }
    function smooth(x) { return x * x * (3 - 2 * x) }
    function wrap(i, n) { return ((i % n) + n) % n }
    function row(i, j, a, nx, ny) {
      return hash(wrap(i, nx), wrap(j, ny)) * (1 - a) + hash(wrap(i + 1, nx), wrap(j, ny)) * a
    }
    function noise(x, y, nx, ny, i, j, a, b) {
      i = int(x); j = int(y); a = smooth(x - i); b = smooth(y - j)
      return row(i, j, a, nx, ny) * (1 - b) + row(i, j + 1, a, nx, ny) * b
    }
    BEGIN {
      tau = 6.283185307179586
      print "ply\nformat ascii 1.0\nelement vertex " m * n
      print "property float x\nproperty float y\nproperty float z"
      print "element face " m * n "\nproperty list uchar int vertex_indices\nend_header"
      for (i = 0; i < m; ++i) for (j = 0; j < n; ++j) {
        u = i / m; v = j / n
        hair = noise(u * 60 + 60, v * 150 + 1.5 * sin(tau * u * 5) + 150, 60, 150)
        r = .42 + .035 * hair * hair + .03 * noise(u * 40 + 40, v * 25 + 25, 40, 25)
        printf "%.5f %.5f %.5f\n", (1 + r * cos(tau * v)) * cos(tau * u), (1 + r * cos(tau * v)) * sin(tau * u),
               r * sin(tau * v)
      }
      for (i = 0; i < m; ++i) for (j = 0; j < n; ++j) {
        a = (i + 1) % m; b = (j + 1) % n
        print 4, i * n + j, a * n + j, a * n + b, i * n + b
      }
    }'
}

# draw BRUSH PARAMS SOLID NAME MESH SUBDIVIDE RADIUS RADII FROM TOWARDS: draws a straight stroke on one surface.
draw() {
  local brush=$1 params=$2 solid=$3 name=$4 mesh=$5 subdivide=$6 radius=$7 radii=$8 from=$9 towards=${10}
  printf '%s on %s\n' "$brush" "$name"
  cat >"$work/suite.json" <<JSON
{"burin_suite": 1, "name": "scans", "cases": [{"name": "$brush on $name", "mesh": "$mesh", "subdivide": $subdivide,
  "brush": "org.burin.$brush", "params": $params, "solid": "$solid", "radius": $radius, "show_every": 0, "repeat": 1,
  "stroke": {"samples": 200, "from": [$from], "towards": [$towards], "length_radii": $radii}}]}
JSON
  build/release/bin/burin bench "$work/suite.json" --case "$brush on $name" \
    --picture "samples/gallery/scans/${brush}_$name.png" >/dev/null
}

# pictures NAME MESH SUBDIVIDE RADIUS RADII FROM TOWARDS: the same with four brushes that displace.
pictures() {
  draw rope '{}' none "$@"
  draw scales "{\"stamp\": \"$PWD/samples/stamps/scales.exr\"}" none "$@"
  draw text '{"text": "Engraver", "size": 1.6, "height": 0.2, "bevel": 0.05}' none "$@"
  draw bead '{"form": "beads"}' none "$@"
}

for scan in colin27_head_t1_iso40_1mm.ply dragon_vrip.ply nefertiti-lowres.obj; do
  xz -dkc "$data/$scan.xz" >"$work/$scan"
done
fur >"$work/fur.ply"
pictures head "$work/colin27_head_t1_iso40_1mm.ply" 0 11 14 '45, 205, 120' '140, 205, 125'
pictures dragon "$work/dragon_vrip.ply" 0 0.006 9 '-0.02, 0.09, 0.04' '0.05, 0.1, 0.04'
pictures nefertiti "$work/nefertiti-lowres.obj" 2 18 12 '-90, 140, 60' '90, 170, 60'
pictures fur "$work/fur.ply" 0 0.14 9 '-0.7, 0.75, 0.5' '0.7, 0.75, 0.5'

draw chain '{}' union nefertiti "$work/nefertiti-lowres.obj" 2 18 14 '-90, 215, 60' '90, 215, 40'
draw carve '{}' difference dragon "$work/dragon_vrip.ply" 0 0.005 9 '-0.01, 0.1, 0.04' '0.04, 0.09, 0.04'
draw tube '{"height": 0.5}' union head "$work/colin27_head_t1_iso40_1mm.ply" 0 11 14 '45, 205, 120' '140, 205, 125'
printf 'spot along a stroke\n'
build/release/bin/burin replay samples/strokes/wave.stroke --mesh samples/meshes/ewer.obj --subdivide 5 --radius .14 \
  --along-mesh "$data/spot_triangulated.obj" --png samples/gallery/scans/spot_along_ewer.png >/dev/null
