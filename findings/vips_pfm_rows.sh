#!/usr/bin/env bash
# libvips 8.14.1 (Debian 12), two surprises with PFM files, whose rows stand from the bottom to the top:
#
# 1. It takes the first row of a file for the top one, so that heights are upside down beside netpbm, and in all that
#    it converts them to.
# 2. PFM files that it writes have a line "#vips2ppm - DATE" in their head, which the format does not have: pfmtopam of
#    netpbm refuses them. With --strip there is no such line.
#
# Writes a PFM of two texels, 0.25 above 0.75, reads the upper one by libvips and by netpbm, has libvips write the file
# with and without --strip, and prints what it got. Exit code 0: as told above; 1: other.
set -euo pipefail
vips=8.14.1-3+deb12u3 netpbm=2:11.01.00-2
installed=$(dpkg-query -W -f '${Version} ' libvips-tools netpbm 2>/dev/null || true)
if [ "$installed" != "$vips $netpbm " ]; then
  apt-get install -q -y --no-install-recommends "libvips-tools=$vips" "netpbm=$netpbm" >/dev/null
fi
work=$(mktemp -d)
trap 'rm -rf -- "$work"' EXIT
cd "$work"
# 0.75, then 0.25, as little-endian floats.
printf 'Pf\n1 2\n-1.0\n\x00\x00\x40\x3f\x00\x00\x80\x3e' >heights.pfm
by_vips=$(vips getpoint heights.pfm 0 0 | tr -d ' ')
# The upper texel in steps of 1/255; netpbm takes no floats further.
by_netpbm=$(pfmtopam heights.pfm | pamtopnm | pnmtopnm -plain | sed -n 4p | tr -d ' ')
vips ppmsave heights.pfm plain.pfm
vips ppmsave heights.pfm stripped.pfm --strip
reads() { pfmtopam "$1" >/dev/null 2>&1 && echo read || echo refused; }
plain=$(reads plain.pfm) stripped=$(reads stripped.pfm)
dpkg-query -W libvips-tools netpbm
echo "upper texel by libvips: $by_vips, by netpbm: $by_netpbm / 255; written by libvips: $plain, with --strip: $stripped"
[ "$by_vips $by_netpbm $plain $stripped" = "0.75 64 refused read" ]
