#!/usr/bin/env python3
"""The examples of clients/examples, by node and by R: what they print of models is what scc check and scc trace say.

    clients_check.py SCC WORK    exit code 3: node, or R with jsonlite, is not there
"""
import json
import os
import shutil
import subprocess
import sys

from common import MODELS, absent

EXAMPLES = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "..", "clients", "examples")
CHOSEN = ["hexokinase", "chain", "cradle", "dimer", "ring", "far"]  # their runs of first choices end
# What stands for the oracle, and what is said of it.
FAULTS = [
    ("absent", None, "cannot be started"),
    ("dead", "exit 3\n", "scc oracle has ended"),
    ("killed", "read -r line\nkill -9 $$\n", "scc oracle has ended"),
    ("silent", "exec sleep 600\n", "has not answered"),
    ("slow", "read -r line\nread -r line\nexec sleep 600\n", "has not answered"),
    ("babbling", "read -r line\necho 'Hello!'\ncat > /dev/null\n", "what is no JSON"),
    ("shy", "cat > /dev/null\n", "scc oracle has"),
    ("half", "read -r line\nprintf '{\"jsonrpc\": '\nexit 0\n", "scc oracle has"),
]


def wanted(scc, model):
    """The lines that a client should print of a model."""
    check = subprocess.run([scc, "check", model, "--json"], capture_output=True, text=True, check=False)
    lines = [f"{one['name']}: {one['text']}" for one in json.loads(check.stdout)["properties"]]
    trace = subprocess.run([scc, "trace", model, "--steps", "1000"], capture_output=True, text=True, check=True)
    time, ending = None, None
    for line in map(json.loads, trace.stdout.splitlines()):
        if line["type"] == "transition":
            lines.append(f"{time} {line['label']['text']}")
        time, ending = line.get("time", time), line.get("reason", ending)
    return lines, time


def main():
    scc = sys.argv[1]
    clients = []
    if shutil.which("node"):
        clients.append(["node", os.path.join(EXAMPLES, "oracle.js")])
    if shutil.which("Rscript"):
        has = subprocess.run(["Rscript", "-e", "library(jsonlite)"], capture_output=True, check=False)
        if has.returncode == 0:
            clients.append(["Rscript", os.path.join(EXAMPLES, "oracle.R")])
    if len(clients) < 2:
        absent("node, or R with jsonlite, is not there")
    passed = failed = 0
    for name in CHOSEN:
        model = os.path.join(MODELS, name + ".sc")
        lines, end = wanted(scc, model)
        for client in clients:
            done = subprocess.run([*client, scc, model], capture_output=True, text=True, timeout=300, check=False)
            got = done.stdout.splitlines()
            if done.returncode == 0 and got[:-1] == lines and got[-1].startswith(f"{end} "):
                passed += 1
            else:
                failed += 1
                print(f"{client[0]} {name}: {done.stderr}\n" + "\n".join(got[:40]))
    wrong = os.path.join(sys.argv[2], "wrong.sc")
    with open(wrong, "w", encoding="utf-8") as file:
        file.write("process p = nothing\n")
    for client in clients:
        done = subprocess.run([*client, scc, wrong], capture_output=True, text=True, timeout=60, check=False)
        if done.returncode == 1 and "the model is refused" in done.stderr:
            passed += 1
        else:
            failed += 1
            print(f"{client[0]}, a model that is refused: {done.returncode} {done.stderr}")
    for name, script, said in FAULTS:
        fault = os.path.join(sys.argv[2], name)
        if script is not None:
            with open(fault, "w", encoding="utf-8") as file:
                file.write("#!/bin/sh\n" + script)
            os.chmod(fault, 0o755)
        for client in clients:
            done = subprocess.run([*client, fault, os.path.join(MODELS, "far.sc"), "3"], capture_output=True, text=True, timeout=300, check=False)
            # One line of words, no trace of a stack.
            if done.returncode == 1 and said in done.stderr and len(done.stderr.splitlines()) <= 2 and "    at " not in done.stderr:
                passed += 1
            else:
                failed += 1
                print(f"{client[0]}, {name}: {done.returncode} {done.stderr}")
    print(f"{passed} passed, {failed} failed")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
