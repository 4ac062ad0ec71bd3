#!/usr/bin/env bash
# ./dev gallery [BRUSH...]: draws a picture of each stock brush, or of the named ones, into this folder.
set -euo pipefail
cd "$(dirname -- "${BASH_SOURCE[0]}")/../.."

burin=build/release/bin/burin
wanted=" $* "
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

replay() { "$burin" replay "$@" --show-every 0 >/dev/null; }

is_wanted() { [[ "$wanted" = "  " || "$wanted" = *" $1 "* ]]; }

# picture BRUSH STROKE [OPTION...]: draws the sample stroke with org.burin.BRUSH and options of `burin replay`
# on the surface in the variable `surface`.
surface=(--mesh samples/meshes/ewer.obj --subdivide 6)
picture() {
  local brush=$1 stroke=samples/strokes/$2.stroke
  shift 2
  is_wanted "$brush" || return 0
  printf '%s\n' "$brush"
  replay "$stroke" --brush "org.burin.$brush" "${surface[@]}" --png "samples/gallery/${brush//-/_}.png" \
    --view 0,-.15,-1 --fov 12 --width 520 --height 390 "$@"
}

picture bark wave --radius .14
picture bead wave --radius .11 --param form=beads
picture crease wave --radius .16
picture groove wave --radius .16 --param width=.6
picture rope wave --radius .12
picture scales wave --radius .16 --param stamp=samples/stamps/scales.exr
picture stitches wave --radius .11 --param length=1.7
picture tread wave --radius .14 --param stamp=samples/stamps/tread.exr \
  --param start_stamp=samples/stamps/tread_start.exr --param end_stamp=samples/stamps/tread_end.exr --param fit=true
picture vdm-trail wave --radius .09 --param stamp=samples/stamps/thorn.exr --param gap=.2 --param flip=1 \
  --param angle=1.57
picture dashed-line wave --radius .14 --param colour=.04,.12,.3,1
picture patterned-line wave --radius .1 --param figure=chain --param spacing=2.6 --param width=.6 --param line=.5 \
  --param height=.18 --param bevel=.15
picture patterned-fill wave --radius .14 --param pattern=hexagons --param fill=.85 --param cell=.5 \
  --param height=.12 --param bevel=.08
picture arrow wave --radius .15 --param colour=.5,.03,.02,1
picture wave wave --radius .07 --param wavelength=2.6 --param amplitude=.5 --param width=.4 --param height=.25
picture text wave --radius .15 --param text=Engraver --param size=1.6 --param align=middle --param height=.12 \
  --param bevel=.05

picture tube wave --radius .12 --param wall=.35 --param ends=flat
picture cable wave --radius .12
picture chain wave --radius .14
picture screw wave --radius .12 --param pitch=.35
picture rivets wave --radius .1
picture carve wave --radius .14 --solid difference
picture zipper wave --radius .12
picture vdb-trail wave --radius .14 --param stamp=samples/solids/rail.vdb

if is_wanted along; then
  replay samples/strokes/wave.stroke --along-mesh samples/meshes/plait.obj --radius .1 "${surface[@]}" \
    --png samples/gallery/along.png --view 0,-.15,-1 --fov 12 --width 520 --height 390
fi

# under OPTION...: sets `surface` to one with relief, for brushes that change the existing surface.
under() {
  replay samples/strokes/wave.stroke --mesh samples/meshes/ewer.obj --subdivide 6 \
    --save-mesh "$work/under.ply" "$@"
  surface=(--mesh "$work/under.ply")
}

if is_wanted pinch; then
  under --brush org.burin.groove --param depth=-.15 --radius .2
  picture pinch wave --radius .15 --param amount=1 --param lift=.1
fi
if is_wanted flatten || is_wanted smooth; then
  under --brush org.burin.scales --param stamp=samples/stamps/scales.exr --param depth=.05 --radius .18
  picture flatten wave --radius .12
  picture smooth wave --radius .12 --param passes=60
fi
