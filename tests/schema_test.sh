#!/usr/bin/env bash
# The published schema accepts every example and what the program writes, and refuses broken scenes.
set -euo pipefail
source_folder=$2

python3 - "$source_folder" <<'PYTHON'
import copy, glob, json, sys
import jsonschema

folder = sys.argv[1]
schema = json.load(open(f"{folder}/docs/scene.schema.json"))
jsonschema.Draft7Validator.check_schema(schema)
validator = jsonschema.Draft7Validator(schema)

examples = sorted(glob.glob(f"{folder}/examples/*.scene.json"))
assert examples, "no examples to check"
for path in examples:
    for error in validator.iter_errors(json.load(open(path))):
        sys.exit(f"{path}: {'.'.join(map(str, error.path))}: {error.message}")

good = {"format": "fieldwright", "version": 1, "notes": [],
        "graphs": {"root": {"nodes": {"1": {"type": "sphere", "parameters": {"radius": 1.0}, "inputs": {"a": 2}}}}}}
assert validator.is_valid(good)

def broken(*path_and_value):
    *path, key, value = path_and_value
    scene = copy.deepcopy(good)
    place = scene
    for step in path:
        place = place[step]
    place[key] = value
    return scene

node = ("graphs", "root", "nodes", "1")
for scene in [[], {}, broken("format", "gltf"), broken("version", 0), broken("next_id", 0), broken("march", {"steps": 1}),
              broken("occlusion", {"strength": 2}), broken("fog", {"density": -1}), broken("bounces", 9), broken("graphs", {}), broken("graphs", "other", {}),
              broken("graphs", "root", "nodes", "01", {"type": "sphere"}), broken(*node, {}), broken(*node, "colour", 1),
              broken(*node, "position", [1]), broken(*node, "parameters", "radius", None), broken(*node, "inputs", "a", "2")]:
    assert not validator.is_valid(scene), scene
print(f"{len(examples)} examples follow the schema")
PYTHON
