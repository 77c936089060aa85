#!/usr/bin/env bash
# A real window under a real X server, and hands that are not ours: xdotool clicks, drags, types and turns the wheel.
# window_hands.sh PROGRAM SOURCE
set -euo pipefail
if [ -z "${HANDS_DISPLAY:-}" ]; then
    HANDS_DISPLAY=1 exec xvfb-run -a -s "-screen 0 1600x1000x24 -noreset" "$0" "$@"
fi
program=$1 source=$2
folder=$(mktemp -d)
cp "$source/examples/smooth_blends.scene.json" "$folder/scene.scene.json"
cd "$folder"
xdotool mousemove 500 700  # where the canvas will be
FIELDWRIGHT_DIALOGS=builtin "$program" edit scene.scene.json --state state --places places &
editor=$!
trap 'kill $editor 2>/dev/null || true; rm -rf "$folder"' EXIT

fail() {
    echo "window_hands: $*" >&2
    exit 1
}

# wait_for SECONDS COMMAND...: until it succeeds
wait_for() {
    local tries=$(($1 * 10))
    shift
    until "$@" >/dev/null 2>&1; do
        kill -0 $editor 2>/dev/null || fail "the editor ended"
        tries=$((tries - 1))
        [ $tries -gt 0 ] || fail "waited in vain for: $*"
        sleep 0.1
    done
}

place() { awk -v widget="$1" '$1 == widget { print $2, $3 }' places | grep . || fail "no widget is named $1"; }
is_there() { grep -q "^$1 " places; }
point_at() {
    wait_for 20 is_there "$1"
    # shellcheck disable=SC2046
    xdotool mousemove $(place "$1")
    sleep 0.1
}
saved() { grep -q "$1" scene.scene.json; }

wait_for 30 test -s places
wait_for 30 xdotool search --name "scene.scene.json - Fieldwright"

# The mouse was there before the window, and never moved.
wait_for 20 is_there canvas
sleep 1  # a busy screen gives the window its keys a moment after showing it
xdotool key shift+a
wait_for 20 is_there add_menu/search
xdotool key Escape
wait_for 20 bash -c '! grep -q "^add_menu/search " places'

# Ten quick taps of a key: ten torus letters typed into the add menu's search, one torus added.
point_at canvas
xdotool key shift+a
wait_for 20 is_there add_menu/search
xdotool type --delay 5 torus
wait_for 20 is_there add_menu/item/torus
xdotool key Return
wait_for 20 is_there canvas/node/42
wait_for 20 is_there inspector/minor

# A drag of its tube's radius.
point_at inspector/minor
xdotool mousedown 1 sleep 0.1 mousemove_relative 20 0 sleep 0.1 mousemove_relative 20 0 sleep 0.1 mouseup 1
sleep 0.3

# Over the viewport: the wheel comes closer, a drag orbits, Space hides and shows the panels.
point_at viewport
xdotool click 4 click 4 mousedown 1 mousemove_relative 60 20 mousemove_relative 60 20 mouseup 1
xdotool key space
wait_for 20 bash -c '! grep -q "^inspector/minor " places'
xdotool key space
wait_for 20 is_there inspector/minor

# Saved, with the torus and another radius; undone four times in a burst; redone in a burst: nothing is lost.
xdotool key ctrl+s
wait_for 20 saved '"type": "torus"'
saved '"minor": 0.25' && fail "the drag did not change the radius"
cp scene.scene.json first

# What is copied is text for everyone.
point_at canvas
xdotool key ctrl+c
wait_for 20 bash -c 'xclip -o -selection clipboard | tee copied | grep -q fieldwright-nodes'
grep -q '"type": "torus"' copied || fail "the clipboard does not hold the torus"
xdotool key --delay 5 ctrl+z ctrl+z
xdotool key ctrl+s
wait_for 20 bash -c '! grep -q "\"type\": \"torus\"" scene.scene.json'
xdotool key --delay 5 ctrl+y ctrl+y
xdotool key ctrl+s
wait_for 20 saved '"type": "torus"'
cmp first scene.scene.json || fail "undo and redo in a burst did not lead back"

# Text that another program holds: nodes are added, anything else is not.
point_at canvas
hold_clipboard() { xclip -i -selection clipboard "$@" >/dev/null 2>&1; }
echo "no nodes" | hold_clipboard
xdotool key ctrl+v
hold_clipboard copied
xdotool key ctrl+v
wait_for 20 is_there canvas/node/43
is_there canvas/node/44 && fail "text without nodes was pasted"
xdotool key ctrl+c  # the clipboard is ours again, which ends xclip
xdotool key ctrl+s
wait_for 20 saved '"43"'

# Nothing unsaved: closing needs no question.
xdotool key ctrl+q
wait $editor || fail "the editor ended with $?"
