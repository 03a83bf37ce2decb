"""Tables and the list of bars."""


def table(headings, rows):
    cells = [headings] + rows
    widths = [max(len(row[i]) for row in cells) for i in range(len(headings))]

    def line(row):
        first = row[0].ljust(widths[0])
        return "  ".join([first] + [c.rjust(w) for c, w in zip(row[1:], widths[1:])]).rstrip()

    print("\n".join(line(row) for row in cells), flush=True)


class Bars:
    """What the project asks of itself, and what this run says."""

    def __init__(self):
        self.rows = []
        self.unmet = 0

    def at_most(self, what, value, bar, aim=None, unit="x"):
        self._add(what, value, "<=", bar, aim, unit, lambda limit: value <= limit)

    def at_least(self, what, value, bar, aim=None, unit="x"):
        self._add(what, value, ">=", bar, aim, unit, lambda limit: value >= limit)

    def _add(self, what, value, sign, bar, aim, unit, holds):
        def shown(x):
            return "%d" % x if float(x).is_integer() and unit == "" else "%.2f%s" % (x, unit)

        verdict = "met" if holds(bar) else "NOT met"
        if aim is not None and holds(bar):
            verdict += ", aim met" if holds(aim) else ", aim not met"
        self.unmet += not holds(bar)
        aimed = "" if aim is None else "%s %s" % (sign, shown(aim))
        self.rows.append([what, shown(value), "%s %s" % (sign, shown(bar)), aimed, verdict])

    def unknown(self, what, why):
        self.rows.append([what, "-", "", "", "not measured: " + why])

    def print(self):
        print("\nBars", flush=True)
        table(["", "measured", "bar", "aim", ""], self.rows)
