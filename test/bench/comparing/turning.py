"""The cast of turning bodies: scc beside parry, and beside its own translational cast when nothing turns."""

import os
import subprocess

from . import pairs, report

# How clearly the bodies have to interpenetrate, or stay apart, turning as parry turns them, before its answer counts
# as wrong; the bodies are as large as one.
CLEAR = 1e-3

KINDS = [("hit", "hits"), ("near", "near misses"), ("far", "far apart"), ("all", "all")]


def make(program, shape, count, seed, path):
    os.makedirs(os.path.dirname(path), exist_ok=True)
    with open(path, "w") as file:
        subprocess.run([program, "--make", shape, str(count), str(seed)], stdout=file, check=True)
    return path


def least(rounds):
    """Of each row, by query and name, the least time of the rounds; answers of the first."""
    found = {}
    for rows in rounds:
        for row in rows:
            key = (row["query"], row["name"])
            if key not in found:
                found[key] = dict(row)
            found[key]["ns"] = min(found[key]["ns"], row["ns"])
    return found


def word(answer):
    return "hit" if answer.startswith(("hit", "failed")) else answer


def differences(own, other):
    """What the other answers otherwise: numbers of pairs; and how far apart the times of common hits are."""
    differ = [i for i, (x, y) in enumerate(zip(own, other)) if word(x) != word(y)]
    off = [abs(float(x.split()[1]) - float(y.split()[1]))
           for x, y in zip(own, other) if word(x) == word(y) == "hit"]
    return differ, max(off, default=0.0)


class Comparison:
    def __init__(self, program, parry, prefix, bars):
        self.program, self.parry, self.prefix, self.bars = program, parry, prefix, bars
        self.wrong = 0
        self.record = []

    def rounds(self, commands, rounds):
        """What each program says in each round, by turns."""
        said = [[] for _ in commands]
        for _ in range(rounds):
            for k, command in enumerate(commands):
                rows, reason = pairs.run(self.prefix, command)
                if rows is None:
                    raise RuntimeError("%s: %s" % (os.path.basename(command[0]), reason))
                said[k].append(rows)
        return [least(rows) for rows in said]

    def turning(self, name, shape, path, rounds):
        commands = [[self.program, shape, path]] + ([[self.parry, shape, path]] if self.parry else [])
        found = self.rounds(commands, rounds)
        own, other = found[0], found[1] if self.parry else {}
        print("\n%s, turning: us per cast, and in brackets that time over scc's" % name)
        programs = sorted({n for _, n in other}, reverse=True)
        rows = []
        for kind, title in KINDS:
            ns = own[(kind, "scc")]["ns"]
            row = [title, "%.1f" % (ns / 1e3)]
            row += ["%.1f (x %.2f)" % (other[(kind, p)]["ns"] / 1e3, other[(kind, p)]["ns"] / ns) for p in programs]
            rows.append(row)
        report.table([""] + ["scc"] + programs, rows)
        print("of which the grid: %.2f us" % (own[("all", "scc grid")]["ns"] / 1e3))
        answers = own[("all", "scc")]["answers"]
        print("scc: %s" % self.counts(answers))
        for p in programs:
            self.judge(p, shape, path, answers, other[("all", p)]["answers"])
        if other:
            ratio = own[("all", "scc")]["ns"] / other[("all", "parry polyhedron")]["ns"]
            self.bars.at_most("turning %s: scc / parry" % name, ratio, 2.0)
        else:
            self.bars.unknown("turning %s: scc / parry" % name, "no parry")
        self.record.append({"set": name, "rows": [{"query": q, "name": n, "ns": r["ns"]}
                                                  for f in found for (q, n), r in f.items()]})

    @staticmethod
    def counts(answers):
        words = [answer.split()[0] for answer in answers]
        return ", ".join("%d %s" % (words.count(w), w) for w in sorted(set(words)))

    def judge(self, name, shape, path, own, other):
        differ, off = differences(own, other)
        missed = spurious = 0
        if differ:
            # How near they come when they turn as parry turns them.
            said = subprocess.run([self.program, "--gaps", shape, path] + [str(i) for i in differ], text=True,
                                  stdout=subprocess.PIPE, check=True).stdout.split()
            gaps = [float(x) for x in said]
            missed = sum(word(other[i]) == "never" and gap < -CLEAR for i, gap in zip(differ, gaps))
            spurious = sum(word(other[i]) != "never" and gap > CLEAR for i, gap in zip(differ, gaps))
        print("%s: %s; %d otherwise than scc, of which %d missed and %d spurious; times off by up to %.4f"
              % (name, self.counts(other), len(differ), missed, spurious, off))

    def straight(self, name, shape, path, rounds):
        found = self.rounds([[self.program, "--straight", shape, path]], rounds)[0]
        print("\n%s, without spin: us per cast" % name)
        rows = []
        for query in ("one-off", "again"):
            rigid, plain = found[(query, "rigid")]["ns"], found[(query, "translational")]["ns"]
            rows.append([query, "%.3f" % (rigid / 1e3), "%.3f" % (plain / 1e3), "x %.2f" % (rigid / plain)])
            self.bars.at_most("%s without spin, %s: rigid / translational" % (name, query), rigid / plain, 1.2)
        report.table(["", "rigid", "translational", ""], rows)
        different = sum(answer != "same" for answer in found[("one-off", "rigid")]["answers"])
        if different:
            print("%d answers differ from the translational ones" % different)
        self.wrong += different
        self.record.append({"set": name + ", straight", "rows": [{"query": q, "name": n, "ns": r["ns"]}
                                                                 for (q, n), r in found.items()]})


# {1 Against the subdivision of time}

def missed(program, random, seed, hull, jobs):
    """Shares the cases among some processes, and adds up what they say. Exit code 1 when something is wrong."""
    def share(total, k):
        return total * (k + 1) // jobs - total * k // jobs

    running = []
    for k in range(jobs):
        # Each begins where the one before ends, in every kind: none has more cases of a kind than `random`.
        command = [program, "--random", str(share(random, k)), "--grazing", str(share(max(1, random // 10), k)),
                   "--from", str(k * random), "--seed", str(seed), "--hull", hull]
        running.append(subprocess.Popen(command, stdout=subprocess.PIPE, text=True))
    totals, order, bad = {}, [], False
    for process in running:
        output, _ = process.communicate()
        bad = bad or process.returncode != 0
        for line in output.splitlines():
            if line.startswith(" "):
                if "WRONG" in line:
                    print(line)
                continue
            words = line.split()
            numbers = [int(w) for w in words[-7:]]
            name = " ".join(words[:-7])
            if name not in totals:
                totals[name] = [0] * 7
                order.append(name)
            totals[name] = [x + y for x, y in zip(totals[name], numbers)]
    report.table(["", "checked", "hits", "agreed", "open", "missed", "spurious", "wrong times"],
                 [[name] + [str(x) for x in totals[name]] for name in order])
    return 1 if bad or not order else 0
