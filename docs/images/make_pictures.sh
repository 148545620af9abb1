#!/bin/sh
# Makes the pictures of scenes in docs/ and the README: sh docs/images/make_pictures.sh [WHAT ...],
# after ./check has built everything. WHAT: render (ray-traced, `ccmorse render`), view and canvas
# (the page in Chromium); all of them where nothing is said. Takes minutes: processors draw it all.
set -eu
cd "$(dirname "$0")/../.."
BIN=build/release/bin
OUT=docs/images
SAMPLES=${SAMPLES:-96} # light paths a pixel

work=$(mktemp -d)
simulator=
finish() {
  [ -z "$simulator" ] || kill -INT "$simulator" 2>/dev/null || true
  rm -rf "$work"
}
trap finish EXIT INT TERM

# Robots stand about among raised obstacles; the lasers are on.
arena() {
  $BIN/ccmorse render $OUT/arena.json --from 0.66 0.78 1.0 --at 1.64 2.34 0 --lasers \
    --samples "$SAMPLES" -o $OUT/render_arena.png
  $BIN/ccmorse render $OUT/arena.json --camera follow:orange --size 800x450 \
    --samples "$SAMPLES" -o $OUT/render_follow.png
}

# What a robot thinks: examples/canvas/layers.cpp explores in lock-step and draws its maps; the
# picture is of the record of that run. The first robot by name, the blue one, drives.
canvas_record() {
  $BIN/ccmorse run $OUT/arena.json --pace lockstep --headless --no-player --port 0 --stream-port 0 \
    --out "$work" --record "$work/explore.mcap" >"$work/log" 2>&1 &
  simulator=$!
  until grep -q "SCENE INITIALIZED" "$work/log"; do
    kill -0 "$simulator" || { cat "$work/log"; exit 1; }
    sleep 0.1
  done
  $BIN/layers "$(sed -n 's/^MORSE services on .* port \([0-9]*\).*/\1/p' "$work/log")" 30
  kill -INT "$simulator"
  wait "$simulator" || true
  simulator=
  $BIN/ccmorse render "$work/explore.mcap" --from 1.71 -0.55 2.6 --at 1.71 1.72 0 --size 1000x750 \
    --samples "$SAMPLES" -o $OUT/render_canvas.png
}

[ $# -gt 0 ] || set -- render view canvas
for what in "$@"; do
  case $what in
    render) arena; canvas_record ;;
    view) node $OUT/make_view_pictures.mjs ;;
    canvas) node $OUT/make_canvas_pictures.mjs ;;
    *) echo "what is '$what'? render, view or canvas"; exit 2 ;;
  esac
done
