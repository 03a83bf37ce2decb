"""Casts and contact tests of scc and the peers on one set of pairs after the other."""

import json
import os
import subprocess

from . import answers, report

HERE = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
DATA = os.path.join(os.path.dirname(HERE), "data", "geometry")
TIMEOUT = 600


class Set:
    def __init__(self, title, shape_a, shape_b, pairs, exact=None, bars=None):
        self.title, self.shape_a, self.shape_b, self.pairs = title, shape_a, shape_b, pairs
        self.exact = exact  # a file of answers to the casts, where there is one
        self.bars = bars  # a short name, if this set has bars


def committed():
    def path(name):
        return os.path.join(DATA, name + ".txt")

    def make(title, shape, pairs, exact, bars):
        return Set(title, path(shape), path(shape), path(pairs), exact and path(exact), bars)

    return [
        make("cubes, general position", "cube", "pairs_cube", "answers_cube", "cubes"),
        make("50-face hulls, general position", "poly50", "pairs_poly", "answers_poly", "hulls"),
        make("aligned cubes on a coarse grid", "cube", "pairs_deg", "answers_deg", "degenerate"),
        make("kissing cubes: all touch, none interpenetrates", "cube", "kiss", None, "kissing"),
    ]


# Shapes and the kinds of pairs to ask of them, two shapes where B is another than A.
GENERATED = [
    (["tetrahedron"], ["general", "near", "inside"]),
    (["plank"], ["general", "aligned", "near"]),
    (["prism:12"], ["general", "aligned", "inside"]),
    (["hull:14"], ["general", "near"]),
    (["hull:50"], ["general", "near", "inside"]),
    (["hull:200"], ["general", "near"]),
    (["plank", "hull:50"], ["general", "near"]),
]


def generated(work, seed, count=500):
    """Made anew each time; the seed decides all."""
    folder = os.path.join(work, "data")
    os.makedirs(folder, exist_ok=True)

    def make(name, words):
        path = os.path.join(folder, name + ".txt")
        with open(path, "w") as file:
            subprocess.run([os.path.join(HERE, "generate")] + words, stdout=file, check=True)
        return path

    def shape(kind):
        return make(kind.replace(":", "_"), ["shape", kind, str(seed)])

    sets = []
    for kinds, tasks in GENERATED:
        shapes = [shape(kind) for kind in kinds]
        for task in tasks:
            name = "_".join(kinds).replace(":", "_") + "_" + task
            pairs = make(name, ["pairs", task, str(seed), str(count)] + shapes)
            sets.append(Set("generated: %s, %s" % (" against ".join(kinds), task), shapes[0], shapes[-1], pairs))
    return sets


def run(prefix, command):
    """The rows that a program prints, or None and the reason."""
    try:
        done = subprocess.run(prefix + command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                              timeout=TIMEOUT)
    except subprocess.TimeoutExpired:
        return None, "no end after %d s" % TIMEOUT
    if done.returncode != 0:
        return None, (done.stderr.strip().splitlines() or ["exit code %d" % done.returncode])[-1]
    return json.loads(done.stdout)["rows"], None


def count_faces(shape):
    with open(shape) as file:
        return int(file.readline().split()[1])


class Comparison:
    """The programs take turns on each set, some rounds; of each row the least time counts, since what
    disturbs a run only makes it slower."""

    def __init__(self, scc, programs, prefix, bars):
        self.scc, self.programs, self.prefix, self.bars = scc, programs, prefix, bars
        self.wrong = 0
        self.total = {}  # of each row of a peer, its answers over all sets
        self.record = []

    def measure(self, s, rounds):
        files = [s.shape_a, s.shape_b, s.pairs]
        commands = {"scc": [self.scc] + files + ["--json"]}
        commands.update({name: [program] + files for name, program in self.programs.items()})
        best, order, failed = {}, [], {}
        for _ in range(rounds):
            for name, command in commands.items():
                if name in failed:
                    continue
                rows, reason = run(self.prefix, command)
                if rows is None:
                    failed[name] = reason
                    print("%s fails on this set: %s" % (name, reason), flush=True)
                    continue
                for row in rows:
                    key = (row["query"], row["name"])
                    if key not in best:
                        order.append(key)
                        best[key] = row
                    elif row["ns"] < best[key]["ns"]:
                        best[key]["ns"] = row["ns"]
        return [best[key] for key in order]

    def check(self, s, rows):
        """Our own answers: against the answer file, and on samples against all separating axes. Kissing pairs
        all touch."""
        found = {row["query"]: row["answers"] for row in rows if row["name"] == "scc one-off"}
        if s.exact:
            with open(s.exact) as file:
                exact = file.read().splitlines()
            self.tell("casts that differ from %s" % os.path.basename(s.exact),
                      answers.wrong(exact, found.get("cast", [])), len(exact))
        if s.bars == "kissing":
            self.tell("kissing pairs not found touching", sum(a != "touching" for a in found["discrete"]),
                      len(found["discrete"]))
        sample = min(100, 20000 // (count_faces(s.shape_a) * count_faces(s.shape_b)))
        if sample == 0:
            print("too many faces to try all separating axes", flush=True)
            return found
        done = subprocess.run([self.scc, s.shape_a, s.shape_b, s.pairs, "--check", str(sample)], text=True,
                              stdout=subprocess.PIPE, timeout=TIMEOUT)
        lines = done.stdout.strip().splitlines()
        print("scc against all separating axes: " + "\n".join(lines), flush=True)
        self.wrong += max(len(lines) - 1, done.returncode != 0)
        return found

    def tell(self, what, wrong, total):
        print("scc: %s: %d of %d" % (what, wrong, total), flush=True)
        self.wrong += wrong

    def show(self, s, rows, exact):
        ns = {(r["query"], r["name"]): r["ns"] for r in rows}
        for query, title in (("cast", "linear cast"), ("discrete", "contact test"), ("make", "making")):
            shown = [r for r in rows if r["query"] == query]
            if not shown:
                continue
            kind = answers.KINDS.get(query)
            headings = [title, "ns"] + (["one-off/it", "again/it"] + kind.headings if kind else [])
            lines = []
            for r in shown:
                line = [r["name"], "%.0f" % r["ns"]]
                if kind:
                    line += ["%.2f" % (ns[query, "scc " + mode] / r["ns"]) for mode in ("one-off", "again")]
                    if r["name"].startswith("scc"):
                        line += [""] * len(kind.headings)
                    else:
                        verdict = kind(exact[query], r["answers"])
                        line += verdict.columns()
                        self.total.setdefault((query, r["name"]), kind([], [])).add(verdict)
                lines.append(line)
            print()
            report.table(headings, lines)
        if ("facets", "scc one-off") in ns:
            print("\npairs for which scc needed all facets of their obstacle: %d" % ns["facets", "scc one-off"])

    def judge(self, s, rows):
        ns = {(r["query"], r["name"]): r["ns"] for r in rows}
        casting = ns.get(("cast", "scc one-off"))
        testing = ns["discrete", "scc one-off"]

        def against(add, what, own, peer, inverse, *limits):
            what = "%s, %s" % (what, s.bars)
            if peer not in ns:
                self.bars.unknown(what, "no " + peer[1])
            else:
                add(what, ns[peer] / own if inverse else own / ns[peer], *limits)

        parry = ("cast", "parry cast_shapes, polyhedron")
        if s.bars in ("cubes", "hulls"):
            against(self.bars.at_most, "cast / parry", casting, parry, False, 1.4, 1.0)
            against(self.bars.at_most, "contact test / libccd MPR", testing, ("discrete", "libccd MPR intersect"),
                    False, 2.5, 1.5)
            against(self.bars.at_least, "CGAL Epeck / contact test", testing,
                    ("discrete", "CGAL Epeck moved meshes"), True, 15, 30)
        elif s.bars == "degenerate":
            against(self.bars.at_most, "cast / parry", casting, parry, False, 2.0)

    def compare(self, s, rounds):
        with open(s.pairs) as file:
            count = int(file.readline().split()[0])
        print("\n== %s (%d pairs)" % (s.title, count), flush=True)
        rows = self.measure(s, rounds)
        if not any(r["name"] == "scc one-off" for r in rows):
            self.wrong += 1
            return
        exact = self.check(s, rows)
        self.show(s, rows, exact)
        self.judge(s, rows)
        self.record.append({"set": s.title,
                            "rows": [{k: r[k] for k in ("query", "name", "ns")} for r in rows]})

    def show_total(self):
        """What the peers get wrong over all sets."""
        for query, title in (("cast", "casts"), ("discrete", "contact tests")):
            lines = [[name] + verdict.columns() for (q, name), verdict in self.total.items() if q == query]
            if lines:
                print("\nAll %s of all sets" % title, flush=True)
                report.table([""] + answers.KINDS[query].headings, lines)
