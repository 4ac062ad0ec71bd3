#!/usr/bin/env bash
# samples/gallery/handwriting.sh RECORDINGS PICTURES: draws each recording of a folder (which is not part of the
# project) with eight of the stock brushes, and writes a sheet of pictures per recording to the other folder.
set -euo pipefail
cd "$(dirname -- "${BASH_SOURCE[0]}")/../.."

recordings=${1:?usage: samples/gallery/handwriting.sh RECORDINGS PICTURES}
pictures=${2:?usage: samples/gallery/handwriting.sh RECORDINGS PICTURES}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir -p "$pictures"

burin=build/release/bin/burin
printf '%s\n' 'v -1 -.75 0' 'v 1 -.75 0' 'v 1 .75 0' 'v -1 .75 0' 'f 1 2 3 4' >"$work/sheet.obj"
surface=(--mesh "$work/sheet.obj" --subdivide 9)

# picture RECORDING RADIUS BRUSH [OPTION...]: draws all strokes of the recording.
picture() {
  local recording=$1 radius=$2 brush=$3
  shift 3
  printf '%s of %s\n' "$brush" "$recording"
  "$burin" replay "$work/$recording.stroke" "${surface[@]}" --radius "$radius" --brush "org.burin.$brush" \
    --show-every 0 --view 0,0,-1 --width 800 --height 600 --png "$work/${recording}_$brush.png" "$@" >/dev/null
}

for recording in bdalab_signal.svc bdalab_html5_pointer_signal.json painting30sec.dat; do
  name=${recording%.*}
  "$burin" import "$recordings/$recording" "${surface[@]}" --view 0,0,-1 --out "$work/$name.stroke" >/dev/null
  picture "$name" .03 groove
  picture "$name" .03 crease
  picture "$name" .03 bead
  picture "$name" .03 rope
  picture "$name" .03 stitches
  picture "$name" .03 bark
  picture "$name" .03 scales --param stamp=samples/stamps/scales.exr
  picture "$name" .03 dashed-line --param colour=.04,.12,.3,1
  oiiotool "$work/${name}"_{groove,crease,bead,rope,stitches,bark,scales,dashed-line}.png --mosaic 4x2 \
    --resize 1600x600 -o "$pictures/$name.png"
done
