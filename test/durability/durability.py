#!/usr/bin/env python3
"""Explorations and runs that are kept, and what becomes of them: killed, interrupted, on full disks and with damaged files.

    durability.py SCC [--instants N] [--seed N] [--only NAME] [--few]

Whatever happens to a run with --store, the same command ends with the report of a run that nothing happened to, to
the byte, or refuses the store with a code. --few is a part of it that takes some seconds. The last line is
'N passed, N failed'.
"""
import argparse
import contextlib
import glob
import os
import random
import resource
import shutil
import signal
import sqlite3
import subprocess
import sys
import tempfile
import time

MODELS = "specs/models/"
BENCH = "test/bench/"

# All kinds of property, and of option that an exploration depends on.
EXPLORATIONS = {
    "invariant": [BENCH + "checker/bonds.sc", "-D", "n=15"],
    "hexokinase": [BENCH + "checker/hexokinase.sc", "-D", "n=4"],
    "by time": [BENCH + "checker/hexokinase.sc", "-D", "n=3", "--shortest", "time"],
    "depth": [BENCH + "checker/hexokinase.sc", "-D", "n=4", "--depth", "300"],
    "states": [MODELS + "gas.sc", "-D", "n=3", "--states", "3000"],
    "dimers": [BENCH + "dimers.sc", "-D", "n=6"],
    "nested": [MODELS + "glycolysis.sc"],
    "bounded time": [MODELS + "glycolysis.sc", "--time", "4"],
    "slices": [MODELS + "crowded.sc"],
    "no reduction": [MODELS + "crowded.sc", "--no-reduce", "all", "--depth", "12"],
    "probabilities": [MODELS + "brownian.sc"],
    "rates": [MODELS + "dissociation.sc"],
    "cycles": [MODELS + "cradle.sc"],
    "rigid": [MODELS + "tumbling.sc"],
    "binding": [MODELS + "crosslink.sc"],
    "enzyme": [MODELS + "enzyme.sc", "--json"],
    "association": [MODELS + "association.sc", "--full"],
    "coverage": [MODELS + "enzyme.sc", "--coverage"],
    "invariants": [MODELS + "gas.sc", "--prove"],
    "pegs": [MODELS + "pegs.sc"],
    "fingerprints": [BENCH + "checker/hexokinase.sc", "-D", "n=4", "--hash-compact"],
    "fingerprints, found": [MODELS + "enzyme.sc", "--hash-compact", "--full"],
    "estimate": ["estimate", MODELS + "brownian.sc", "--runs", "15"],
    "estimate, by width": ["estimate", MODELS + "ruin.sc", "--most", "60", "--json"],
    "simulate": ["simulate", MODELS + "ruin.sc", "--runs", "400", "--observe", "x(walker)", "--every", "1", "--until", "40"],
    "summary": [
        *["simulate", MODELS + "brownian.sc", "--runs", "300", "--observe", "x(ligand)"],
        *["--every", "1", "--until", "20", "--summary"],
    ],
    "sweep": ["sweep", BENCH + "checker/hexokinase.sc", "-D", "n=1..3"],
}
FEW = ["hexokinase", "by time", "slices", "probabilities", "coverage", "fingerprints", "estimate", "sweep"]
QUICK = ["by time", "probabilities", "estimate", "sweep"]
# What is not the work of scc check.
OTHERS = ["estimate", "simulate", "sweep"]
# Commands that a limit of seconds ends: sweep takes it for each point.
WITH_SECONDS = ["check", "estimate"]


# Longer than any test waits.
LONG = [BENCH + "checker/hexokinase.sc", "-D", "n=6", "--states", "10000000"]


class Tally:
    def __init__(self):
        self.passed = self.failed = 0

    def check(self, good, what):
        if good:
            self.passed += 1
        else:
            self.failed += 1
            print("FAILED:", what, flush=True)


def command(scc, args, store=None):
    words = args if args[0] in OTHERS else ["check", *args]
    return [scc, *words] + (["--store", store] if store else [])


def run(cmd, **how):
    done = subprocess.run(cmd, capture_output=True, text=True, timeout=600, **how)
    return done.returncode, done.stdout, done.stderr


def killed_after(cmd, seconds, how=signal.SIGKILL):
    """Runs a command, and sends a signal after some seconds. Whether it was still running."""
    process = subprocess.Popen(cmd, stdout=subprocess.PIPE, stderr=subprocess.PIPE, start_new_session=True)
    try:
        process.communicate(timeout=seconds)
        return False
    except subprocess.TimeoutExpired:
        process.send_signal(how)
        process.communicate(timeout=600)
        return True
    finally:
        # Processes that worked for it end by themselves.
        if process.poll() is None:
            process.kill()


def models(scc, folder, tally):
    """Every model by one, two and four processes, kept, and from what was kept."""
    count = 0
    for path in sorted(glob.glob(MODELS + "*.sc") + glob.glob(MODELS + "laws/*.sc") + glob.glob(BENCH + "*.sc")):
        args = [path, "--states", "2000"]
        expected = run(command(scc, args + ["--jobs", "1"]))
        for jobs in ["2", "4"]:
            tally.check(run(command(scc, args + ["--jobs", jobs])) == expected, f"{path} by {jobs} processes")
        store = os.path.join(folder, "of model")
        kept = run(command(scc, args + ["--jobs", "2"], store))
        if code_of(kept[2]) == "SC0901":
            continue
        tally.check(kept == expected, f"{path}, kept")
        tally.check(run(command(scc, args, store)) == expected, f"{path}, from what was kept")
        shutil.rmtree(store)
        count += 1
    print(f"{count} models", flush=True)


def code_of(stderr):
    at = stderr.find("error[SC")
    return stderr[at + 6 : at + 12] if at >= 0 else None


def kills(scc, names, instants, chance, folder, tally):
    hit = 0
    for name in names:
        args = EXPLORATIONS[name]
        began = time.time()
        expected = run(command(scc, args))
        lasts = time.time() - began
        for k in range(instants):
            store = os.path.join(folder, f"kill-{name}-{k}")
            jobs = chance.choice([[], ["--jobs", "1"], ["--jobs", "2"]])
            cmd = command(scc, args + jobs, store)
            times = chance.choice([1, 1, 2, 3])
            for _ in range(times):
                hit += killed_after(cmd, chance.uniform(0.02, 1.2 * lasts + 0.05))
            again = run(cmd)
            tally.check(again == expected, f"{name}, killed {times} times: another report\n{again}\n{expected}")
            tally.check(run(cmd) == expected, f"{name}: another report from a store that has all")
            shutil.rmtree(store, ignore_errors=True)
    print(f"{hit} runs were killed while they went on", flush=True)


def interruptions(scc, names, chance, folder, tally):
    for name in names:
        args = EXPLORATIONS[name]
        began = time.time()
        expected = run(command(scc, args))
        lasts = time.time() - began
        store = os.path.join(folder, "interrupted")
        cmd = command(scc, args, store)
        killed_after(cmd, chance.uniform(0.05, lasts), signal.SIGINT)
        tally.check(run(cmd) == expected, f"{name}: another report after an interruption")
        if cmd[1] in WITH_SECONDS:
            run(cmd + ["--seconds", "0.05"])
            tally.check(run(cmd) == expected, f"{name}: another report after a limit of seconds")
        shutil.rmtree(store)


def with_workers_killed(cmd, chance, most, longest, hows):
    """Runs a command, and kills processes that work for it, with seconds between that vary. What it gave, and how many."""
    process = subprocess.Popen(cmd, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    hit = 0
    while process.poll() is None and hit < most:
        time.sleep(chance.uniform(0.0005, longest))
        try:
            with open(f"/proc/{process.pid}/task/{process.pid}/children") as file:
                children = file.read().split()
            if children:
                os.kill(int(chance.choice(children)), chance.choice(hows))
                hit += 1
        except OSError:
            pass
    out, err = process.communicate(timeout=600)
    return (process.returncode, out, err), hit


# Their work takes long enough to be hit.
KILLED = {
    "by one": ["estimate", MODELS + "ruin.sc", "--runs", "1500", "--jobs", "1"],
    "runs, observed": ["simulate", MODELS + "ruin.sc", "--runs", "1500", "--observe", "x(walker)", "--every", "1", "--until", "40"],
    "points": ["sweep", BENCH + "checker/hexokinase.sc", "-D", "n=1..4", "--jobs", "3"],
}


def workers(scc, names, trials, chance, tally):
    """Processes that work for it are killed: the same report. Those that are killed for ever end it, with a word."""
    cases = {name: EXPLORATIONS[name] + ["--jobs", "2"] for name in names} | KILLED
    for name, args in cases.items():
        expected = run(command(scc, args))
        hit = 0
        for _ in range(trials):
            # Less often than those who have one task give up.
            got, killed = with_workers_killed(
                command(scc, args), chance, 9, 0.05, [signal.SIGKILL, signal.SIGTERM, signal.SIGSEGV, signal.SIGABRT]
            )
            hit += killed
            tally.check(got == expected, f"{name}, {killed} workers killed: another report\n{got}\n{expected}")
        print(f"{name}: {hit} workers killed", flush=True)
    # One task that takes longer than ten processes live.
    longer = ["sweep", LONG[0], "-D", "n=6", "--states", "10000000"]
    (code, _, err), _ = with_workers_killed(command(scc, longer), chance, 1000, 0.01, [signal.SIGKILL])
    tally.check(
        code == 4 and "point 0 is lost: 10 processes in a row" in err and "was killed, as when memory runs out" in err,
        f"a task whose processes are killed for ever: exit code {code}\n{err}",
    )


def scarce(scc, names, tally):
    """The system gives few processes and places for open files: the same report, by fewer processes; or a word."""
    for name in names:
        cmd = command(scc, EXPLORATIONS[name] + ["--jobs", "3"])
        expected = run(cmd)
        for files in [5, 7, 9, 16]:
            got = run(cmd, preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_NOFILE, (files, files)))
            is_told = got[0] in (3, 4, 127) and "Too many open files" in got[2] or "Error 24" in got[2]
            tally.check(got == expected or is_told, f"{name}, {files} open files: {got}")
        tally.check(got == expected, f"{name}, 16 open files: {got}")
        if os.geteuid() == 0:

            def alone():
                os.setuid(65534)
                resource.setrlimit(resource.RLIMIT_NPROC, (1, 1))

            got = run(cmd, preexec_fn=alone)
            tally.check(got == expected, f"{name}, no other process: {got}")


def full_disks(scc, names, chance, folder, tally):
    """Files may not grow beyond some size."""
    for name in names:
        args = EXPLORATIONS[name]
        expected = run(command(scc, args))
        store = os.path.join(folder, "full")
        run(command(scc, args, store))
        whole = sum(os.path.getsize(os.path.join(store, f)) for f in os.listdir(store))
        shutil.rmtree(store)
        for share in [0.001, chance.uniform(0.1, 0.9)]:
            most = max(1, int(share * whole))

            def limited():
                signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
                resource.setrlimit(resource.RLIMIT_FSIZE, (most, most))

            code, out, err = run(command(scc, args, store), preexec_fn=limited)
            told = code_of(err) or (out.startswith("{") and "SC0103" in out and "SC0103")
            tally.check(
                (code in (1, 2, 74) and told == "SC0103") or (code == 3 and told == "SC0910") or (code, out, err) == expected,
                f"{name} with {most} bytes of {whole}: exit code {code}, {err}",
            )
            warned = told != "SC0103" or "warning[SC0103]" in err
            tally.check(warned, f"{name} with {most} bytes of {whole}: no warning\n{err}")
            tally.check(run(command(scc, args, store)) == expected, f"{name}: another report after a full disk")
            shutil.rmtree(store)
    warned_at_once(scc, os.path.join(folder, "full at once"), tally)


def warned_at_once(scc, store, tally):
    """What cannot be kept is told while the exploration goes on."""

    def limited():
        signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
        resource.setrlimit(resource.RLIMIT_FSIZE, (100000, 100000))

    process = subprocess.Popen(
        command(scc, LONG, store), stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, preexec_fn=limited
    )
    line = process.stderr.readline()
    tally.check("warning[SC0103]" in line and process.poll() is None, f"a full disk is not told at once: {line}")
    process.kill()
    process.wait()
    process.stderr.close()
    shutil.rmtree(store)


PAGE = 16384


def changed(bytes_, chance):
    """A file with a fault in it: what, and the bytes."""
    new = bytearray(bytes_)
    pages = len(bytes_) // PAGE
    page = chance.randrange(pages) * PAGE
    kind = chance.choice(["cut", "cut to pages", "bit", "bit", "header", "head of a page", "zeros", "another page", "longer"])
    if kind == "cut":
        at = chance.randrange(len(bytes_))
        return f"cut to {at}", new[:at]
    if kind == "cut to pages":
        return f"cut to {page}", new[:page]
    if kind == "longer":
        return "longer", new + bytes(PAGE)
    if kind in ("zeros", "another page"):
        other = chance.randrange(pages) * PAGE
        new[page : page + PAGE] = bytes(PAGE) if kind == "zeros" else bytes_[other : other + PAGE]
        return f"page at {page}: {kind}", new
    most = {"bit": len(bytes_), "header": 100, "head of a page": 24}[kind]
    at, bit = (page if kind == "head of a page" else 0) + chance.randrange(most), chance.randrange(8)
    new[at] ^= 1 << bit
    return f"bit {bit} of byte {at}", new


def shorten(file, chance):
    """A store as if the process had been killed: the first blocks of each exploration, and not all."""
    with contextlib.closing(sqlite3.connect(file)) as database:
        keep = chance.randrange(1 + database.execute("SELECT max(number) FROM blocks").fetchone()[0])
        database.execute("DELETE FROM blocks WHERE number >= ?", (keep,))
        database.commit()
        database.execute("VACUUM")


def stores(scc, args, folder, chance):
    """A store that has all, and one that has a part."""
    whole, part = os.path.join(folder, "whole"), os.path.join(folder, "part")
    run(command(scc, args, whole))
    shutil.copytree(whole, part)
    shorten(os.path.join(part, "explorations.sqlite"), chance)
    return whole, part


def damage(scc, names, trials, chance, folder, tally):
    """A file that was cut or changed: refused as damaged, or of no matter; never another report, and never an output
    that cannot be written. Only what the number of its version tells may be something else."""
    refused = count = 0
    for name in names:
        args = EXPLORATIONS[name]
        expected = run(command(scc, args))
        for good in stores(scc, args, folder, chance):
            with open(os.path.join(good, "explorations.sqlite"), "rb") as stream:
                bytes_ = stream.read()
            for k in range(trials):
                what, new = changed(bytes_, chance)
                store = os.path.join(folder, "damaged")
                os.mkdir(store)
                with open(os.path.join(store, "explorations.sqlite"), "wb") as stream:
                    stream.write(new)
                if chance.random() < 0.2:
                    beside = chance.choice(["-wal", "-journal", "-shm"])
                    with open(os.path.join(store, "explorations.sqlite" + beside), "wb") as stream:
                        stream.write(chance.randbytes(chance.choice([0, 40, 5000])))
                    what += f", and a file {beside}"
                code, out, err = run(command(scc, args, store))
                told = code_of(err) or next((c for c in ["SC0910", "SC0911", "SC0912"] if c in out), None)
                version = new[60:64] != bytes_[60:64]
                is_refused = code == 3 and (told == "SC0912" or (told == "SC0911" and version))
                count += 1
                refused += is_refused
                tally.check(
                    is_refused or (code, out, err) == expected,
                    f"{name}, {what} of {len(bytes_)}: exit code {code}\n{out}\n{err}",
                )
                shutil.rmtree(store)
            shutil.rmtree(good)
    print(f"{refused} of {count} damaged stores refused", flush=True)


def content(store):
    return {name: open(os.path.join(store, name), "rb").read() for name in sorted(os.listdir(store))}


def read_only_ways(store):
    """How a folder is kept from being written to, as far as this system lets it: a name, a prefix of commands, what to do
    before, and after."""
    file = os.path.join(store, "explorations.sqlite")

    def modes(folder, inside):
        os.chmod(file, inside)
        os.chmod(store, folder)

    other = ["setpriv", "--reuid", "65534", "--clear-groups"] if os.geteuid() == 0 else []
    nothing = lambda: None
    for what, folder, inside in [("folder", 0o555, 0o644), ("file", 0o777, 0o444), ("folder and file", 0o555, 0o444)]:
        yield f"the modes of {what}", other, lambda f=folder, i=inside: modes(f, i), lambda: modes(0o777, 0o644)
    if os.geteuid() == 0:
        attribute = lambda sign: subprocess.run(["chattr", sign + "i", file, store], capture_output=True)
        attribute("+").returncode == 0 and attribute("-")
        yield "attributes", [], lambda: attribute("+"), lambda: attribute("-")
        mount = 'mount --bind "$0" "$0" && mount -o remount,bind,ro "$0" && exec "$@"'
        yield "a mount", ["unshare", "-m", "sh", "-c", mount, store], nothing, nothing


def read_only(scc, names, chance, folder, tally):
    """A store that nobody can write to is read; what it has not is found, and a word tells that it is not kept."""
    os.chmod(folder, 0o755)
    ways = set()
    for name in names:
        args = EXPLORATIONS[name]
        expected = run(command(scc, args))
        for good, is_whole in zip(stores(scc, args, folder, chance), [True, False]):
            for way, prefix, before, after in read_only_ways(good):
                if prefix and run(prefix + ["true"])[0] != 0:
                    continue
                kept = content(good)
                before()
                try:
                    code, out, err = run(prefix + command(scc, args, good))
                finally:
                    after()
                same = (code, out, err) == expected
                told = code == 74 and "SC0103" in err and "not kept" in err and (out == expected[1] or out.startswith("{"))
                tally.check(same if is_whole else told, f"{name}, {way}: exit code {code}\n{out}\n{err}")
                tally.check(content(good) == kept, f"{name}, {way}: it was written to")
                ways.add(way)
            shutil.rmtree(good)
    print(f"read-only by {', '.join(sorted(ways))}", flush=True)


def refusals(scc, folder, tally):
    model = [BENCH + "checker/hexokinase.sc", "-D", "n=3"]

    def expect(what, cmd, exit_code, code, text, **how):
        got, out, err = run(cmd, **how)
        tally.check(
            got == exit_code and code_of(err) == code and text in err, f"{what}: exit code {got}\n{out}\n{err}"
        )

    store = os.path.join(folder, "of three")
    expected = run(command(scc, model))
    tally.check(run(command(scc, model, store)) == expected, "a new store")
    n4 = [BENCH + "checker/hexokinase.sc", "-D", "n=4"]
    expect("another parameter", command(scc, n4, store), 3, "SC0911", "parameter n is 3 there, and 4 here")
    expect("another model", command(scc, [MODELS + "chain.sc", "-D", "n=3"], store), 3, "SC0911", "the model is")
    expect("another option", command(scc, model + ["--depth", "5"], store), 3, "SC0911", "--depth is default there, and 5 here")
    expect("no reduction", command(scc, model + ["--no-reduce", "jump"], store), 3, "SC0911", "--no-reduce is")
    tally.check(run(command(scc, model + ["--seconds", "60"], store)) == expected, "limits of resources do not differ")

    plain = os.path.join(folder, "plain")
    with open(plain, "w") as file:
        file.write("a file\n")
    expect("a file", command(scc, model, plain), 3, "SC0910", "it is a file")
    expect("below a file", command(scc, model, os.path.join(plain, "x")), 3, "SC0910", "")
    other = os.path.join(folder, "other")
    os.mkdir(other)
    with open(os.path.join(other, "letter"), "w") as file:
        file.write("dear\n")
    expect("a folder of other things", command(scc, model, other), 3, "SC0910", "holds other things")
    garbage = os.path.join(folder, "garbage")
    os.mkdir(garbage)
    with open(os.path.join(garbage, "explorations.sqlite"), "wb") as file:
        file.write(b"no database at all" * 1000)
    expect("no database", command(scc, model, garbage), 3, "SC0912", "damaged")

    if os.geteuid() == 0:
        how = {"preexec_fn": lambda: os.setuid(65534)}
        os.chmod(folder, 0o755)
    else:
        how = {}
    locked = os.path.join(folder, "locked")
    os.mkdir(locked, 0o555)
    expect(
        *["a folder that is not ours to write", command(scc, model, os.path.join(locked, "x")), 3, "SC0910"],
        "cannot be made", **how,
    )
    expect("an empty folder, the same", command(scc, model, locked), 3, "SC0910", "cannot be written to", **how)
    killed = os.path.join(folder, "killed")
    shutil.copytree(store, killed)
    with open(os.path.join(killed, "explorations.sqlite-wal"), "wb") as file:
        file.write(bytes(100))
    os.chmod(killed, 0o555)
    expect("read-only, and not ended", command(scc, model, killed), 3, "SC0910", "was killed: copy it", **how)
    os.chmod(killed, 0o755)

    busy = os.path.join(folder, "busy")
    first = subprocess.Popen(command(scc, LONG, busy), stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    try:
        # Who has written is the one to whom the database belongs.
        journal = os.path.join(busy, "explorations.sqlite-wal")
        while not (os.path.exists(journal) and os.path.getsize(journal) > 0):
            time.sleep(0.01)
        expect("two at once", command(scc, LONG, busy), 3, "SC0910", "another process")
    finally:
        first.kill()
        first.wait()

    ranged = [MODELS + "moment.sc"]
    got, _, err = run(command(scc, ranged, os.path.join(folder, "ranged")))
    tally.check(got == 3 and code_of(err) == "SC0901", f"sets of states: exit code {got}, {err}")
    for jobs in ["0", "10000", "x"]:
        for words in [model, EXPLORATIONS["estimate"], EXPLORATIONS["simulate"], EXPLORATIONS["sweep"]]:
            got, _, err = run(command(scc, words + ["--jobs", jobs]))
            tally.check(got == 64 and "--jobs" in err, f"--jobs {jobs}: exit code {got}, {err}")

    compact = model + ["--hash-compact"]
    expect("hash compaction", command(scc, compact, store), 3, "SC0911", "--hash-compact is not given there, and given here")
    of_runs = os.path.join(folder, "of runs")
    estimate = ["estimate", MODELS + "ruin.sc", "--runs", "30"]
    expected = run(command(scc, estimate))
    tally.check(run(command(scc, estimate, of_runs)) == expected, "runs")
    more = ["estimate", MODELS + "ruin.sc", "--runs", "50"]
    tally.check(run(command(scc, more, of_runs)) == run(command(scc, more)), "more runs")
    tally.check(run(command(scc, estimate, of_runs)) == expected, "less runs, from those of more")
    expect("other runs", command(scc, estimate + ["--seed", "1"], of_runs), 3, "SC0911", "--seed is 0 there, and 1 here")
    others = command(scc, [MODELS + "ruin.sc"], of_runs)
    expect("no exploration", others, 3, "SC0911", "runs of scc estimate there, and explorations of scc check here")
    resumed = ["--format", "jsonl", "--resume", plain]
    for name in ["simulate", "sweep"]:
        got, _, err = run(command(scc, EXPLORATIONS[name] + resumed, os.path.join(folder, "both")))
        tally.check(got == 64 and "--resume does not go with --store" in err, f"{name}: exit code {got}, {err}")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("scc")
    parser.add_argument("--instants", type=int, default=10, help="at which each exploration is killed")
    parser.add_argument("--damages", type=int, default=40, help="of each of some stores")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--only", help="one exploration")
    parser.add_argument("--few", action="store_true")
    options = parser.parse_args()
    scc = os.path.abspath(options.scc)
    chance = random.Random(options.seed)
    names = [options.only] if options.only else FEW if options.few else list(EXPLORATIONS)
    some = [name for name in names if name in FEW] or names
    instants = 2 if options.few else options.instants
    damages = 8 if options.few else options.damages
    tally = Tally()
    with tempfile.TemporaryDirectory() as folder:
        refusals(scc, folder, tally)
        if not options.few and not options.only:
            models(scc, folder, tally)
        kills(scc, names, instants, chance, folder, tally)
        most = QUICK if options.few else some
        interruptions(scc, most, chance, folder, tally)
        workers(scc, (OTHERS + some)[: 5 if options.few else 9], 1 if options.few else 10, chance, tally)
        scarce(scc, ["hexokinase"] + OTHERS, tally)
        full_disks(scc, most, chance, folder, tally)
        damage(scc, (OTHERS + some)[:6] if not options.few else ["estimate", "by time"], damages, chance, folder, tally)
        read_only(scc, (OTHERS + some)[:6] if not options.few else ["estimate", "by time"], chance, folder, tally)
    print(f"{tally.passed} passed, {tally.failed} failed")
    return 1 if tally.failed else 0


if __name__ == "__main__":
    sys.exit(main())
