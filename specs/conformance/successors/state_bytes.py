"""Reads states as bytes, as specs/state-bytes.md tells, and makes their fingerprints, as specs/successors.md tells."""

from fractions import Fraction
import hashlib
import struct


class Malformed(Exception):
    pass


class Reader:
    def __init__(self, data):
        self.data, self.at = data, 0

    def byte(self):
        if self.at >= len(self.data):
            raise Malformed('it ends too early')
        self.at += 1
        return self.data[self.at - 1]

    def natural(self):
        value = shift = 0
        while True:
            digit = self.byte()
            value |= (digit & 127) << shift
            shift += 7
            if digit < 128:
                if digit == 0 and shift > 7:
                    raise Malformed('a digit 0 in front')
                return value

    def integer(self):
        head = self.natural()
        if head & 1:
            end = self.at + head // 4
            if end > len(self.data):
                raise Malformed('it ends too early')
            size, self.at = int.from_bytes(self.data[self.at:end], 'little'), end
        else:
            size = head // 4
        return -size if head & 2 else size

    def rational(self):
        numerator, denominator = self.integer(), self.integer()
        return Fraction(numerator, denominator)

    def vector(self):
        return [self.rational() for _ in range(3)]

    def list(self, item):
        return [item() for _ in range(self.natural())]

    def option(self, item):
        found = self.list(item)
        return found[0] if found else None

    # Parts of a state -----------------------------------------------------------------

    def behaviour(self):
        kind = self.natural()
        if kind == 0:
            return 'delay', self.rational(), self.behaviour()
        return ('sum', self.list(self.behaviour)) if kind == 1 else kind - 2

    def end(self):
        return {'body': self.natural(), 'part': self.natural(), 'feature': self.natural()}

    def bond(self):
        return {'channel': self.natural(), 'ends': [self.end(), self.end()]}

    def leaf(self, has):
        leaf = {'body': self.natural(), 'position': self.vector()}
        if has & 32:
            leaf['turned'] = [self.integer() for _ in range(4)]
        if has & 64:
            leaf['waited'] = self.rational()
        leaf['origin'], leaf['behaviour'] = self.natural(), self.behaviour()
        return leaf

    def phase(self):
        return ['moving', 'due', 'steered'][self.natural()]

    def draw(self):
        return self.vector() if self.natural() else 'waits'

    def drawn(self):
        return self.natural(), self.behaviour()

    def lot(self):
        bond, decision = self.bond(), self.natural()
        return bond, decision, self.list(self.drawn) if decision else []

    def lots(self):
        return {'since': self.rational(), 'pending': self.list(self.lot)}

    def process(self):
        has = self.natural()
        p = {'leaves': self.list(lambda: self.leaf(has)), 'bonds': self.list(self.bond), 'velocity': self.vector()}
        if has & 16:
            p['spin'], p['since'] = self.vector(), self.rational()
            p['lasts'], p['kept'] = self.option(self.rational), self.vector()
        for bit, name, read in [(1, 'clock', self.rational), (2, 'phase', self.phase), (4, 'draw', self.draw),
                                (8, 'lots', self.lots)]:
            if has & bit:
                p[name] = read()
        return p

    def step(self):
        return {'remaining': self.rational(), 'phase': self.phase()}


def read(data, events=False):
    """The state, and its pieces: the bytes of each process, and the rest. With events, those that have just happened."""
    r = Reader(data)
    version, count = r.natural(), r.natural()
    if version != 1:
        raise Malformed('version %d' % version)
    processes, pieces = [], []
    for _ in range(count):
        begin = r.at
        processes.append(r.process())
        pieces.append(data[begin:r.at])
    pieces.append(data[r.at:])
    state = {'processes': processes, 'step': r.option(r.step), 'time': r.option(r.rational)}
    if events:
        state['events'] = r.list(r.natural)
    if r.at != len(data):
        raise Malformed('there is more than a state')
    return state, pieces


def fingerprint(pieces):
    words = [0, 0, 0, 0]
    for piece in pieces:
        digest = struct.unpack('<4I', hashlib.md5(piece).digest())
        words = [(a + b) % 2**32 for a, b in zip(words, digest)]
    return struct.pack('<4I', *words)
