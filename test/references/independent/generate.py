"""Random small models on a half-integer grid, where simultaneous and degenerate contacts abound.

A model is made twice from the same choices: as text in the language, and as the bodies,
definitions and initial processes of calculus.py.
"""

from fractions import Fraction as F
import random

import calculus as c
from shapes import CHOICES, LAWS, QUATERNIONS, RETURNS, TEMPLATES, Shape, site_text, vector


def site_order(site):
    """An order of sites that no seed of hashes changes."""
    return site[0] or '', sorted(site[1])


class Model:
    def __init__(self, seed, switches=False, walkers=False):
        self.rng = random.Random(seed)
        self.aside = random.Random('entries of %d' % seed)  # so that the rest of a model does not depend on these
        self.seed = seed
        self.names = ['a', 'b'][:self.rng.choice([1, 1, 2])]
        self.flat = self.rng.choice([1, 2, 2, 3, 3])
        self.together = switches and self.aside.random() < 0.5
        self.by_contact = switches and self.aside.random() < 0.5
        self.cyclic = switches and self.aside.random() < 0.5
        self.stopping = random.Random('walkers of %d' % seed)
        self.walkers = walkers
        self.blocked = self.stopping.choice(['stop', 'wait']) if walkers else 'bounce'
        self.steady = walkers and self.stopping.random() < 0.5
        self.timestep = self.rng.choice([F(1), F(1, 2), F(2), F(1, 3)])
        self.split_step = self.rng.choice([None, F(1), F(1, 2), F(3, 4), F(2)])
        self.lively = self.rng.random() < 0.75
        self.shapes = [self.shape(i) for i in range(self.rng.choice([1, 2, 2, 3]))]
        self.definitions, self.on = {}, {}
        self.texts, self.bodies, self.velocities, self.positions = [], {}, {}, {}
        self.behaviours, self.groups, self.bonds = {}, [], []
        if self.lively:
            for s in self.shapes:
                self.define(s)
        self.place()
        if self.cyclic and self.lively and self.aside.random() < 0.25:
            self.square()
        self.laws()
        bodies = {n: c.canonical(b, self.definitions) for n, b in self.definitions.items()}
        self.calculus = c.Calculus(self.bodies, bodies, self.timestep,
                                   self.split_step or self.timestep, self.together, self.by_contact,
                                   self.cyclic, self.blocked, self.steady)

    # Shapes

    def scale(self):
        return tuple(self.rng.choice([F(1), F(1), F(1, 2), F(2)]) for _ in c.AXES)

    def solid(self, scale, template):
        return template if scale == (1, 1, 1) else '%s scaled %s' % (template, vector(scale))

    def shape(self, index):
        rng = self.rng
        name = 'Body%d' % index
        if rng.random() < 0.6:
            template, scale = rng.choice(['Cube', 'Cube', 'Brick']), self.scale()
            text = 'shape %s = %s\n' % (name, self.solid(scale, template))
            return Shape(name, [(None, template, scale, c.ZERO, F(0))], text)
        parts, lines, glues = [], [], []
        for i, part in enumerate(['u', 'v', 'w'][:rng.choice([2, 2, 3])]):
            for _ in range(50):
                template, scale = rng.choice(['Cube', 'Brick']), self.scale()
                mass = F(rng.choice([1, 1, 2, 3]))
                if i == 0:
                    parts.append((part, template, scale, c.ZERO, mass))
                    break
                here = Shape('', parts, '').placed(None, None)
                new = Shape('', [(part, template, scale, c.ZERO, mass)], '').placed(None, None)[0]
                base = rng.choice(here)
                at = self.beside(base, new)
                if any(c.inside(c.obstacle(p, new), at) for p in here):
                    continue
                pairs = c.touching_pairs(base, new, at)
                highest = self.highest(base, new, at, pairs)
                glues.append((site_text(here, (base.name, highest[0])),
                              site_text([new], (part, highest[1]))))
                parts.append((part, template, scale, at, mass))
                break
        for part, template, scale, at, mass in parts:
            lines.append('  part %s : %s mass %s at translate %s\n'
                         % (part, self.solid(scale, template), mass, vector(at)))
        lines += ['  glue %s ~ %s\n' % g for g in glues]
        return Shape(name, parts, 'compound %s {\n%s}\n' % (name, ''.join(lines)))

    def beside(self, base, new):
        """An offset at which the two boxes touch."""
        rng = self.rng
        low_high = c.obstacle(base, new)
        axis = rng.randrange(self.flat)
        at = []
        for i in c.AXES:
            low, high = low_high[i]
            steps = int((high - low) * 2)
            inner = low + F(rng.choice([0, steps]) if rng.random() < 0.3 else rng.randint(0, steps), 2)
            at.append(rng.choice([low, high]) if i == axis else inner if i < self.flat
                      else low + F(rng.randint(1, steps - 1), 2) if steps > 1 else (low + high) / 2)
        return tuple(at)

    def highest(self, base, new, at, pairs):
        """Reading I-4: the pair whose relative interiors hold that of the contact region."""
        for d, f, g in pairs:
            fe, ge = base.features[f], new.features[g]
            if all(self.covers(fe[i], (ge[i][0] + at[i], ge[i][1] + at[i]), base, new, at, i) for i in c.AXES):
                return f, g
        raise AssertionError('no highest pair')

    @staticmethod
    def covers(a, b, base, new, at, i):
        low = max(base.low[i], new.low[i] + at[i])
        high = min(base.high[i], new.high[i] + at[i])

        def holds(x):
            return x[0] == x[1] == low == high or (x[0] < x[1] and (
                x[0] < low < x[1] if low == high else x[0] <= low and high <= x[1]))
        return holds(a) and holds(b)

    # Behaviours

    def sites(self, shape):
        rng = self.rng
        parts = shape.placed(None, None)
        chosen = []
        for part in parts:
            features = list(part.features)
            kind = rng.random()
            if kind < 0.4:
                chosen += [(part.name, f) for f in part.faces]
            elif kind < 0.55:
                size = rng.choice([1, 2])
                chosen += [(part.name, f) for f in features if len(f) == size]
            else:
                faces = list(part.faces)
                for _ in range(rng.choice([0, 1, 1, 2])):
                    pool = faces if rng.random() < 0.6 else features
                    chosen.append((part.name, rng.choice(pool)))
        if not chosen:
            chosen = [(parts[0].name, rng.choice(list(parts[0].faces)))]
        return frozenset(chosen)

    def behaviour(self, shape, depth, names, unguarded, grow=True):
        """Without prefixes in between, one summand at most names a definition: else the ageing of
        recursive sums doubles them at each step."""
        rng = self.rng
        kinds = ['nil'] + ['name'] * 3
        if depth > 0:
            kinds = ['open'] * 5 + ['weak'] * 3 + ['strong'] * 3 + ['eps'] * 3 + ['sum'] * 4 + ['name', 'nil']
        kind = rng.choice(kinds)

        def rest(free):
            return self.behaviour(shape, depth - 1, names, free)

        def waiting(free, grow):
            return self.behaviour(shape, depth - 1, names, free, grow)
        if kind == 'name':
            pool = names if unguarded is None else unguarded
            return ('name', rng.choice(pool)) if pool and grow else ('nil',)
        if kind == 'open':
            name, sites = rng.choice(self.names), self.sites(shape)
            after = rest(None)
            if rng.random() < 0.6:
                after = self.bound(shape, name, sites, after)
            return ('open', name, rng.random() < 0.5, sites, after)
        if kind == 'weak':
            return ('weak', rng.choice(self.names), self.sites(shape), rest(None))
        if kind == 'strong':
            entries = frozenset((rng.choice(self.names), self.sites(shape))
                                for _ in range(rng.choice([1, 1, 1, 2])))
            return ('strong', self.repeated(shape, entries), rest(None))
        if kind == 'eps':
            t = rng.choice([F(0), F(1, 2), F(1), F(1), F(3, 2), F(2)])
            return ('eps', t, waiting(unguarded if t == 0 else None, grow))
        if kind == 'sum':
            return ('sum', (waiting(unguarded, grow), waiting(unguarded, False)))
        return ('nil',)

    def repeated(self, shape, entries):
        """Sometimes an entry twice, with a feature of its closure listed as well (I-17)."""
        if self.aside.random() < 0.7:
            return entries
        name, sites = self.aside.choice(sorted(entries, key=lambda e: (e[0], sorted(map(site_order, e[1])))))
        part, feature = self.aside.choice(sorted(sites, key=site_order))
        lower = [f for p in shape.placed(None, None) if p.name == part for f in p.features if f < feature]
        if not lower:
            return entries
        return entries | {(name, sites | {(part, self.aside.choice(sorted(lower, key=sorted)))})}

    def bound(self, shape, name, sites, after):
        """What a leaf that has just been bound may well do: let go, react, wait, bind again."""
        rng = self.rng
        entries = self.repeated(shape, frozenset([(name, sites)]))
        release = rng.choice([('weak', name, sites, after), ('strong', entries, after)])
        if rng.random() < 0.3:
            release = ('eps', rng.choice([F(1, 2), F(1)]), release)
        if rng.random() < 0.4:
            again = ('open', rng.choice(self.names), rng.random() < 0.5, self.sites(shape), release)
            release = ('sum', (release, again))
        return release

    def define(self, shape):
        names = ['K%d%s' % (i, shape.name) for i in range(self.rng.choice([2, 3, 4]))]
        for i, n in enumerate(names):
            self.on[n] = shape
            b = self.behaviour(shape, self.rng.choice([1, 2, 3]), names, names[i + 1:])
            if i < 2 and b[0] != 'open':
                name, sites = self.rng.choice(self.names), self.sites(shape)
                opening = ('open', name, self.rng.random() < 0.5, sites, self.bound(shape, name, sites, b))
                b = ('sum', (opening, b)) if self.rng.random() < 0.5 else opening
            self.definitions[n] = b

    def behaviour_text(self, b, parts):
        def sites(s):
            return '{%s}' % ', '.join(sorted(site_text(parts, x, self.rng) for x in sorted(s, key=site_order)))

        def entry_order(entry):
            return entry[0], sorted(map(site_order, entry[1]))
        kind = b[0]
        if kind == 'nil':
            return 'nil'
        if kind == 'name':
            return b[1]
        if kind == 'sum':
            return '(%s)' % ' + '.join(self.behaviour_text(s, parts) for s in b[1])
        rest = self.behaviour_text(b[-1], parts)
        if kind == 'open':
            return '<%s%s, %s>. %s' % ('~' if b[2] else '', b[1], sites(b[3]), rest)
        if kind == 'weak':
            return 'omega(%s, %s). %s' % (b[1], sites(b[2]), rest)
        if kind == 'strong':
            return 'rho({%s}). %s' % (', '.join('<%s, %s>' % (n, sites(s)) for n, s in sorted(b[1], key=entry_order)), rest)
        return 'eps(%s). %s' % (b[1], rest)

    # Placing

    def free(self, body, at):
        return not any(c.inside(c.obstacle(p, q), c.minus(at, self.positions[other.name]))
                       for other in self.bodies.values() for p in other.parts for q in body.parts)

    def velocity(self, at):
        """Any, or towards the middle."""
        r = self.rng
        if r.random() < 0.6:
            return tuple(F(0) if i >= self.flat or at[i] == 0 else F(r.choice([1, 1, 2])) * (-1 if at[i] > 0 else 1)
                         for i in c.AXES)
        return tuple(F(r.choice([-2, -1, -1, 0, 1, 1, 2])) if i < self.flat else F(0) for i in c.AXES)

    def aimed(self, body, velocity):
        """A place from which the body gets to one beside another, in a while."""
        other = self.rng.choice(list(self.bodies.values()))
        at = self.beside(self.rng.choice(other.parts), self.rng.choice(body.parts))
        w = c.minus(velocity, self.velocities[other.name])
        t = self.rng.choice([F(0), F(1, 2), F(1), F(1), F(1), F(2)])
        return c.minus(c.plus(at, self.positions[other.name]), c.times(t, w))

    def leaf(self, name, fixed):
        rng = self.rng
        shape = rng.choice(self.shapes)
        turn = rng.choice(QUATERNIONS) if rng.random() < 0.3 else None
        mass = rng.choice([F(1), F(1), F(2), F(3), F(1, 2)])
        parts = shape.placed(turn, None)
        if parts[0].name is None:
            parts[0].mass = mass
        body = c.Body(name, parts, fixed)
        body.shape, body.turn = shape, turn
        return body

    def add(self, body, at, velocity):
        name = body.name
        self.bodies[name], self.positions[name], self.velocities[name] = body, at, velocity
        own = [n for n, s in self.on.items() if s is body.shape]
        own += own[:2] * 2
        self.behaviours[name] = ('name', self.rng.choice(own)) if own and self.rng.random() < 0.9 else ('nil',)

    def place(self):
        rng = self.rng
        extent = rng.choice([2, 3, 4, 6])
        for i in range(rng.choice([2, 3, 3, 4, 5])):
            fixed = i > 0 and rng.random() < 0.25
            group = []
            for j in range(rng.choice([1, 1, 1, 2, 3]) if self.lively else 1):
                if j > 0 and not group:
                    break
                for _ in range(20):
                    body = self.leaf('p%d' % i if j == 0 else 'p%d_%d' % (i, j), fixed and j == 0)
                    if j == 0:
                        at = tuple(F(rng.randint(-2 * extent, 2 * extent), 2) if k < self.flat
                                   else F(rng.randint(-1, 1), 2) for k in c.AXES)
                        velocity = c.ZERO if fixed else self.velocity(at)
                        if self.bodies and rng.random() < 0.6:
                            at = self.aimed(body, velocity)
                        if self.free(body, at):
                            self.add(body, at, velocity)
                            group.append(body)
                            break
                        continue
                    other = rng.choice(group)
                    p, q = rng.choice(other.parts), rng.choice(body.parts)
                    at = c.plus(self.positions[other.name], self.beside(p, q))
                    if not self.free(body, at):
                        continue
                    pairs = c.touching_pairs(p, q, c.minus(at, self.positions[other.name]))
                    _, f, g = rng.choice(pairs)
                    self.add(body, at, self.velocities[group[0].name])
                    group.append(body)
                    self.bonds.append((rng.choice(self.names), (other.name, p.name, f), (body.name, q.name, g)))
                    break
            if group:
                self.groups.append(group)

    def linking(self, faces):
        """A behaviour that binds with several neighbours, and lets go of one or two."""
        rng = self.rng
        name, then = rng.choice(self.names), rng.choice([('name', 'Link0'), ('name', 'Link1'), ('nil',)])
        sites = frozenset((None, f) for f in faces)
        if rng.random() < 0.55:
            return ('open', name, rng.random() < 0.5, sites, then)
        if rng.random() < 0.5:
            return ('weak', name, sites, then)
        half = frozenset((None, f) for f in rng.sample(faces, 3))
        entries = [(name, sites)] if rng.random() < 0.3 else [(name, half), (rng.choice(self.names), sites - half)]
        return ('eps', F(1), ('strong', frozenset(entries), then))

    def square(self):
        """Four cubes far away, with three or four bonds around (reading I-37)."""
        rng = self.rng
        shape = Shape('Ring', [(None, 'Cube', (F(1),) * 3, c.ZERO, F(0))], 'shape Ring = Cube\n')
        self.shapes.append(shape)
        faces = list(shape.placed(None, None)[0].faces)
        for name in ('Link0', 'Link1'):
            self.on[name] = shape
            self.definitions[name] = ('sum', (self.linking(faces), ('sum', (self.linking(faces), self.linking(faces)))))
        group, velocity = [], rng.choice([c.ZERO, (F(0), F(0), F(1))])
        for i, (x, y) in enumerate([(0, 0), (1, 0), (1, 1), (0, 1)]):
            parts = shape.placed(None, None)
            parts[0].mass = F(rng.choice([1, 1, 2]))
            body = c.Body('s%d' % i, parts, False)
            body.shape, body.turn = shape, None
            side = body.parts[0].high[0] - body.parts[0].low[0]
            self.add(body, (60 + x * side, y * side, F(0)), velocity)
            self.behaviours[body.name] = ('name', rng.choice(['Link0', 'Link1']))
            group.append(body)
        bonds = []
        for p, q in zip(group, group[1:] + group[:1]):
            pairs = c.touching_pairs(p.parts[0], q.parts[0], c.minus(self.positions[q.name], self.positions[p.name]))
            _, f, g = max(pairs, key=lambda pair: pair[0])
            bonds.append((rng.choice(self.names), (p.name, None, f), (q.name, None, g)))
        rng.shuffle(bonds)
        self.bonds += bonds[:rng.choice([3, 3, 4])]
        self.groups.append(group)

    def laws(self):
        self.law_texts = []
        if self.rng.random() < 0.35:
            drawn, few = self.aside.random() < 0.3, self.aside.random() < 0.6
            for body in self.bodies.values():
                if not body.fixed and self.rng.random() < 0.7:
                    k = F(self.rng.choice([1, 2, 1, 4]), self.rng.choice([1, 2]))
                    text, body.law = self.rng.choice(LAWS)(k)
                    if drawn and not few and self.aside.random() < 0.7:
                        text, body.law = self.aside.choice(CHOICES)(k)
                        body.chooses = True
                    self.law_texts.append('motion %s = %s\n' % (body.name, text))
            if drawn and few:
                self.few_places()
        if self.walkers:
            self.all_walk()

    def all_walk(self):
        """Laws that choose for most bodies: to and fro, among others that rest or fly."""
        self.law_texts = []
        for body in self.bodies.values():
            body.law, body.chooses = None, False
            if not body.fixed and self.stopping.random() < 0.8:
                k = self.stopping.choice([F(1), F(1, 2), F(2)]) / self.timestep
                returns = self.stopping.random() < 0.6
                text, body.law = self.stopping.choice(RETURNS)(self.timestep) if returns else self.stopping.choice(CHOICES)(k)
                body.chooses = True
                self.law_texts.append('motion %s = %s\n' % (body.name, text))

    def few_places(self):
        """Laws for all that leave bodies but few places to be in, so that states come again."""
        self.law_texts = []
        for body in self.bodies.values():
            if not body.fixed:
                text, body.law = self.aside.choice(RETURNS)(self.timestep)
                body.chooses = True
                self.law_texts.append('motion %s = %s\n' % (body.name, text))

    def channels(self):
        """The channels of the bonds, and of the behaviours that the leaves can come to."""
        found, seen = {b[0] for b in self.bonds}, set()
        todo = list(self.behaviours.values())
        while todo:
            b = todo.pop()
            if b[0] == 'name' and b not in seen:
                seen.add(b)
                todo.append(self.definitions[b[1]])
            elif b[0] == 'sum':
                todo += b[1]
            elif b[0] in ('open', 'weak', 'strong', 'eps'):
                todo.append(b[-1])
                found |= {n for n, _ in b[1]} if b[0] == 'strong' else {b[1]} if b[0] != 'eps' else set()
        return sorted(found)

    # Out

    def initial(self):
        processes = []
        for group in self.groups:
            leaves = []
            names = {b.name for b in group}
            for body in group:
                b = c.canonical(self.behaviours[body.name], self.definitions)
                leaves.append(c.Leaf(body.name, self.positions[body.name], b, b[1] if b[0] == 'name' else None))
            bonds = [(n, frozenset([x, y])) for n, x, y in self.bonds if x[0] in names]
            processes.append(self.calculus.process(self.velocities[group[0].name], leaves, bonds))
        return self.calculus.initial(processes)

    def text(self):
        out = ['model random%d\n' % self.seed, 'timestep %s%s\n' % (self.timestep, ' steady' * self.steady)]
        out += ['blocked %s\n' % self.blocked] * (self.blocked != 'bounce')
        out += ['collisions together\n'] * self.together + ['binding contact\n'] * self.by_contact
        out += ['bonds cyclic\n'] * self.cyclic
        if self.split_step:
            out.append('split_step %s\n' % self.split_step)
        out += [TEMPLATES['Cube'], TEMPLATES['Brick']] + [s.text for s in self.shapes]
        for n, b in self.definitions.items():
            shape = self.on[n]
            out.append('behaviour %s on %s = %s\n' % (n, shape.name, self.behaviour_text(b, shape.placed(None, None))))
        for group in self.groups:
            for body in group:
                out.append(self.declaration(body))
        for name, x, y in self.bonds:
            ends = [e[0] + '.' + site_text(self.bodies[e[0]].parts, e[1:]) for e in (x, y)]
            out.append('bond <%s, {%s, %s}>\n' % (name, *ends))
        return ''.join(out + self.law_texts)

    def declaration(self, body):
        at = 'at translate ' + vector(self.positions[body.name])
        if body.turn:
            at += ' * rotate quaternion ' + vector(body.turn)
        mass = '' if body.fixed or body.parts[0].name is not None else ' mass %s' % body.parts[0].mass
        velocity = '' if body.fixed else ' velocity ' + vector(self.velocities[body.name])
        behaviour = self.behaviour_text(self.behaviours[body.name], body.parts)
        return '%s %s = %s%s%s %s [%s]\n' % ('fixed' if body.fixed else 'process', body.name, body.shape.name,
                                             mass, velocity, at, behaviour)


if __name__ == '__main__':
    import sys
    print(Model(int(sys.argv[1])).text(), end='')
