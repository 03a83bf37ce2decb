#!/usr/bin/env python3
"""Interrupts scc simulate, estimate and trace at several instants: runs that are under way are written as far as they
came, what is written is true of the whole runs, and simulations go on where they ended.

    interrupted_runs_test.py SCC
"""

import csv
import io
import json
import os
import signal
import subprocess
import sys
import tempfile
import time

MODEL = """timestep 1 steady
import <solids>
fixed room = solids.Room(6, 6, 1, 1)
for i in 1..4 { process c[i] = solids.Cube(1) mass 1 at translate ((i - 5/2) * 3/2, i - 5/2, 0) [nil] }
motion choose { (1,0,0), (-1,0,0), (0,1,0), (0,-1,0) }
check low : P = ? [ eventually x(c[1]) < -20 within 600 ]
check mean : E = ? [ 1/(x(c[1]) + 1/3) at 600 ]
"""

WHOLE = 3
MANY = 1000
UNTIL = 600
OBSERVED = ["--observe", "x(c[1])", "--observe", "vx(c[2])", "--every", "7", "--until", str(UNTIL), "--seed", "5"]
INSTANTS = [0, 0.03, 0.15, 0.4, 0.8]


def children(pid):
    with open("/proc/%d/task/%d/children" % (pid, pid)) as file:
        return [int(child) for child in file.read().split()]


def broken_off(command, seconds, number=signal.SIGINT, group=False):
    """The output, messages and exit code of a command, which gets a signal so many seconds after its workers began."""
    process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, start_new_session=True)
    while process.poll() is None and not children(process.pid):
        time.sleep(0.005)
    time.sleep(seconds)
    if group:
        os.killpg(process.pid, number)
    else:
        process.send_signal(number)
    out, err = process.communicate(timeout=60)
    return out, err, process.returncode


def is_prefix(values, whole):
    """Whether values are those of a whole run up to some time, and none from there on."""
    there = [row for row in values if row != [None, None]]
    return values == there + [[None, None]] * (len(values) - len(there)) and there == whole[:len(there)]


def check(what, good, *shown):
    if not good:
        sys.exit("%s\n%s" % (what, "\n".join(map(str, shown))))


def lines(text):
    return [json.loads(line) for line in text.splitlines()[1:]]


def simulations(scc, model, folder):
    def command(runs, *more):
        return [scc, "simulate", model, "--runs", str(runs), *OBSERVED, *more]

    def made(runs, *more):
        return subprocess.run(command(runs, *more), stdout=subprocess.PIPE, text=True, check=True).stdout

    text = made(WHOLE, "--format", "jsonl")
    whole = [run["values"] for run in lines(text)]
    cut = far = 0
    cases = [(s, jobs, number, group) for s in INSTANTS for jobs, number, group in
             [(1, signal.SIGINT, False), (2, signal.SIGTERM, True)]]
    for case in cases:
        seconds, jobs, number, group = case
        out, err, code = broken_off(command(MANY, "--format", "jsonl", "--jobs", str(jobs)), seconds, number, group)
        runs = lines(out)
        partly = [run for run in runs if run.get("interrupted")]
        check("it is stopped: %s" % (case,), code == 4 and len(partly) <= jobs, code, err)
        check("runs are in order: %s" % (case,), [run["run"] for run in runs] == list(range(len(runs))), out)
        told = "interrupted after %d of %d runs" % (len(runs) - len(partly), MANY)
        check("it says so: %s" % (case,), told in err and ("as far as" in err) == bool(partly), err)
        for run, values in zip(runs, whole):
            check("what is written is true: %s" % (case,),
                  is_prefix(run["values"], values) if run.get("interrupted") else run["values"] == values, run)
        for run in partly:
            check("it says where it ended", run["ended"].startswith("interrupted after "), run)
        cut += len(partly)
        far += sum(run["values"][1] != [None, None] for run in partly)
        if jobs == 2 and runs:
            path = os.path.join(folder, "runs.jsonl")
            with open(path, "w") as file:
                file.write(out)
            made(WHOLE, "--format", "jsonl", "--resume", path)
            with open(path) as file:
                again = file.read()
            first = "".join(again.splitlines(True)[:WHOLE + 1])
            check("it goes on where it ended: %s" % (case,), first == text and '"interrupted"' not in again, again)
    check("runs are cut off", cut >= len(INSTANTS) and far >= 2, cut, far)
    tables(command, whole)
    kept(command, text, folder)


def tables(command, whole):
    # One run may end just before the signal, and the next not have begun.
    for _ in range(4):
        out, _, code = broken_off(command(MANY), INSTANTS[-1])
        rows = list(csv.DictReader(io.StringIO(out)))
        last = [row for row in rows if row["ended"].startswith("interrupted after ")]
        if last:
            break
    check("a table has it too", code == 4 and last and last[0]["x(c[1])"] == whole[0][0][0].replace("/1", ""), out[-300:])
    out, _, code = broken_off(command(MANY, "--summary"), INSTANTS[-1])
    first = next(csv.DictReader(io.StringIO(out)))
    check("and a summary", code == 4 and int(first["count"]) >= 1, out)


def kept(command, text, folder):
    """A store has no run that was interrupted."""
    store = ["--format", "jsonl", "--store", os.path.join(folder, "store")]
    out, _, _ = broken_off(command(WHOLE * MANY, *store), INSTANTS[2])
    check("one is under way", lines(out)[-1].get("interrupted"), out)
    out = subprocess.run(command(WHOLE, *store), stdout=subprocess.PIPE, text=True, check=True).stdout
    check("it is made anew", out == text, out)


def estimates(scc, model):
    common = ["--json", "--free", "evenly", "--most", "100000000", "--steps", "10000000", "--width", "1/10000"]
    far = ["--property", "P = ? [ eventually x(c[1]) < -20 within 10000000 ]",
           "--property", "E = ? [ 1/(x(c[1]) + 1/3) at 10000000 ]"]
    for asked, jobs in [([], 1), ([], 2), (far, 1), (far, 2)]:
        out, _, code = broken_off([scc, "estimate", model, *common, *asked, "--jobs", str(jobs)], 0.3)
        report = json.loads(out)
        low, mean = report["properties"]
        value, cut = low["value"], low["too_long"]
        check("it is stopped", code == 4 and report["interrupted"], code)
        check("no more than the runs under way are open", cut <= jobs and low["no"] == low["runs"] - cut, low)
        check("they are there", cut >= 1 or not asked, low)
        if low["no"] == 0:
            check("and nothing is known", value is None and low["verdict"] == "undecided", low)
        else:
            check("and count so", value["low"] == "0/1" and value["high"] != "1/1", low)
        check("it says why", cut == 0 or any("the command was stopped" in why for why in low["reasons"]), low)
        check("they are left out of a mean without range",
              mean["too_long"] == 0 and mean["runs"] == low["runs"] - cut
              and (cut == 0 or any("left out" in why for why in mean["reasons"])), mean)


def traces(scc, model):
    command = [scc, "trace", model, "--choose", "random:1", "--steps", "100000000"]
    for states in ("all", "ends"):
        process = subprocess.Popen(command + ["--states", states], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        head = [process.stdout.readline() for _ in range(40)]
        process.send_signal(signal.SIGINT)
        rest, err = process.stdout.read(), process.stderr.read()
        process.wait()
        events = [json.loads(line) for line in head + rest.splitlines()]
        end = events[-1]
        check("a trace has an end", (end["type"], end["ending"]) == ("end", "interrupted"), end)
        check("of its last step", events[-2 if states == "all" else -3]["step"] == end["steps"], events[-3:])
        check("and its state", "state" in events[-2], events[-2])
        check("it is said", process.returncode == 4 and "interrupted" in err, err)


def main():
    scc = sys.argv[1]
    with tempfile.TemporaryDirectory() as folder:
        model = os.path.join(folder, "crowd.sc")
        with open(model, "w") as file:
            file.write(MODEL)
        simulations(scc, model, folder)
        estimates(scc, model)
        traces(scc, model)


if __name__ == "__main__":
    main()
