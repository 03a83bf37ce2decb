"""What is right and what is wrong in the answers of a program.

The exact answer to a cast is a line of an answer file, `collide T | inside | never` then ` | touch T | never`. A
peer says `never`, `hit T` or `inside`. The exact answer to a contact test is `apart`, `touching` or
`inside`; a peer may know only `meet`, which is right for bodies that touch or interpenetrate.
"""

from fractions import Fraction


class Casts:
    """missed: of collisions and of starts inside, those that the peer says never happen;
    spurious: hits where the closed bodies never meet; grazes: hits where the bodies meet but never collide
    (no fault of a peer that counts grazes as hits); error: the largest difference in time; late: of hits,
    those whose time is off by more than 1e-6."""

    def __init__(self, exact, found):
        self.missed = self.spurious = self.grazes = self.late = 0
        self.error = 0.0
        for truth, said in zip(exact, found):
            collision, touch = [part.split() for part in truth.split(" | ")]
            if said == "never":
                self.missed += collision[0] != "never"
                continue
            time = 0.0 if said == "inside" else float(said.split()[1])
            if collision[0] == "never":
                self.spurious += touch[0] == "never"
                self.grazes += touch[0] != "never"
            else:
                true_time = 0.0 if collision[0] == "inside" else float(Fraction(collision[1]))
                off = abs(time - true_time)
                self.error = max(self.error, off)
                self.late += not off <= 1e-6

    def add(self, other):
        for count in ("missed", "spurious", "grazes", "late"):
            setattr(self, count, getattr(self, count) + getattr(other, count))
        self.error = max(self.error, other.error)

    def columns(self):
        return [str(self.missed), str(self.spurious), str(self.late), "%.0e" % self.error, str(self.grazes)]

    headings = ["missed", "spurious", "off>1e-6", "max error", "grazes hit"]


class Contacts:
    """missed: interpenetrating bodies said to be apart; spurious: bodies apart said to meet; touch: of touching
    bodies, those said to meet (or to touch)."""

    def __init__(self, exact, found):
        self.missed = self.spurious = self.touching = self.touch = 0
        for truth, said in zip(exact, found):
            if truth == "touching":
                self.touching += 1
                self.touch += said != "apart"
            elif truth == "inside":
                self.missed += said == "apart"
            else:
                self.spurious += said != "apart"

    def add(self, other):
        for count in ("missed", "spurious", "touching", "touch"):
            setattr(self, count, getattr(self, count) + getattr(other, count))

    def columns(self):
        touch = "%d of %d" % (self.touch, self.touching) if self.touching else "-"
        return [str(self.missed), str(self.spurious), touch]

    headings = ["missed", "spurious", "touching found"]


KINDS = {"cast": Casts, "discrete": Contacts}


def wrong(exact, found):
    """How many of scc's own answers differ: every one has to be the exact one."""
    return sum(a != b for a, b in zip(exact, found)) + abs(len(exact) - len(found))
