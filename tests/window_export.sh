#!/usr/bin/env bash
# The window writes its picture in every format, by the name or by the list, and says when a name's end is none.
# window_export.sh PROGRAM SOURCE [FOLDER for the screenshots]
set -euo pipefail
program=$1 source=$2
folder=${3:-$(mktemp -d)}
mkdir -p "$folder"
[ $# -ge 3 ] || trap 'rm -rf "$folder"' EXIT

cp "$source/examples/booleans.scene.json" "$folder"
cd "$folder"
FIELDWRIGHT_DIALOGS=builtin timeout 300 xvfb-run -a -s "-screen 0 1600x1000x24 -noreset" \
    "$program" edit booleans.scene.json --script "$source/tests/window/export.script" --state state

python3 - <<'PYTHON'
import pathlib

def starts(name, magic):
    data = pathlib.Path(name).read_bytes()
    assert data.startswith(magic), (name, data[:12])
    return data

starts("booleans.png", b"\x89PNG")
starts("small.jpg", b"\xff\xd8")
starts("light.hdr", b"#?RADIANCE")
layers = starts("booleans.exr", b"\x76\x2f\x31\x01")
for channel in (b"N.X\0", b"P.X\0", b"albedo.R\0", b"steps.Y\0", b"shadow.Y\0"):
    assert channel in layers, channel
assert not pathlib.Path("booleans.bmp").exists()
PYTHON
