#!/usr/bin/env bash
# usage: compare.sh BURIN STAMP.exr
#
# Draws one stroke on one sphere with Blender's sculpt mode and with `burin bench`, several times each, and
# prints what both took. Exit code 0: burin needs at most a tenth of Blender's time, or there is no Blender or
# no Xvfb here; 1: more than a tenth, or something went wrong.
set -euo pipefail
here=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")" && pwd)
burin=$1
stamp=$(realpath -- "$2")

for program in blender xvfb-run; do
  if ! command -v "$program" >/dev/null; then
    echo "blender_peer: skipped, $program is not installed (./dev bench-blender installs it)"
    exit 0
  fi
done

work=$(mktemp -d)
trap 'rm -rf -- "$work"' EXIT

# or_show_log LOG COMMAND...: says what the command said only when it fails.
or_show_log() {
  local log=$1
  shift
  "$@" >"$log" 2>&1 </dev/null || { tail -n 30 "$log" >&2; exit 1; }
}

echo "blender_peer: drawing with $(blender --version | head -n 1), in about a minute"
# A brush stroke needs a window to be drawn in.
or_show_log "$work/blender.log" timeout 600 xvfb-run -a -s '-screen 0 1280x1024x24' \
  blender -noaudio --factory-startup --python-exit-code 1 --python "$here/draw.py" -- "$stamp" "$work"
echo "blender_peer: drawing with burin"
"$burin" bench "$work/suite.json" --json >"$work/burin.json"

# Blender's own Python, so that no other is needed; its words apart from Blender's.
status=0
blender --background --factory-startup --python "$here/report.py" -- "$work" >"$work/report.log" 2>&1 || status=$?
cat "$work/report.txt" 2>/dev/null || tail -n 30 "$work/report.log" >&2
exit "$status"
