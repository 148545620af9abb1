#!/bin/sh
# Makes the pictures of docs/course with the programs of a release build: each task's solution draws
# its picture while it runs, in lock-step, so it is the same every time.
#   sh docs/images/make_course_pictures.sh
set -eu
cd "$(dirname "$0")/../.."
bin=build/release/bin

# picture TASK SECONDS PROGRAM: docs/images/course_TASK.png
picture() {
  "$bin/ccmorse" run "courses/par/$1/scenario.json" --pace lockstep --for "$2" --headless \
    --port 0 --no-player --picture "docs/images/course_$1.png" >"$log" 2>&1 &
  simulator=$!
  port=
  while [ -z "$port" ]; do
    port=$(sed -n 's/^MORSE services .* port \([0-9]*\)$/\1/p' "$log" | head -n 1)
    kill -0 "$simulator"
    sleep 0.1
  done
  shift 2
  CCMORSE_PORT=$port "$@" >/dev/null || true
  # Time waits for programs: one that has left before the end ends the run.
  kill "$simulator" 2>/dev/null || true
  wait "$simulator" || true
}

log=$(mktemp)
trap 'rm -f "$log"' EXIT
picture intro 300 "$bin/intro-wall-following"
picture planning 5 "$bin/planner-dijkstra" --map courses/par/planning/maps/arena.txt
picture exploration 45 "$bin/explorer-nearest-frontier"
