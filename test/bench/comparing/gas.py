"""The gas: the same cubes in the same box for the same time, by scc exactly and by rapier in fixed steps."""

import json
import os
import resource
import subprocess

from . import report

SIZES = [100, 1000, 10000]
TIME = 10
STEPS = ["1/60", "1/240"]
# By how much, in units of time, a peer's contact may be off and still count as the exact one. A body of these
# gases meets another or a wall about every three units.
TOLERANCE = 0.2
TIMEOUT = 600


def matched(exact, found, tolerance=TOLERANCE):
    """Which exact events a peer has, as far as that can be said: (asked, missed, spurious).

    Events are (time, body, other body or wall), walls negative. After its first wrong event a body flies
    elsewhere, and so do all whom it meets, so that nothing that follows can be compared. So bodies start clean; an
    exact event of clean bodies is asked for: a contact of the same two within the tolerance, or else it is missed;
    a contact of clean bodies without such an exact event is spurious. Who takes part in a wrong event, or in any
    event with a body that is not clean, is not clean any more. Walls always are."""
    partner = {}
    exact_times = {}
    for i, (t, a, b) in enumerate(exact):
        exact_times.setdefault((a, b), []).append((t, i))
    for j, (t, a, b) in enumerate(found):
        near = [(abs(t - u), i) for u, i in exact_times.get((a, b), []) if i not in partner]
        near = [(off, i) for off, i in near if off <= tolerance]
        if near:
            partner[min(near)[1]] = j
    has_exact = set(partner.values())
    events = [(t, 0, i, a, b) for i, (t, a, b) in enumerate(exact)]
    events += [(t, 1, j, a, b) for j, (t, a, b) in enumerate(found) if j not in has_exact]
    dirty = set()
    asked = missed = spurious = 0
    for _, kind, i, a, b in sorted(events):
        clean = a not in dirty and b not in dirty
        fine = False
        if clean and kind == 0:
            asked += 1
            fine = i in partner
            missed += not fine
        elif clean:
            spurious += 1
        if not fine:
            dirty.update(x for x in (a, b) if x >= 0)
    return asked, missed, spurious


def events(path):
    with open(path) as file:
        return [(float(t), int(a), int(b)) for t, a, b in (line.split() for line in file)]


def processor_time(command):
    """Of a whole process, in seconds; and what it prints."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, timeout=TIMEOUT)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    if done.returncode != 0:
        raise RuntimeError((done.stderr.strip().splitlines() or ["exit code %d" % done.returncode])[-1])
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime, done.stdout


class Gas:
    def __init__(self, scc, rapier, prefix, work, rounds, bars):
        self.scc, self.rapier, self.prefix, self.rounds, self.bars = scc, rapier, prefix, rounds, bars
        self.folder = os.path.join(work, "gas")
        os.makedirs(self.folder, exist_ok=True)
        self.record = []

    def path(self, name):
        return os.path.join(self.folder, name)

    def exact(self, size):
        """Seconds that the events took (a run of no time is what reading and building the gas costs), and them."""
        start, log = self.path("start_%d.txt" % size), self.path("events_%d.txt" % size)
        run = self.prefix + [self.scc, str(size)]
        spent, printed = processor_time(run + [str(TIME), "--write", start, "--events", log])
        idle, _ = processor_time(run + ["0", "--events", os.devnull])
        return spent - idle, printed

    def peer(self, size, step):
        name = self.path("contacts_%d_%s.txt" % (size, step.replace("/", "_")))
        command = self.prefix + [self.rapier, self.path("start_%d.txt" % size), step, name]
        printed = processor_time(command)[1]
        return json.loads(printed), name

    def compare(self):
        print("\n== gas of N cubes in a box, %d units of time" % TIME, flush=True)
        lines, per_event, notes = [], {}, []
        for size in SIZES:
            seconds, peers = float("inf"), {}
            for _ in range(self.rounds):
                spent, printed = self.exact(size)
                seconds = min(seconds, spent)
                for step in STEPS if self.rapier else []:
                    found, name = self.peer(size, step)
                    if step not in peers or found["seconds"] < peers[step][0]["seconds"]:
                        peers[step] = found, name
            exact = events(self.path("events_%d.txt" % size))
            per_event[size] = seconds / max(1, len(exact))
            lines.append([str(size), "scc", "%.3f" % seconds, str(len(exact)), "%.1f" % (1e6 * per_event[size]),
                          "", "", "", "", ""])
            notes += ["N = %d: %s" % (size, line) for line in printed.strip().splitlines()]
            for step, (found, name) in peers.items():
                lines.append([str(size), "rapier, step " + step] + self.told(found, exact, events(name)))
        headings = ["N", "", "s", "events", "us/event", "asked", "missed", "spurious", "energy drift", "escaped"]
        report.table(headings, lines)
        print("\n".join(notes), flush=True)
        growth = per_event[10000] / per_event[1000]
        self.bars.at_most("gas: cost per event, N = 10 000 / N = 1 000", growth, 1.5)
        self.record = lines

    def told(self, found, exact, contacts):
        asked, missed, spurious = matched(exact, contacts)
        drift = found["energy_after"] / found["energy_before"] - 1
        count = found["contacts"] + found["walls"]
        per_event = "%.1f" % (1e6 * found["seconds"] / max(1, count))
        return ["%.3f" % found["seconds"], str(count), per_event, str(asked), str(missed), str(spurious),
                "%+.1e" % drift, str(found["outside"])]
