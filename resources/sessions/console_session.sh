# Sourced by the scripts that record the shipped sessions, in the folder of the sources. It runs the console on its
# simulated robot, on a screen that nobody sees. The functions press keys like an operator, and read the session that is
# being recorded. Needs xvfb and xdotool.
[ "${1:-}" = inside ] || exec xvfb-run -a -s '-screen 0 1440x900x24' "$0" inside
terratact=build/release/app/terratact
folder=$(mktemp -d)
console=
trap 'kill "$console" 2>/dev/null || true; rm -rf "$folder"' EXIT

fail() { echo "$0: $*" >&2; exit 1; }

# await TIMES COMMAND...: runs the command once a second until it succeeds, at most so many times.
await() {
  left=$1
  shift
  until "$@"; do
    left=$((left - 1))
    [ "$left" -gt 0 ] || fail "waited in vain for: $*"
    sleep 1
  done
}

# write_ground SLOPE X: writes ground.csv with lines under each track and each flipper (docs/files.md). They have this
# cross slope. From X [m] on, a kerb of 0.15 m is on the left side. The robot starts at 0.7 m.
write_ground() {
  awk -v slope="$1" -v kerb="$2" 'BEGIN {
    print "pair,step_m,y_m,heights_m"
    n = split("0.272 0.1985 -0.1985 -0.272", ys)
    for (k = 1; k <= n; ++k) {
      printf "kerb,0.01,%s", ys[k]
      for (i = 0; i <= 500; ++i) printf ",%.4f", slope * ys[k] + (ys[k] > 0 && i > 100 * kerb - 0.5 ? 0.15 : 0)
      print ""
    }
  }' >"$folder/ground.csv"
}

# start_console OPTION...: starts the console. Waits for its window, its model and its link.
start_console() {
  # Runs in the folder of its files, because a session stores the model's path as given.
  (cd resources && exec ../build/release/app/terratact-console --model models/default.ttm --safe-mode --language en \
    --size 1440x900 --sessions "$folder/recorded" "$@") &
  console=$!
  await 60 sees_window
  xdotool windowfocus "$window"
  await 60 has_model
  await 60 happened ',link,up,'
  sleep 2  # arming needs a link that has been good for 1.4 s
}

sees_window() {
  window=$(xdotool search --onlyvisible --class terratact 2>/dev/null | head -n 1)
  [ -n "$window" ]
}

info() { "$terratact" session info "$folder"/recorded/*.tts 2>/dev/null; }
has_model() { info | grep -q '^  model  '; }
estimates() { info | sed -n 's/^  rows .* \([0-9]*\) estimates,.*/\1/p'; }

# count PATTERN: prints how many events of the session match, each a line of CSV.
count() {
  "$terratact" session export "$folder"/recorded/*.tts --what events --format csv --out - 2>/dev/null | grep -c "$1" || true
}
happened() { [ "$(count "$1")" -gt 0 ]; }

press() { xdotool key "$1"; }
hold() { xdotool keydown "$1"; sleep "$2"; xdotool keyup "$1"; }

arm() {
  press m
  sleep 0.6
  hold m 2.5
  await 20 happened ',arming,armed,'
}

# keep NAME: ends the console, verifies its session and keeps it under this name.
keep() {
  kill -TERM "$console"
  wait "$console" || true
  "$terratact" session verify "$folder"/recorded/*.tts
  cp "$folder"/recorded/*.tts "resources/sessions/$1"
  "$terratact" session info "resources/sessions/$1"
}
