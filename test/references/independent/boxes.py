"""Boxes: their features, contact and motion. Offsets are those of one box to another."""

from itertools import product

AXES = (0, 1, 2)


class Part:
    """A box: its corners by name, relative to the position of its leaf."""

    def __init__(self, name, corners, faces, mass):
        self.name = name
        self.corners = corners
        self.mass = mass
        self.faces = faces
        self.low = tuple(min(c[i] for c in corners.values()) for i in AXES)
        self.high = tuple(max(c[i] for c in corners.values()) for i in AXES)
        self.features = self.all_features()

    def all_features(self):
        """Each vertex, edge and face: its vertex names, and its extent on each axis."""
        found = {}
        for choice in product('lh*', repeat=3):
            if choice == ('*', '*', '*'):
                continue
            extent = tuple({'l': (self.low[i], self.low[i]), 'h': (self.high[i], self.high[i]),
                            '*': (self.low[i], self.high[i])}[choice[i]] for i in AXES)
            names = frozenset(n for n, c in self.corners.items()
                              if all(extent[i][0] <= c[i] <= extent[i][1] for i in AXES))
            found[names] = extent
        return found


class Body:
    """What a leaf is made of. `law` is None or a function from an environment to a velocity, or to those that
    it `chooses` from."""

    def __init__(self, name, parts, fixed, law=None):
        self.name = name
        self.parts = parts
        self.fixed = fixed
        self.law = law
        self.chooses = False
        self.mass = sum(p.mass for p in parts)

    def centroid(self):
        return tuple(sum(p.mass * (p.low[i] + p.high[i]) / 2 for p in self.parts) / self.mass
                     for i in AXES)


def touching_pairs(p, q, offset):
    """Reading I-3 for the features of p and those of q moved by offset: with dimensions."""
    pairs = []
    for f, fe in p.features.items():
        for g, ge in q.features.items():
            dimension = 0
            for i in AXES:
                a, b = fe[i]
                c, d = ge[i][0] + offset[i], ge[i][1] + offset[i]
                if a == b and c == d:
                    meet = a == c
                elif a == b:
                    meet = c < a < d
                elif c == d:
                    meet = a < c < b
                else:
                    meet = max(a, c) < min(b, d)
                    dimension += 1
                if not meet:
                    break
            else:
                pairs.append((dimension, f, g))
    return pairs


def obstacle(p, q):
    """The offsets of q (its leaf's position less that of p's) at which p and q interpenetrate."""
    return tuple((p.low[i] - q.high[i], p.high[i] - q.low[i]) for i in AXES)


def inside(box, at):
    return all(box[i][0] < at[i] < box[i][1] for i in AXES)


def on_surface(box, at):
    return not inside(box, at) and all(box[i][0] <= at[i] <= box[i][1] for i in AXES)


def approaching(box, at, velocity):
    """At all small times after now, the offset is inside."""
    return on_surface(box, at) and all(
        (at[i] > box[i][0] or velocity[i] > 0) and (at[i] < box[i][1] or velocity[i] < 0)
        for i in AXES)


def entry(box, at, velocity):
    """The time at which the offset enters the open box, or None."""
    start, end = None, None
    for i in AXES:
        if velocity[i] == 0:
            if not box[i][0] < at[i] < box[i][1]:
                return None
        else:
            times = sorted((edge - at[i]) / velocity[i] for edge in box[i])
            start = times[0] if start is None else max(start, times[0])
            end = times[1] if end is None else min(end, times[1])
    if start is None or start >= end or end <= 0:
        return None
    if start < 0:
        raise AssertionError('interpenetration')
    return start
