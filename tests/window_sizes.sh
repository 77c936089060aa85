#!/usr/bin/env bash
# A real window is given a thousand sizes and keeps no memory of them.
# window_sizes.sh PROGRAM SOURCE
set -euo pipefail
if [ -z "${SIZES_DISPLAY:-}" ]; then
    SIZES_DISPLAY=1 exec xvfb-run -a -s "-screen 0 1600x1000x24 -noreset" "$0" "$@"
fi
program=$1 source=$2
folder=$(mktemp -d)
trap 'kill $editor 2>/dev/null || true; rm -rf "$folder"' EXIT
cd "$folder"
export FIELDWRIGHT_DIALOGS=builtin

fail() {
    echo "window_sizes: $*" >&2
    exit 1
}

# resident_kb_at FILE: when the editor has left it there
resident_kb_at() {
    for _ in $(seq 1200); do
        [ -s "$1" ] && break
        kill -0 $editor 2>/dev/null || fail "the editor ended"
        sleep 0.05
    done
    [ -s "$1" ] || fail "$1 never came"
    awk '/^VmRSS:/ { print $2 }' /proc/$editor/status
}

sizes() { for i in $(seq "$1"); do echo "resize $((320 + i * 37 % 200))x$((240 + i * 53 % 160))"; done; }
at_rest() { printf 'resize 400x300\nsettle\nscreenshot %s\n' "$1"; }
{
    sizes 500
    at_rest before.png
    sizes 1000
    at_rest after.png
    sizes 20 # while the memory is read
    echo quit
} >sizes.script

# So light that no shader is compiled for it, whose memory would count whenever it comes.
"$program" new -o ball.scene.json --node sphere
"$program" edit ball.scene.json --script sizes.script --state state &
editor=$!
before=$(resident_kb_at before.png)
after=$(resident_kb_at after.png)
wait $editor
echo "$before kB after 500 sizes, $after kB after 1,500"
[ $((after - before)) -lt 8000 ] || fail "a thousand sizes cost $((after - before)) kB"
