#!/usr/bin/env python3
"""Validates what scc prints as JSON against specs/schema, with jsonschema; where jsonschema-rs is installed too, which
takes a tenth of the time, it tells first what is valid, and jsonschema is asked about the rest, and about every 32nd
of these.

check_json.py SCC [COUNTS [DOCUMENTS]]: runs SCC over the models, meshes and invalid inputs of specs/ and validates every
document; writes 'N passed, N failed' to the file COUNTS. DOCUMENTS is test/laws/formats/documents.exe, which makes
random documents of the formats and says which of them scc reads: they have to be those that the schemas accept.
"""

import glob
import json
import os
import re
import struct
import subprocess
import sys
import tempfile
import warnings

warnings.filterwarnings("ignore", category=DeprecationWarning)
import jsonschema

try:
    import jsonschema_rs
except ImportError:
    jsonschema_rs = None

SCHEMAS = {}
for path in sorted(glob.glob("specs/schema/*.schema.json")):
    with open(path, encoding="utf-8") as file:
        SCHEMAS[os.path.basename(path)] = json.load(file)

STORE = {schema["$id"]: schema for schema in SCHEMAS.values()}
# In it bonds draw, are to be released, and are first.
LOTS = "test/outside/successor/models/lots-left.sc"
PASSED = 0
FAILED = 0


class Validator:
    """Of a schema that may refer to those of specs/schema."""

    def __init__(self, schema):
        resolver = jsonschema.RefResolver(base_uri="", referrer=schema, store=STORE)
        self.exact = jsonschema.Draft202012Validator(schema, resolver=resolver)
        self.fast = None
        if jsonschema_rs is not None:
            registry = jsonschema_rs.Registry(list(STORE.items()))
            self.fast = jsonschema_rs.Draft202012Validator(schema, registry=registry)
        self.asked = 0

    def iter_errors(self, document):
        self.asked += 1
        if self.fast is not None and self.asked % 32 != 1 and self.fast.is_valid(document):
            return iter(())
        return self.exact.iter_errors(document)


VALIDATORS = {}


def validator(name):
    """Of one schema, or, after a #, of a definition in it."""
    if name not in VALIDATORS:
        whole, _, part = name.partition("#")
        schema = {"$ref": f"{whole}.schema.json#/$defs/{part}"} if part else SCHEMAS[whole + ".schema.json"]
        VALIDATORS[name] = Validator(schema)
    return VALIDATORS[name]


def count(ok, what, why=""):
    global PASSED, FAILED
    if ok:
        PASSED += 1
    else:
        FAILED += 1
        print(f"JSON: {what}: {why}")


def no_float(text):
    raise ValueError(f"a number that is no integer: {text}")


def check(name, text, what):
    """One document of one schema."""
    try:
        document = json.loads(text, parse_float=no_float, parse_constant=no_float)
    except ValueError as error:
        count(False, what, f"{error}: {text[:200]!r}")
        return None
    error = jsonschema.exceptions.best_match(validator(name).iter_errors(document))
    count(error is None, what, error and f"{error.json_path}: {error.message[:300]}")
    return document


def run(scc, *words):
    return subprocess.run([scc, *words], capture_output=True, timeout=300)


def text_of(result):
    return result.stdout.decode("utf-8")


def region_of(place):
    """A place of a diagnostic as SARIF's region."""
    return {
        "startLine": place["start"]["line"],
        "startColumn": place["start"]["column"],
        "endLine": place["end"]["line"],
        "endColumn": place["end"]["column"],
    }


def text_at(region, text):
    """What stands in a region of one line, or nothing."""
    if region["startLine"] != region["endLine"]:
        return ""
    return text.splitlines()[region["startLine"] - 1][region["startColumn"] - 1:region["endColumn"] - 1]


def sarif_faults(log, report, model):
    """What is wrong with a SARIF file, by its own rules and beside the report on the same run."""
    if log["version"] != "2.1.0" or len(log["runs"]) != 1:
        return "no single run of version 2.1.0"
    sarif = log["runs"][0]
    rules = [rule["id"] for rule in sarif["tool"]["driver"]["rules"]]
    if len(set(rules)) != len(rules):
        return "a rule twice"
    if sarif["invocations"][0]["exitCode"] != report["exit"]:
        return "another exit code"
    expected = [(d["code"], d["place"] and region_of(d["place"])) for d in report["diagnostics"]]
    properties = [p for p in report.get("properties", []) if p["verdict"] in ("violated", "undecided")]
    found = []
    with open(model, encoding="utf-8", errors="replace") as file:
        text = file.read()
    for result in sarif["results"]:
        if rules[result["ruleIndex"]] != result["ruleId"] or not result["message"]["text"]:
            return f"the rule of {result}"
        if (result["kind"] == "fail") == (result["level"] == "none"):
            return f"the level of {result}"
        places = [location["physicalLocation"] for location in result.get("locations", [])]
        found.append((result["ruleId"], places[0].get("region") if places else None))
    if found[:len(expected)] != expected:
        return f"diagnostics {found} instead of {expected}"
    if [rule for rule, _ in found[len(expected):]] != [p["verdict"] for p in properties]:
        return "other properties than in the report"
    for p, (_, region) in zip(properties, found[len(expected):]):
        if text_at(region, text) != p["name"].split("[")[0]:
            return f"{p['name']} is not at {region}"
    for p, result in zip(properties, sarif["results"][len(expected):]):
        steps = p["witness"]["steps"] if p["witness"] else []
        flows = [f["threadFlows"][0]["locations"] for f in result.get("codeFlows", [])]
        if steps and (len(flows) != 1 or len(flows[0]) < len(steps)):
            return f"no flow of {len(steps)} steps for {p['name']}"
        if any(s["executionOrder"] != i for flow in flows for i, s in enumerate(flow, 1)):
            return "steps out of order"
    return None


def check_sarif(scc, model, folder):
    path = os.path.join(folder, "log.sarif")
    report = json.loads(text_of(run(scc, "check", model, "--json", "--states", "4000", "--sarif", path)))
    with open(path, encoding="utf-8") as file:
        why = sarif_faults(json.load(file, parse_float=no_float), report, model)
    os.remove(path)
    count(why is None, f"SARIF of {model}", why)


def check_model(scc, model, folder):
    coverage = [] if is_open(model) else ["--coverage"]
    result = run(scc, "check", model, "--json", *coverage, "--stats", "--states", "1500", "--witness", folder)
    document = check("check", text_of(result), f"check {model}")
    if document is not None:
        count(document["exit"] == result.returncode, f"check {model}", "another exit code in the document")
    count(result.stderr == b"", f"check {model}", "something on standard error")
    for schedule in sorted(glob.glob(os.path.join(folder, "*.json"))):
        with open(schedule, encoding="utf-8") as file:
            check("schedule", file.read(), f"{os.path.basename(schedule)} of {model}")
        if not is_open(model):
            check("explain", text_of(run(scc, "explain", schedule, "--json")), f"explain {schedule} of {model}")
        os.remove(schedule)


def check_slowing(scc, folder):
    """A bound ends an exploration in which event times grow ever slower."""
    model = os.path.join(folder, "closing.sc")
    with open("specs/models/laws/closing.sc", encoding="utf-8") as text, open(model, "w", encoding="utf-8") as out:
        out.write(text.read() + "check forever : always x(west) < x(ball)\n")
    document = check("check", text_of(run(scc, "check", model, "--json", "--states", "120")), "check closing")
    told = document is not None and "slowing" in document["properties"][-1]
    count(told, "check closing", "it is not told that event times grow ever slower")


RANGES = """param y in [-5, 5]
param z in (-5, 5]
split_step any
behaviour P on Cube = <a, {right}>. K
behaviour K on Cube = omega(a, {right}). nil
behaviour Q on Cube = <~a, {left}>. nil
process p = Cube mass 1 velocity (1,0,0) at translate (0,y,z) [P]
process q = Cube mass 1 at translate (12,0,0) [Q]
check meets  : possibly bound(p, q)
check shown  : possibly x(p) > 1
check never  : always not bound(p, q)
check far    : possibly distance2(p, q) < 1
check nested : AG EF bound(p, q)
"""


def check_ranges(scc, folder):
    """A model whose parameters have ranges, and whose bonds may be released at any time."""
    model = os.path.join(folder, "ranges.sc")
    with open("specs/models/hexokinase.sc", encoding="utf-8") as text:
        cube = text.read().split("shape Cube {")[1].split("}")[0]
    with open(model, "w", encoding="utf-8") as out:
        out.write("shape Cube {" + cube + "}\n" + RANGES)
    for options in ([], ["--where"], ["--where", "-D", "y=1", "-D", "z=[0,1]"]):
        result = run(scc, "check", model, "--json", *options)
        what = "check ranges " + " ".join(options)
        document = check("check", text_of(result), what)
        if document is None:
            continue
        properties = document.get("properties", [])
        told = [p for p in properties if p.get("over", {}).get("instants") and p["over"]["ranges"]]
        count(len(told) == 5, what, "it is not told over what the verdicts are")
        where = [p["where"]["probability"] for p in properties if "where" in p]
        count(len(where) == (5 if options else 0), what, "it is not told where they hold")
        values = [p for p in properties if p["witness"] and "values" in p["witness"]]
        count(values != [], what, "no run tells its values")
    os.remove(model)


def check_invariants(scc, folder):
    """A proof by an invariant, that an open model has by itself, and an ordinary one where it is asked for; and none."""
    model = os.path.join(folder, "escape.sc")
    with open("specs/models/escape.sc", encoding="utf-8") as text, open(model, "w", encoding="utf-8") as out:
        out.write(text.read())
    for options in (["--prove"], ["-D", "x=-8", "--prove"], ["--depth", "30"]):
        what = "check invariant " + " ".join(options)
        document = check("check", text_of(run(scc, "check", model, "--json", *options)), what)
        if document is not None:
            resting = [p["name"] for p in document["properties"] if p.get("by_invariant")]
            count(resting == ["apart", "inside", "order"], what, "it is not told what rests on it")
            kinds = document["invariants"][0].get("kinds", [])
            count(len(kinds) == 8 and all(k["constraints"] for k in kinds), what, "it is not shown")
    document = check("check", text_of(run(scc, "check", "specs/models/window.sc", "--json", "--prove")), "check no invariant")
    count(document is not None and "reason" in document["invariants"][0], "check no invariant", "no reason is told")
    os.remove(model)


def check_reasons(scc, folder):
    """Formulas within formulas come with what is so on the way of their runs."""
    model = os.path.join(folder, "nested.sc")
    formulas = ["AF AG x(p) > 0", "EG EF x(p) > 0", "E[EF x(p) > 0 U x(p) < 0]", "AG EF x(p) > 0", "AF EG x(p) > 0"]
    with open("specs/models/billiard.sc", encoding="utf-8") as text, open(model, "w", encoding="utf-8") as out:
        out.write(text.read() + "".join(f"check nested{i} : {f}\n" for i, f in enumerate(formulas)))
    document = check("check", text_of(run(scc, "check", model, "--json")), "check nested")
    told = document is not None and '"where": "' in json.dumps(document)
    count(told, "check nested", "it is not told what is so on the way of a run")


def is_open(model):
    """Its start, or the instants of its splits, are left open: only scc check answers for such a model."""
    with open(model, encoding="utf-8") as file:
        return re.search(r"^(param \w+ in [\[(]|split_step any)", file.read(), re.M) is not None


def check_trace(scc, model, *options):
    result = run(scc, "trace", model, "--steps", "25", "--choose", "random:1", *options)
    lines = text_of(result).splitlines()
    bad = FAILED
    validate = validator("trace")
    for number, line in enumerate(lines, 1):
        error = jsonschema.exceptions.best_match(validate.iter_errors(json.loads(line, parse_float=no_float)))
        if error is not None:
            count(False, f"trace {model}: line {number}", f"{error.json_path}: {error.message[:300]}")
            break
    if bad == FAILED:
        count(len(lines) >= 3, f"trace {model}", "too short")


def check_simulation(scc, model):
    """Two runs of few steps, of the model's time, and what they come to."""
    words = ["simulate", model, "--runs", "2", "--steps", "40", "--observe", "time", "--observe", "bonds()",
             "--every", "1/2", "--until", "2", "--format", "jsonl"]
    validate = validator("simulation")
    for options, lines in ([], 3), (["--decimals", "3"], 3), (["--summary"], 11):
        found = text_of(run(scc, *words, *options)).splitlines()
        documents = [json.loads(line, parse_float=no_float) for line in found]
        errors = [e for d in documents for e in validate.iter_errors(d)]
        count(not errors and len(found) == lines, f"simulate {model}", errors and errors[0].message[:300] or len(found))


def check_estimates(scc):
    """Probabilities and means that are known, that are not, and that depend on choices."""
    asked = ["--property", "P = ? [ eventually bonds() = 0 ]", "--property", "E = ? [ bonds() at 3 ]", "--json"]
    for words in (["ruin.sc", "--runs", "40", "--json"], ["brownian.sc", "--most", "130", "--json"],
                  ["dimer.sc", *asked], ["dimer.sc", "--free", "evenly", "--runs", "50", *asked],
                  ["ruin.sc", "--runs", "40", "--json", "--property", "E <= 3 [ x(walker) at 99 ]"]):
        result = run(scc, "estimate", os.path.join("specs/models", words[0]), *words[1:])
        document = check("estimate", text_of(result), f"estimate {' '.join(words)}")
        if document is not None:
            ok = document["exit"] == result.returncode
            for p in document["properties"]:
                kinds = ("yes", "no", "numbers", "never", "free", "too_long", "no_value")
                ok = ok and p["runs"] == sum(p[kind] for kind in kinds)
            count(ok, f"estimate {' '.join(words)}", "another exit code, or runs that are not counted")


def check_sweeps(scc):
    """Verdicts, numbers, infinite ones, bounds, and points at which a model is invalid."""
    validate = validator("sweep")
    for words, points in ((["chain.sc", "-D", "n=0..3"], 4), (["gas.sc", "-D", "n=1..3", "--states", "50"], 3),
                          (["hexokinase.sc", "-D", "atp_arrives=1,2", "-D", "glucose_arrives=1:2:1/2"], 6)):
        result = run(scc, "sweep", os.path.join("specs/models", words[0]), *words[1:], "--format", "jsonl")
        found = text_of(result).splitlines()
        errors = [e for line in found for e in validate.iter_errors(json.loads(line, parse_float=no_float))]
        count(not errors and len(found) == points + 1, f"sweep {' '.join(words)}",
              errors and errors[0].message[:300] or len(found))


def has_laws(model):
    """Whether it has laws of motion, beside which explore takes no ranges."""
    with open(model, encoding="utf-8") as text:
        return any(line.startswith("motion ") for line in text)


def check_zones(scc, model):
    """The zones of a model with ranges, or with splits at any time, complete and not."""
    for bound in ("--states=300", "--states=2", "--time=1"):
        result = run(scc, "explore", model, "-o", "-", "--format", "json", bound)
        document = check("zones", text_of(result), f"explore {model}")
        if document is None:
            continue
        zones = document["zones"]
        left = [z["number"] for z in zones if z["status"] == "unexplored"]
        known = [set(z["variables"]) for z in zones]

        def speaks(variables, polyhedron):
            return all(set(c["coefficients"]) <= variables for c in polyhedron)

        count(
            len(left) == document["unexplored"]
            and (not document["complete"] or not left)
            and [z["number"] for z in zones] == list(range(len(zones)))
            and all(speaks(known[z["number"]], z["polyhedron"]) for z in zones)
            and all(
                set(e["map"]) == known[e["target"]]
                and speaks(known[z["number"]] | {"time passed"}, e["guard"])
                for z in zones
                for e in z["edges"]
            ),
            f"explore {model}",
            "zones are not as they should be",
        )


def check_graphs(scc, model, folder):
    """The graph of a model as JSON, complete and not, and the names of its explicit files."""
    for states in ("40", "2"):
        result = run(scc, "explore", model, "-o", "-", "--format", "json", "--states", states)
        document = check("graph", text_of(result), f"explore {model}")
        if document is None:
            continue
        left = [s["number"] for s in document["states"] if s["status"] == "unexplored"]
        count(
            len(left) == document["unexplored"] and document["complete"] == (not left)
            and [s["number"] for s in document["states"]] == list(range(len(document["states"])))
            and all(e["target"] < len(document["states"]) for s in document["states"] for e in s["edges"]),
            f"explore {model}",
            "states are not as they should be",
        )
    run(scc, "explore", model, "-o", os.path.join(folder, "graph.tra"), "--instants", "--states", "40")
    for path in glob.glob(os.path.join(folder, "graph.*")):
        if path.endswith(".names.json"):
            with open(path, encoding="utf-8") as file:
                check("names", file.read(), f"names of {model}")
        os.remove(path)


def check_refusals(scc):
    for model in sorted(glob.glob("specs/conformance/invalid/*.sc") + glob.glob("specs/conformance/invalid/*.xml")) + sorted(
        glob.glob("specs/models/refused/*.sc")
    ):
        result = run(scc, "check", model, "--json", "--seconds", "60")
        name = "diagnostics" if result.returncode == 3 else "check"
        check(name, text_of(result), f"check {model}")


def check_view(scc, model, twice):
    """The data in a page; or by itself, and in a page too: the same is there, and no script but its own."""
    words = ["view", "--graph", "20", "--states", "40", model, "-o", "-"]
    document = check("view", text_of(run(scc, *words, "--data")), f"view {model}")
    if twice:
        page = text_of(run(scc, *words))
        data = re.search(r'<script type="application/json" id="data">(.*?)</script>', page, re.DOTALL)
        count(data is not None and json.loads(data[1]) == document, f"view {model}", "another document is in the page")


def check_conformance():
    """The files of the conformance suite."""
    with open("specs/conformance/manifest.json", encoding="utf-8") as file:
        manifest = json.load(file)
    for path, name in [("manifest.json", "conformance-manifest")] + [
        (suite["file"], "conformance") for suite in manifest["suites"]
    ]:
        with open("specs/conformance/" + path, encoding="utf-8") as file:
            error = jsonschema.exceptions.best_match(validator(name).iter_errors(json.load(file)))
        count(error is None, path, error and f"{error.json_path}: {error.message[:300]}")


def check_shapes(scc):
    for mesh in sorted(glob.glob("specs/**/*.off", recursive=True) + glob.glob("specs/**/*.obj", recursive=True)):
        for options in (["--snap", "1/10"], ["--hull"]):
            text = text_of(run(scc, "shape", mesh, *options, "--json"))
            name = "diagnostics" if '"scc-diagnostics"' in text else "shape"
            check(name, text, f"shape {mesh} {options[0]}")
        mend = ["--grid", "1/64", "--weld", "--orient", "--merge"]
        for command, title in (("shape", "shape"), ("decompose", "decomposition")):
            for options in ([], mend):
                text = text_of(run(scc, command, mesh, *options, "--json"))
                name = "diagnostics" if '"scc-diagnostics"' in text else title
                document = check(name, text, f"{command} {mesh} {' '.join(options)}")
                told = [m["by"] for m in (document or {}).get("mended", [])]
                if command == "decompose" and told[-1:] == ["triangles"]:
                    told.pop()  # faces that are not flat are cut without being asked for
                wanted = [] if name == "diagnostics" else [o[2:] for o in options if o.startswith("--")]
                count(told == wanted, f"{command} {mesh}", f"{told} is told to be mended")
    text = text_of(run(scc, "decompose", "specs/models/parts/clamp.obj", "--seconds", "1e-9", "--json"))
    check("diagnostics" if '"scc-diagnostics"' in text else "decomposition", text, "decompose within no time")
    for model in ["specs/models/hexokinase.sc:Cube", "specs/models/hexokinase.sc:Nothing"]:
        result = run(scc, "shape", model, "--json")
        check("shape" if result.returncode == 0 else "diagnostics", text_of(result), f"shape {model}")


def check_inflations(scc):
    icon = "specs/models/parts/hexokinase.svg"
    for options in ([], ["--profile", "round", "--faces", "60"], ["--resolution", "1"], ["--faces", "all"]):
        check("inflate", text_of(run(scc, "inflate", icon, *options, "--json")), f"inflate {options}")
    for icon, *options in [[icon, "--piece", "2"], ["README.md"], [icon, "--strength", "0"]]:
        check("diagnostics", text_of(run(scc, "inflate", icon, *options, "--json")), f"inflate {icon} {options}")


def check_comparisons(scc):
    models = "specs/models/"
    for first, second, *options in [
        ("hexokinase.sc", "hexokinase.sc"),
        ("figure7.sc", "figure7-offset.sc", "--modulo", "weak"),
        ("dimer.sc", "dimers.sc", "--modulo", "timed"),
        ("chain.sc", "chain.sc", "--left", "n=3", "--right", "n=4", "--modulo", "trace"),
        ("chain.sc", "chain.sc", "--states", "2"),
        ("chain.sc", "nothing.sc"),
    ]:
        result = run(scc, "compare", models + first, models + second, "--json", *options)
        name = "diagnostics" if result.returncode == 3 else "compare"
        document = check(name, text_of(result), f"compare {first} {second}")
        if document is not None:
            count(document["exit"] == result.returncode, f"compare {first} {second}", "another exit code")


def check_answer(request, answer, what):
    name = "error" if "error" in answer else request["method"] + ".result"
    told = answer.get("error") or answer["result"]
    error = jsonschema.exceptions.best_match(validator("oracle#" + name).iter_errors(told))
    if error is None and name != "error":  # what is answered fits its schema, too
        error = jsonschema.exceptions.best_match(
            validator(f"oracle#{request['method']}.params").iter_errors(request.get("params", {}))
        )
    count(error is None, what, "" if error is None else error.message[:300])


def check_oracle(scc):
    """Its tests' messages, and every model with runs of it."""
    with open("test/unit/oracle/messages.jsonl", encoding="utf-8") as file:
        lines = [line.rstrip("\n") for line in file]
    known = [model for model in sorted(glob.glob("specs/models/*.sc")) if not is_open(model)]
    for number, model in enumerate(known):
        with open(model, encoding="utf-8") as file:
            load = {"text": file.read()}
        handle = f"m{number + 3}"
        replay = {"model": handle, "choose": {"random": 3}, "steps": 30}
        for method, params in [
            ("model.load", load),
            ("successors", {"model": handle, "states": "all"}),
            ("replay", replay),
        ]:
            # Tests have smaller numbers.
            request = {"jsonrpc": "2.0", "id": 10000 + len(lines), "method": method, "params": params}
            lines.append(json.dumps(request))
    result = subprocess.run([scc, "oracle"], input="\n".join(lines).encode(), capture_output=True)
    answers = {}
    for line in text_of(result).splitlines():
        answer = json.loads(line)
        for one in answer if isinstance(answer, list) else [answer]:
            answers[json.dumps(one["id"])] = one
            if one["id"] is None:
                check_answer({}, one, f"oracle: {line[:60]}")
    for line in lines:
        try:
            request = json.loads(line)
        except ValueError:
            continue
        if isinstance(request, dict) and isinstance(request.get("id"), int) and "params" in request:
            check_answer(request, answers[json.dumps(request["id"])], f"oracle: {line[:60]}")


def check_successors(scc, model, states=12):
    """The first states of a model, asked for in lines, runs to those that meet a goal, and lines that are none of
    either; and the texts of the frames that tell of the initial state."""
    validate = validator("successors")
    words = [scc, "successors", model]
    pipe = subprocess.PIPE
    filter = subprocess.Popen(words, stdin=pipe, stdout=pipe, stderr=subprocess.DEVNULL, text=True)

    def told(kind):
        document = json.loads(filter.stdout.readline(), parse_float=no_float)
        error = jsonschema.exceptions.best_match(validate.iter_errors(document))
        ok = error is None and kind in document
        count(ok, f"successors {model}", error and f"{error.json_path}: {error.message[:300]}" or f"no {kind}")
        return document if ok else {}

    def ask(line, kind):
        filter.stdin.write(line + "\n")
        filter.stdin.flush()
        return told(kind)

    header = told("initial")
    initial = header.get("initial", {"state": "", "goals": []})
    found, shown = {initial["state"]: []}, set()
    for state in found_in_turn(found, states):
        answer = ask(state, "follows")
        for goal, truth in enumerate(answer.get("goals", [])):
            if truth is True and goal not in shown and header["goals"][goal]["within"] is None:
                shown.add(goal)
                ask(json.dumps({"goal": goal, "choices": found[state]}), "schedule")
        for choice, next in enumerate(answer.get("successors", [])):
            found.setdefault(next["state"], found[state] + [choice])
    ask("0g", "error")
    ask('{"goal": 100000, "choices": []}', "error")
    filter.stdin.close()
    filter.wait()
    body = struct.pack("<3I", 1, 1, len(initial["state"]) // 2) + bytes.fromhex(initial["state"])
    frames = subprocess.run(words + ["--framing", "batches"], input=struct.pack("<I", len(body)) + body, capture_output=True)
    at = frames.stdout.index(b"\n") + 1
    for name in ("moves_text", "targets_text"):
        size, *_, text = struct.unpack_from("<4I", frames.stdout, at)
        at += 4 + size
        if text > 0:
            check(f"successors#{name}", frames.stdout[at - text:at].decode(), f"successors {model}: {name}")


def found_in_turn(found, most):
    """Breadth first: more may be found while it goes on."""
    for number in range(most):
        if number >= len(found):
            return
        yield list(found)[number]


# What a reader may take though the schema refuses it: members that it does not know, null for a member that may be left
# out, and numbers as people write them.
TAKEN = ("member added", "null", "number", "text")


def check_formats(documents, count_each):
    """What scc reads is what the schemas accept."""
    verdicts = {}
    for line in subprocess.run([documents, str(count_each)], capture_output=True, check=True).stdout.splitlines():
        sample = json.loads(line)
        accepted = validator(sample["schema"]).exact.is_valid(sample["document"])
        verdicts.setdefault(sample["schema"], set()).add(accepted)
        ok = accepted == sample["read"] or sample["read"] and sample["change"] in TAKEN
        told = "accepted" if accepted else "refused"
        count(ok, f"a document of {sample['schema']}", f"{told} by the schema alone: {line.decode('utf-8')[:400]}")
    for name, kinds in verdicts.items():
        count(len(kinds) == 2, f"random documents of {name}", "all of them are accepted, or all are refused")


def main():
    scc = sys.argv[1]
    if len(sys.argv) > 3:
        check_formats(sys.argv[3], 40)
    for name in sorted(SCHEMAS):
        try:
            jsonschema.Draft202012Validator.check_schema(SCHEMAS[name])
            count(True, name)
        except jsonschema.exceptions.SchemaError as error:
            count(False, name, str(error)[:300])
    with tempfile.TemporaryDirectory() as folder:
        for number, model in enumerate(sorted(glob.glob("specs/models/*.sc")) + [LOTS]):
            check_model(scc, model, folder)
            check_sarif(scc, model, folder)
            check_view(scc, model, twice=number % 8 == 0)
            if is_open(model):
                if not has_laws(model):
                    check_zones(scc, model)
            else:
                check_trace(scc, model)
                check_trace(scc, model, "--states=ends")
                check_simulation(scc, model)
                check_graphs(scc, model, folder)
                check_successors(scc, model)
        for model in sorted(glob.glob("specs/conformance/invalid/*.sc")):
            check_sarif(scc, model, folder)
        check_slowing(scc, folder)
        check_ranges(scc, folder)
        check_invariants(scc, folder)
        check_reasons(scc, folder)
    check_conformance()
    check_refusals(scc)
    check_shapes(scc)
    check_inflations(scc)
    check_comparisons(scc)
    check_oracle(scc)
    check_estimates(scc)
    check_sweeps(scc)
    print(f"{PASSED} passed, {FAILED} failed")
    if len(sys.argv) > 2:
        with open(sys.argv[2], "w", encoding="utf-8") as file:
            file.write(f"{PASSED} passed, {FAILED} failed\n")
    return 1 if FAILED else 0


sys.exit(main())
