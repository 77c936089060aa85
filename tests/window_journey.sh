#!/usr/bin/env bash
# A new user's way through the window, by its own script: open, add a torus, smooth-union it, drag its radius, paint it,
# add a light, anaglyph, heatmap, undo all, redo all, save, reopen, export. The saved scene is as intended.
# window_journey.sh PROGRAM SOURCE [FOLDER for the screenshots]
set -euo pipefail
program=$1 source=$2
folder=${3:-$(mktemp -d)}
mkdir -p "$folder"
[ $# -ge 3 ] || trap 'rm -rf "$folder"' EXIT

cp "$source/examples/smooth_blends.scene.json" "$folder"
cd "$folder"
FIELDWRIGHT_DIALOGS=builtin timeout 500 xvfb-run -a -s "-screen 0 1600x1000x24 -noreset" \
    "$program" edit smooth_blends.scene.json --script "$source/tests/window/journey.script" --state state

[ "$(ls ./*.png | wc -l)" = 14 ] || { echo "not every step left a screenshot"; exit 1; }
"$program" check smooth_blends.scene.json
glslangValidator -S frag smooth_blends.glsl
python3 - "$source/examples/smooth_blends.scene.json" smooth_blends.scene.json <<'PYTHON'
import json, sys

before, after = (json.load(open(path))["graphs"]["root"]["nodes"] for path in sys.argv[1:])
added = {id: node for id, node in after.items() if id not in before}
types = {id: node["type"] for id, node in added.items()}
assert types == {"42": "torus", "44": "smooth_union", "45": "phong", "46": "paint", "47": "point"}, types
assert added["42"]["parameters"]["major"] == 1 and added["42"]["parameters"]["minor"] > 0.3, added["42"]
assert added["46"]["inputs"] == {"d": 42, "material": 45}, added["46"]
assert added["44"]["inputs"]["b"] == 46, added["44"]
output = next(node for node in after.values() if node["type"] == "output")
old_output = next(node for node in before.values() if node["type"] == "output")
assert output["inputs"]["d"] == 44 and added["44"]["inputs"]["a"] == old_output["inputs"]["d"], output
for id, node in before.items():
    if node["type"] == "output":
        continue
    now = after[id]
    assert {**now, "position": 0, "parameters": 0} == {**node, "position": 0, "parameters": 0}, id
    # Saving writes every parameter, and words for what was a switch.
    for name, value in node["parameters"].items():
        assert now["parameters"][name] in (value, "hard" if value is True else value), (id, name)
PYTHON
