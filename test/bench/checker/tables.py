"""The tables of check-compare. Each function measures, prints, and adds to the bars and to the record."""

from comparing.report import table

from . import programs
from .programs import Failed, Run

MIB = 1024 * 1024


def thousands(n):
    return "{:,}".format(int(round(n))).replace(",", " ")


def seconds(s):
    return "%.2f" % s if s < 100 else "%.0f" % s


def best(what, rounds):
    """The least time and the least memory of some runs, whose counts have to be the same."""
    runs = [what() for _ in range(rounds)]
    if len({(r.states, r.transitions) for r in runs}) != 1:
        raise Failed("two runs do not count the same")
    return Run(runs[0].states, runs[0].transitions, min(r.seconds for r in runs), min(r.memory for r in runs),
               runs[0].note)


def rate(r):
    # A run that is too short to be measured has no rate.
    return r.transitions / r.seconds if r.seconds >= 0.02 else None


def shown_rate(r, of="transitions"):
    amount = r.transitions if of == "transitions" else r.states
    return thousands(amount / r.seconds) if r.seconds >= 0.02 else "-"


class Tables:
    def __init__(self, scc, peers, rounds, bars):
        self.scc, self.peers, self.rounds, self.bars = scc, peers, rounds, bars
        self.record = {}

    def note(self, section, key, r, **more):
        self.record.setdefault(section, {})[key] = dict(
            states=r.states, transitions=r.transitions, seconds=r.seconds, memory=r.memory, **more)

    def chain(self, n):
        """chain-n by all programs. The bars of speed are on stateright as it is released now."""
        print("\nchain-%d: one safety property, no reductions; %s" % (
            n, "2^%d = %s states, %s transitions" % (n, thousands(2 ** n), thousands(n * 2 ** (n - 1) + 2 ** n - 1))))
        found, failed = {}, []
        for p in [self.scc] + self.peers:
            try:
                base = best(lambda p=p: p.chain(1), 1)
                r = best(lambda p=p: p.chain(n), self.rounds)
                found[p.name] = (r, (r.memory - base.memory) / r.states)
                self.note("chain-%d" % n, p.name, r, bytes_per_state=found[p.name][1])
            except Failed as failure:
                failed.append("%s: %s" % (p.name, failure))
        yardsticks = [name for name in found if name.startswith("stateright 0.31")]
        rows = []
        for name, (r, bytes_) in found.items():
            ratios = [self._ratio(r, found[y][0]) for y in yardsticks]
            rows.append([name, thousands(r.states), thousands(r.transitions), seconds(r.seconds), shown_rate(r, "states"),
                         shown_rate(r), "%.0f" % (r.memory / MIB), "%.0f" % bytes_] + ratios + [r.note])
        table(["", "states", "transitions", "s", "states/s", "transitions/s", "MiB", "bytes/state"]
              + ["x " + y.split(", ")[1] for y in yardsticks] + ["the property"], rows)
        for line in failed:
            print("not measured: " + line)
        self._chain_bars(n, found, yardsticks)

    @staticmethod
    def _ratio(r, yardstick):
        return "%.2f" % (rate(r) / rate(yardstick)) if rate(r) and rate(yardstick) else "-"

    def _chain_bars(self, n, found, yardsticks):
        if "scc" not in found:
            self.bars.unknown("chain-%d" % n, "scc did not end")
            return
        own, bytes_ = found["scc"]
        expected = (2 ** n, n * 2 ** (n - 1) + 2 ** n - 1)
        others = {name for name, (r, _) in found.items() if (r.states, r.transitions) != expected}
        if others:
            print("OTHER COUNTS: " + ", ".join(sorted(others)))
        self.bars.at_most("chain-%d: programs with other counts" % n, len(others), 0, unit="")
        for y in yardsticks:
            if rate(own) and rate(found[y][0]):
                self.bars.at_least("chain-%d: transitions/s over %s" % (n, y), rate(own) / rate(found[y][0]), 0.5)
        if not yardsticks:
            self.bars.unknown("chain-%d: transitions/s over stateright" % n, "no stateright")
        self.bars.at_most("chain-%d: bytes per state" % n, bytes_, 50, aim=16, unit=" B")

    def lattice(self, sizes):
        """What one property over one dimer costs, and what the whole graph has."""
        print("\nlattice-n: one property over one of n dimers; reduced, and the whole graph")
        rows, last = [], None
        for n in sizes:
            row = [str(n)]
            for options in ([], programs.WHOLE):
                if options and not self.scc.reduces:
                    row += ["-", "-", "-"]
                    continue
                try:
                    options = options + ["--states", str(2 ** (n + 1)), "--memory", "16384"]
                    r = best(lambda o=options, n=n: self.scc.check("lattice", n, o), self.rounds)
                    row += [thousands(r.states), thousands(r.transitions), seconds(r.seconds)]
                    self.note("lattice-%d" % n, "whole" if options[0] == "--no-reduce" else "reduced", r)
                    if options[0] != "--no-reduce":
                        last = last or (n, r)
                        end = (n, r)
                except Failed as failure:
                    row += ["-", "-", str(failure)]
            rows.append(row)
        table(["n", "states", "transitions", "s", "whole: states", "transitions", "s"], rows)
        if last is not None and self.scc.reduces:
            self.bars.at_most("lattice-%d: states of the property over those at n = %d" % (end[0], last[0]),
                              end[1].states / last[1].states, 1)
        else:
            self.bars.unknown("lattice", "this scc has no reductions")

    def hexokinase(self, sizes, states):
        """Speed where states are made by flights and collisions."""
        print("\nhexokinase with n substrates, no reductions, at most %s states" % thousands(states))
        rows = []
        for n in sizes:
            try:
                base = self.scc.check("hexokinase", 1, self.scc.unreduced())
                options = ["--states", str(states), "--memory", "16384"] + self.scc.unreduced()
                r = best(lambda n=n, o=options: self.scc.check("hexokinase", n, o), self.rounds)
                bytes_ = (r.memory - base.memory) / r.states
                self.note("hexokinase-%d" % n, "scc", r, bytes_per_state=bytes_)
                rows.append([str(n), thousands(r.states), thousands(r.transitions), seconds(r.seconds),
                             shown_rate(r, "states"), shown_rate(r), "%.0f" % bytes_, r.note])
            except Failed as failure:
                rows.append([str(n)] + ["-"] * 6 + [str(failure)])
        table(["n", "states", "transitions", "s", "states/s", "transitions/s", "bytes/state", "the property"], rows)

    def reductions(self, cases):
        """Each reduction alone, all but one, and all: states over those without any."""
        print("\nReductions: states, and in brackets how many times fewer than without any")
        if not self.scc.reduces:
            print("not measured: this scc has no --no-reduce")
            self.bars.unknown("reductions", "this scc has no --no-reduce")
            return
        names = programs.REDUCTIONS
        ways = [("none", programs.ALL_OFF)]
        ways += [("only " + a, programs.without([b for b in names if b != a])) for a in names]
        ways += [("all but " + a, programs.without([a])) for a in names]
        ways += [("all", [])]
        found = {}
        for model, n in cases:
            for way, options in ways:
                try:
                    found[model, n, way] = self.scc.check(model, n, options + ["--states", "4000000", "--memory", "8192"])
                    self.note("reductions", "%s %d %s" % (model, n, way), found[model, n, way])
                except Failed as failure:
                    found[model, n, way] = str(failure)

        def cell(model, n, way):
            r, whole = found[model, n, way], found[model, n, "none"]
            if isinstance(r, str):
                return r
            factor = "" if isinstance(whole, str) else " (%.1f)" % (whole.states / max(1, r.states))
            return "%s%s, %s s" % (thousands(r.states), factor, seconds(r.seconds))

        table([""] + ["%s, n = %d" % case for case in cases],
              [[way] + [cell(model, n, way) for model, n in cases] for way, _ in ways])

    def many(self, n, states, memory):
        """A bounded exploration of many states of chain-n within some memory."""
        print("\n%s states of chain-%d within %d MiB" % (thousands(states), n, memory))
        options = ["--states", str(states), "--memory", str(memory)] + self.scc.unreduced()
        try:
            r = self.scc.check("bonds", n, options, timeout=3600)
        except Failed as failure:
            self.bars.unknown("%s states" % thousands(states), str(failure))
            return
        self.note("many", "scc", r)
        table(["states", "transitions", "s", "MiB", "the property"],
              [[thousands(r.states), thousands(r.transitions), seconds(r.seconds), "%.0f" % (r.memory / MIB), r.note]])
        what = "MiB for %s states" % thousands(states)
        # The bound ends an exploration before a state that would not fit with all that it leads to.
        if r.states < 0.999 * states:
            self.bars.unknown(what, "it stopped after %s" % thousands(r.states))
        else:
            self.bars.at_most(what, round(r.memory / MIB), memory, unit="")
