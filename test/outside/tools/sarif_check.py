"""SARIF files of scc against the schema of the standard, as Microsoft ships it for tests, and jsonschema."""

import glob
import json
import os
import subprocess

import jsonschema

from common import Run, npm_pack

PACKAGE = "@microsoft/jest-sarif@1.0.0-beta.0"
SCHEMA = "package/lib/schemas/sarif-2.1.0-rtm.5.json"


def schema(folder):
    with npm_pack(PACKAGE, folder) as pack:
        return json.load(pack.extractfile(SCHEMA))


def log_of(run, model):
    path = run.path("log.sarif")
    subprocess.run([run.scc, "check", model, "--seconds", "600", "--sarif", path], capture_output=True, timeout=1200)
    if not os.path.exists(path):
        return None
    with open(path, encoding="utf-8") as file:
        log = json.load(file)
    os.remove(path)
    return log


def main():
    run = Run("SARIF files are valid")
    definition = schema(run.folder)
    kind = jsonschema.validators.validator_for(definition)
    kind.check_schema(definition)
    validator = kind(definition)
    results = 0
    example = None
    for model in sorted(glob.glob("specs/models/*.sc")) + sorted(glob.glob("specs/conformance/invalid/*.sc")):
        log = log_of(run, model)
        if not run.ok(log is not None, f"{model}: no file"):
            continue
        error = jsonschema.exceptions.best_match(validator.iter_errors(log))
        results += len(log["runs"][0]["results"])
        run.ok(error is None, f"{model}: {error and (error.json_path, error.message[:300])}")
        example = log
    # A validator that accepts everything would be of no use.
    del example["runs"][0]["tool"]["driver"]["name"]
    run.ok(not validator.is_valid(example), "a log without the name of its tool was taken for valid")
    print(f"  {results} results")
    run.end()


main()
