"""The schemas of docs/schema describe what the program writes: every key, and no other."""

import json
import warnings
from pathlib import Path

import jsonschema
import pytest

ROOT = Path(__file__).resolve().parents[2]
GOLDEN = ROOT / "tests/golden"
CATALOG = ROOT / "catalog"

# Schema of each golden file, by the beginning of its name.
SCHEMA_OF = {
    "catalogue": "catalogue", "check": "check", "compare": "comparison", "count": "count", "diagnose": "diagnosis",
    "explore_summary": "summary", "import": "import", "rank": "rank", "show": "show", "size": "sizing",
}
HAND = CATALOG / "hardware/three_finger_hand.toml"
MODEL = CATALOG / "model/example.toml"
READINGS = GOLDEN / "readings.csv"
PRICES = CATALOG / "prices/example.toml"
SIZE = ("size", "M-1-P-2-P-3-M", "--vary", "sheath_angle=1..12", "--draws", "5")
# Commands whose options add keys that golden files lack.
COMMANDS = [
    ("show", "show", "LuffTackle"),
    ("show", "show", "TR5", "--cost", PRICES),
    ("show", "show", "TR1", "--model", MODEL),
    ("show", "show", "M-1-M+M-2-M+M-3-M", "--hardware", HAND),
    ("rank", "rank", "TR3", "TR7", "--margin"),
    ("rank", "rank", "TR3", "TR7", "--sweep", "mu=0.1..0.2", "--uncertainty", "--draws", "3"),
    ("rank", "rank", "TR5", "TR7", "--data", READINGS, "--distribution-mu", "0.18,model", "--out", "out"),
    ("rank", "rank", "TR5", "--cost", PRICES, "--model", MODEL),
    ("rank", "rank", "M-1-T-2-T-3-F", "--hardware", HAND, "--uncertainty", "--draws", "3"),
    ("summary", "explore", "--cost", PRICES, "--within", "5%"),
    ("summary", "explore", "--constraint", "sheaths<=1", "--constraint", "uniformity>=0.994"),
    ("summary", "explore", "--uncertainty", "--draws", "3", "--constraint", "sheaths<=2",
     "--sweep", "mu=0.1..0.2", "--top", "1"),
    ("summary", "explore", "--fingers", "3", "--hardware", HAND, "--objectives", "motor_force"),
    ("summary", "explore", "--fingers", "3", "--parts", "full", "--hardware", HAND),
    ("count", "count", "--fingers", "4", "--constraint", "sheaths<=2"),
    ("count", "count", "--fingers", "5"),
    ("comparison", "compare", CATALOG / "measured/canyons_and_crags.csv",
     "--hardware", CATALOG / "hardware/rope_bench.toml"),
    ("diagnosis", "diagnose", CATALOG / "measured/belt_lab_six_angles.csv"),
    ("power", "simulate", "--routings", "TR5", "--rows", "6", "--cause", "sensor_gain[T3]",
     "--set", "gain=1.3", "--runs", "4", "--power", "1"),
    ("sizing", *SIZE, "--target", "1=2,others=1"),
    ("sizing", *SIZE, "--hardware", HAND, "--goal", "motor_force", "--equal", "sheaths"),
]


def strict(schema):
    """Refuses keys that are not described, which readers of later versions should pass over."""
    if isinstance(schema, dict):
        if "properties" in schema:
            schema.setdefault("additionalProperties", False)
        for part in schema.values():
            strict(part)
    elif isinstance(schema, list):
        for part in schema:
            strict(part)
    return schema


@pytest.fixture(scope="module")
def validate():
    schemas = {}
    for file in (ROOT / "docs/schema").glob("*.schema.json"):
        schema = json.loads(file.read_text(encoding="utf-8"))
        jsonschema.Draft202012Validator.check_schema(schema)
        assert schema["$id"] == file.name
        schemas[file.name] = strict(schema)

    def run(value, name):
        schema = schemas[f"{name}.schema.json"]
        with warnings.catch_warnings():
            # The resolver is deprecated from version 4.18 on; Debian 12 has 4.10.
            warnings.simplefilter("ignore", DeprecationWarning)
            resolver = jsonschema.RefResolver(schema["$id"], schema, store=schemas)
            jsonschema.Draft202012Validator(schema, resolver=resolver).validate(value)

    return run


def is_number_left_out(key, value):
    return key in ("seconds", "designs_per_second") and value == "varies"


def golden_files():
    return sorted((GOLDEN / "expected").glob("*.json"))


@pytest.mark.parametrize("file", golden_files(), ids=lambda file: file.stem)
def test_golden_files_follow_their_schema(file, validate):
    (name,) = {schema for start, schema in SCHEMA_OF.items() if file.stem.startswith(start)}
    value = json.loads(file.read_text(encoding="utf-8"))
    validate({key: 0 if is_number_left_out(key, part) else part for key, part in value.items()}, name)


@pytest.mark.parametrize("command", COMMANDS, ids=lambda command: " ".join(map(str, command[1:4])))
def test_outputs_with_options_follow_their_schema(command, validate, program, tmp_path):
    name, *arguments = command
    validate(json.loads(program(*arguments, "--format", "json", folder=tmp_path)), name)


def test_files_that_stdout_does_not_have_follow_their_schema(validate, program, tmp_path):
    def read(name):
        return json.loads((tmp_path / name).read_text(encoding="utf-8"))

    program("explore", "--shard", "1/2", "--constraint", "uniformity>=0.5", "--out", "shard", folder=tmp_path)
    validate(read("shard/shard.json"), "shard")
    program("size", "TR5", "--vary", "tip_angle=1..4", "--nominal", "--out", "size", folder=tmp_path)
    validate(read("size/sizing.json"), "sizing")
    program("explore", "--store", "a.db", "--out", "explored", folder=tmp_path)
    ranked = program("rank", "--store", "a.db", "--objectives", "travel", "--format", "json", folder=tmp_path)
    validate(json.loads(ranked), "rank_store")


def test_a_key_without_description_a_missing_key_and_another_type_are_noticed(validate, program):
    counted = json.loads(program("count", "--format", "json"))
    validate(counted, "count")
    for wrong in ({**counted, "more": 1}, {**counted, "all": "126"},
                  {key: value for key, value in counted.items() if key != "all"}):
        with pytest.raises(jsonschema.ValidationError):
            validate(wrong, "count")


def described(schema, path=""):
    """Yields the place of each property without a description of its own or of what it refers to."""
    if isinstance(schema, dict):
        for key, part in schema.get("properties", {}).items():
            if "description" not in part and "$ref" not in part:
                yield f"{path}/{key}"
        for key, part in schema.items():
            yield from described(part, f"{path}/{key}")
    elif isinstance(schema, list):
        for part in schema:
            yield from described(part, path)


def test_every_key_is_described():
    for file in (ROOT / "docs/schema").glob("*.schema.json"):
        schema = json.loads(file.read_text(encoding="utf-8"))
        assert list(described(schema, file.name)) == []
