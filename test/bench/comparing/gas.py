"""The gas: the same cubes in the same box for the same time, by scc exactly and by rapier in fixed steps."""

import json
import os
import resource
import subprocess

from . import report

TIME = 10
# Aligned cubes of one mass only swap a component of their velocities when they meet. So every coordinate stays a
# start plus a start's velocity times the time plus a whole number: their numbers cannot grow, and how many bits
# they have at the end says only when the run ended. Turned cubes are there for what cannot be seen in them.
GASES = [
    ("cubes", [100, 1000, 10000], ["1/60", "1/240"]),
    ("turned", [1000, 10000], ["1/60"]),
]
# When to look at the numbers of turned cubes, and at what an event has cost until then.
GROWTH_SIZE, GROWTH_TIMES = 1000, [2, 5, 10, 20, 30]
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

    def run(self, shapes, size, time, *more):
        return processor_time(self.prefix + [self.scc, str(size), str(time), "--shapes", shapes] + list(more))

    def exact(self, shapes, size):
        """Seconds that the events took: a run of no time is what reading and building the gas costs."""
        files = ["--write", self.path("start.txt"), "--events", self.path("events.txt")]
        spent, _ = self.run(shapes, size, TIME, *files)
        return spent - self.run(shapes, size, 0, "--events", os.devnull)[0]

    def peer(self, step):
        name = self.path("contacts_%s.txt" % step.replace("/", "_"))
        printed = processor_time(self.prefix + [self.rapier, self.path("start.txt"), step, name])[1]
        return json.loads(printed), name

    def size(self, shapes, size, steps):
        """Microseconds for each of scc's events, and the lines of the table."""
        seconds, peers = float("inf"), {}
        for _ in range(self.rounds):
            seconds = min(seconds, self.exact(shapes, size))
            for step in steps if self.rapier else []:
                found, name = self.peer(step)
                if step not in peers or found["seconds"] < peers[step][0]["seconds"]:
                    peers[step] = found, name
        exact = events(self.path("events.txt"))
        cost = 1e6 * seconds / max(1, len(exact))
        lines = [[str(size), "scc", "%.3f" % seconds, str(len(exact)), "%.1f" % cost, "", "", "", "", ""]]
        for step, (found, name) in peers.items():
            lines.append([str(size), "rapier, step " + step] + self.told(found, exact, events(name)))
        return cost, lines

    def compare(self):
        for shapes, sizes, steps in GASES:
            print("\n== gas of N cubes in a box (%s), %d units of time" % (shapes, TIME), flush=True)
            cost, lines = {}, []
            for size in sizes:
                cost[size], more = self.size(shapes, size, steps)
                lines += more
            headings = ["N", "", "s", "events", "us/event", "asked", "missed", "spurious", "energy drift",
                        "escaped"]
            report.table(headings, lines)
            what = "gas (%s): cost per event, N = 10 000 / N = 1 000" % shapes
            self.bars.at_most(what, cost[10000] / cost[1000], 1.5)
            self.record += [[shapes] + line for line in lines]
        self.growth()

    def growth(self):
        print("\n== how numbers grow: %d turned cubes, from the start to a time" % GROWTH_SIZE, flush=True)
        for time in GROWTH_TIMES:
            printed = self.run("turned", GROWTH_SIZE, time)[1]
            lines = [line for line in printed.splitlines() if "to start" not in line]
            print("\n".join(lines), flush=True)

    def told(self, found, exact, contacts):
        asked, missed, spurious = matched(exact, contacts)
        drift = found["energy_after"] / found["energy_before"] - 1
        count = found["contacts"] + found["walls"]
        per_event = "%.1f" % (1e6 * found["seconds"] / max(1, count))
        return ["%.3f" % found["seconds"], str(count), per_event, str(asked), str(missed), str(spurious),
                "%+.1e" % drift, str(found["outside"])]
