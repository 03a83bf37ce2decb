#!/usr/bin/env python3
"""A small simulator of the translational calculus in plain floats: one convex solid to a body, faces alone bind.

float_sim.py SCENE [--seed N] [--format csv|jsonl]: writes the trace of one run. It shares nothing with scc.
"""

import argparse
import json
import random

from scenes import SCENES
from solids import EPSILON, add, dot, first_contact, scale, sub


class Process:
    def __init__(self, leaves, velocity, bonds=()):
        self.leaves, self.velocity, self.bonds = sorted(leaves), velocity, list(bonds)
        self.clock = None


class Run:
    def __init__(self, scene, seed):
        self.scene, self.random = scene, random.Random(seed)
        self.bodies = {b['name']: b for b in scene.bodies}
        self.at = {n: b['at'] for n, b in self.bodies.items()}
        self.behaviour = {n: b['behaviour'] for n, b in self.bodies.items()}
        self.processes = []
        left = set(self.bodies)
        for bond in scene.bonds:
            pair = [end[0] for end in bond[1]]
            left -= set(pair)
            self.processes.append(Process(pair, self.bodies[pair[0]]['velocity'], [bond]))
        self.processes += [Process([n], self.bodies[n]['velocity']) for n in left]
        self.time, self.left, self.since, self.items = 0.0, scene.timestep, 0.0, []
        self.steered = any(b['law'] for b in scene.bodies)
        self.due, self.steered_now = True, False
        for p in self.processes:
            self.restart(p)
        self.record_state()

    # Behaviours

    def offers(self, term):
        """(prefix, what follows) of each summand that may act now."""
        if term[0] == 'sum':
            return self.offers(term[1]) + self.offers(term[2])
        if term[0] == 'call':
            return self.offers(self.scene.definitions[term[1]])
        if term[0] == 'delay':
            return self.offers(term[2]) if term[1] < EPSILON else []
        return [] if term[0] == 'nil' else [(term[:-1], term[-1])]

    def horizon(self, term):
        if term[0] == 'sum':
            return min(self.horizon(term[1]), self.horizon(term[2]))
        if term[0] == 'call':
            return self.horizon(self.scene.definitions[term[1]])
        if term[0] == 'delay':
            return term[1] if term[1] >= EPSILON else self.horizon(term[2])
        return float('inf')

    def aged(self, term, d):
        if self.horizon(term) == float('inf'):
            return term
        if term[0] == 'sum':
            return ('sum', self.aged(term[1], d), self.aged(term[2], d))
        if term[0] == 'call':
            return self.aged(self.scene.definitions[term[1]], d)
        if term[1] - d < EPSILON:
            return term[2]
        return ('delay', term[1] - d, term[2])

    # Processes

    def fixed(self, p):
        return any(self.bodies[n]['fixed'] for n in p.leaves)

    def mass(self, p):
        return sum(self.bodies[n]['mass'] for n in p.leaves)

    def restart(self, p):
        p.clock = 0.0 if self.weak(p) else None

    def weak(self, p):
        found = []
        for bond in p.bonds:
            (n, f), (m, g) = bond[1]
            for o, rest in self.offers(self.behaviour[n]):
                for q, other in self.offers(self.behaviour[m]):
                    if o[0] == q[0] == 'weak' and o[1] == q[1] == bond[0] and f in o[2] and g in q[2]:
                        found.append(([bond], {n: rest, m: other}))
        return found

    def strong(self, p):
        """Reactions of one bond each, which is all that the scenes have."""
        found = []
        for bond in p.bonds:
            ends = []
            for n, f in bond[1]:
                ends.append([(n, rest) for o, rest in self.offers(self.behaviour[n])
                             if o[0] == 'strong' and len(o[1]) == 1 and o[1][0][0] == bond[0] and f in o[1][0][1]])
            found += [([bond], dict([one, two])) for one in ends[0] for two in ends[1]]
        return found

    def split(self, p, released, changed):
        self.behaviour.update(changed)
        velocity = (0.0, 0.0, 0.0) if self.fixed(p) else p.velocity
        bonds, left = [b for b in p.bonds if b not in released], list(p.leaves)
        self.processes.remove(p)
        while left:
            piece, size = {left[0]}, 0
            while len(piece) > size:
                size = len(piece)
                for b in bonds:
                    names = {end[0] for end in b[1]}
                    if names & piece:
                        piece |= names
            q = Process(piece, velocity, [b for b in bonds if b[1][0][0] in piece])
            self.processes.append(q)
            self.restart(q)
            left = [n for n in left if n not in piece]

    # Collisions

    def contacts(self):
        """(time, p, q, leaf of p, leaf of q, normal) of every two processes, the first in time of each."""
        found = []
        for i, p in enumerate(self.processes):
            for q in self.processes[i + 1:]:
                w = sub(q.velocity, p.velocity)
                if dot(w, w) < EPSILON:
                    continue
                hits = []
                for n in p.leaves:
                    for m in q.leaves:
                        hit = first_contact(self.bodies[n]['solid'], self.bodies[m]['solid'],
                                            sub(self.at[m], self.at[n]), w)
                        if hit:
                            hits.append((hit[0], p, q, n, m, hit[1]))
                if hits:
                    found.append(min(hits, key=lambda h: h[0]))
        return found

    def candidates(self, n, m, normal):
        f = self.bodies[n]['solid'].face_towards(normal)
        g = self.bodies[m]['solid'].face_towards(scale(-1.0, normal))
        found = []
        for o, rest in self.offers(self.behaviour[n]):
            for q, other in self.offers(self.behaviour[m]):
                if o[0] == q[0] == 'open' and o[1] == q[1] and o[2] != q[2] and f in o[3] and g in q[3]:
                    found.append((o[1], ((n, f), (m, g)), {n: rest, m: other}))
        return found

    def collide(self, p, q, n, m, normal):
        candidates = self.candidates(n, m, normal)
        mp, mq = self.mass(p), self.mass(q)
        if candidates:
            name, ends, changed = self.random.choice(candidates)
            velocity = (0.0, 0.0, 0.0)
            if not self.fixed(p) and not self.fixed(q):
                velocity = scale(1 / (mp + mq), add(scale(mp, p.velocity), scale(mq, q.velocity)))
            self.behaviour.update(changed)
            whole = Process(p.leaves + q.leaves, velocity, p.bonds + q.bonds + [(name, ends)])
            self.processes = [r for r in self.processes if r is not p and r is not q] + [whole]
            self.restart(whole)
            self.record('bind', [(name, ends)])
        else:
            change = scale(-2 * dot(sub(q.velocity, p.velocity), normal), normal)
            share = 0.0 if self.fixed(p) else 1.0 if self.fixed(q) else mq / (mp + mq)
            p.velocity = sub(p.velocity, scale(share, change))
            q.velocity = add(q.velocity, scale(1 - share, change))
            self.restart(p)
            self.restart(q)
            self.record('bounce', [], [n, m])

    # Time

    def settle(self):
        """The end of a movement step, once an instant, when nothing collides any more."""
        if not self.steered or not self.due or self.steered_now or any(c[0] < EPSILON for c in self.contacts()):
            return
        for p in self.processes:
            if not self.fixed(p):
                change = (0.0, 0.0, 0.0)
                for n in p.leaves:
                    law = self.bodies[n]['law']
                    if law:
                        new = law(p.velocity, self.since)
                        part = self.bodies[n]['mass'] / self.mass(p)
                        change = add(change, scale(part, sub(new, p.velocity)))
                p.velocity = add(p.velocity, change)
        self.left, self.since, self.due, self.steered_now = self.scene.timestep, 0.0, False, True

    def pass_time(self, d):
        for p in self.processes:
            expired = min(self.horizon(self.behaviour[n]) for n in p.leaves) < d + EPSILON
            for n in p.leaves:
                self.at[n] = add(self.at[n], scale(d, p.velocity))
                self.behaviour[n] = self.aged(self.behaviour[n], d)
            if expired:
                self.restart(p)
            elif p.clock is not None:
                p.clock += d
                if p.clock > self.scene.split_step - EPSILON:
                    p.clock = 0.0
        self.time += d
        self.left -= d
        self.since += d
        self.due, self.steered_now = self.left < EPSILON, False

    def instant(self):
        """All that happens now; what is optional by chance."""
        while True:
            self.settle()
            reactions = [(p, s) for p in self.processes for s in self.strong(p)]
            if reactions:
                p, (released, changed) = self.random.choice(reactions)
                self.split(p, released, changed)
                self.record('strong', released)
                continue
            now = [c for c in self.contacts() if c[0] < EPSILON]
            if now:
                self.due = True
                self.collide(*self.random.choice(now)[1:])
                continue
            break
        for p in list(self.processes):
            if p.clock == 0.0 and p in self.processes:
                choices = self.weak(p)
                if choices and self.random.random() < 0.4:
                    released, changed = self.random.choice(choices)
                    self.split(p, released, changed)
                    self.record('weak', released)
                    return self.instant()
        if self.steered_now and self.items[-1]['time'] < self.time:
            self.record_state()

    def run(self):
        while True:
            self.instant()
            times = [c[0] for c in self.contacts()]
            times += [self.horizon(b) for b in self.behaviour.values()]
            times += [self.scene.split_step - p.clock for p in self.processes if p.clock is not None]
            if self.steered:
                times.append(self.left)
            times = [t for t in times if t > EPSILON / 2]
            d = min(times, default=float('inf'))
            if self.time + d > self.scene.time:
                self.pass_time(self.scene.time - self.time)
                self.record_state()
                self.items.append(dict(what='end', time=self.time))
                return self.items
            if self.random.random() < 0.3:
                self.pass_time(d / 2)
                self.record_state()
                d -= d / 2
            self.pass_time(d)

    # What is written

    def record(self, kind, bonds, between=None):
        self.items.append(dict(what=kind, time=self.time, between=between or [],
                               bonds=[(name, [(n, f) for n, f in ends]) for name, ends in bonds]))
        self.record_state()

    def record_state(self):
        self.settle()
        self.items.append(dict(what='state', time=self.time, processes=[
            dict(velocity=p.velocity, leaves=[(n, self.at[n]) for n in p.leaves], bonds=list(p.bonds))
            for p in self.processes]))


def text(x):
    return repr(float(x))


def csv(items, fixed=()):
    rows = ['time,event,bodies,channel,features,x,y,z,vx,vy,vz']
    for i in items:
        time = text(i['time'])
        if i['what'] == 'state':
            for p in i['processes']:
                for n, at in p['leaves']:
                    if n not in fixed:
                        rows.append(','.join([time, 'state', n, '', ''] + list(map(text, at + p['velocity']))))
        elif i['what'] == 'bounce':
            rows.append(','.join([time, 'bounce', ';'.join(i['between'])]))
        elif i['what'] in ('bind', 'weak', 'strong'):
            ends = [end for _, two in i['bonds'] for end in two]
            rows.append(','.join([time, i['what'], ';'.join(n for n, _ in ends), ';'.join(n for n, _ in i['bonds']),
                                  ';'.join('%s.%s' % end for end in ends)]))
        else:
            rows.append(','.join([time, i['what']]))
    return '\n'.join(rows) + '\n'


def bond_json(bond):
    return dict(name=bond[0], ends=['%s.%s' % end for end in bond[1]])


def state_json(i):
    return dict(processes=[
        dict(velocity=p['velocity'], bonds=[bond_json(b) for b in p['bonds']],
             leaves=[dict(name=n, position=at) for n, at in p['leaves']]) for p in i['processes']])


def label_json(i):
    if i['what'] == 'bounce':
        return dict(kind='bounce', between=i['between'])
    if i['what'] == 'strong':
        return dict(kind='strong', bonds=[bond_json(b) for b in i['bonds']])
    return dict(kind=i['what'], **bond_json(i['bonds'][0]))


def jsonl(items, parameters=()):
    lines = [dict(type='header', format='scc-trace', version=1, parameters=dict(parameters))]
    for i in items:
        if i['what'] == 'state':
            lines.append(dict(type='state', time=i['time'], state=state_json(i)))
        elif i['what'] == 'end':
            lines.append(dict(type='end', time=i['time']))
        elif i['what'] in ('quiescent', 'stuck'):
            lines.append(dict(type='end', time=i['time'], ending=i['what']))
        else:
            lines.append(dict(type='transition', time=i['time'], label=label_json(i)))
    return ''.join(json.dumps(line) + '\n' for line in lines)


def simulate(name, seed):
    """The scene and the items of a run of it."""
    scene = SCENES[name]()
    return scene, Run(scene, seed).run()


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument('scene', choices=sorted(SCENES))
    parser.add_argument('--seed', type=int, default=1)
    parser.add_argument('--format', choices=['csv', 'jsonl'], default='csv')
    options = parser.parse_args()
    scene, items = simulate(options.scene, options.seed)
    print(csv(items) if options.format == 'csv' else jsonl(items, scene.parameters), end='')


if __name__ == '__main__':
    main()
