#!/usr/bin/env python3
"""An engine that asks `scc oracle` when bodies meet and what becomes of them, and nothing else, against `scc trace`.

    stepping.py --scc SCC --client CLIENTS/PYTHON/SRC [--count N] [--seed N]

Random rigid models of two and more bodies with the dynamics constant_spin, where nothing binds, and a body far away whose
behaviour stops time again and again in mid-turn. What the rules of turns say is written here; every number of a trace, its
times and states, must come out. The last line is `N passed, N failed`.
"""

import argparse
import json
from fractions import Fraction as F
import os
import subprocess
import sys
import tempfile

import rigid as r
from rigid import Difference
import rigid_models
import solids as s


def require(condition, text, *details):
    if not condition:
        raise Difference(text % details)


TICKS = 40


class Model(rigid_models.Model):
    def __init__(self, seed):
        super().__init__(seed)
        self.free, self.orientation, self.velocity = False, None, None
        self.resolution = self.rng.choice([F(1, 8), F(1, 64), F(1, 1000)])
        self.tick = F(1, self.rng.randint(3, 13))
        self.bodies['clock'] = r.Body({None: self.solid('Cube', (1, 1, 1), s.ZERO, F(1))}, False)
        self.lines.append('process clock = Cube mass 1 at translate (1000, 0, 0) [%snil]\n' % (
            ('eps(%s). ' % self.tick) * TICKS))

    def suits(self):
        return not self.lively and not any(word in self.text() for word in ('rho', 'omega'))


class Engine:
    def __init__(self, oracle, requests, model, state):
        self.oracle, self.requests, self.model = oracle, requests, model
        self.resolution = model.the_resolution()
        self.shapes, self.starts, self.seen = {}, {}, {}
        self.processes, self.now = state.processes, F(0)
        for p in self.processes:
            self.begun(p)

    def found(self, what):
        self.seen[what] = self.seen.get(what, 0) + 1

    def shape(self, solid, turned=None):
        key = (id(solid), turned)
        if key not in self.shapes:
            self.shapes[key] = self.oracle.define_shape(solid.corners, solid.faces, quaternion=turned)
        return self.shapes[key]

    def begun(self, p):
        """How the leaves were when the present turn began."""
        centre = p.leaves[0].position if p.fixed else p.centre()
        self.starts[p.names] = {l.name: (l.turned, s.sub(l.position, centre)) for l in p.leaves}

    # Questions

    def parts(self, p):
        return [(leaf, solid) for leaf in p.leaves for solid in leaf.body.parts.values()]

    def side(self, p, leaf, letter):
        turned, arm = self.starts[p.names][leaf.name]
        if p.spin == s.ZERO:
            return {'turned_' + letter: leaf.turned}
        return {'turned_' + letter: turned, 'arm_' + letter: arm, 'spin_' + letter: p.spin, 'since_' + letter: p.since}

    def time(self, p, q, until):
        """When two processes meet, if that is at most `until`; None: at any time, of two that do not spin."""
        velocity, times = s.sub(q.velocity, p.velocity), []
        for a, one in self.parts(p):
            for b, two in self.parts(q):
                offset = s.sub(b.position, a.position)
                if p.spin == q.spin == s.ZERO:
                    shapes = self.shape(one, a.turned), self.shape(two, b.turned)
                    meeting = self.oracle.first_time_of_contact(*shapes, offset, velocity)
                else:
                    meeting = self.oracle.first_time_of_contact(
                        self.shape(one), self.shape(two), offset, velocity, until=until, resolution=self.resolution,
                        phase='turn', **self.side(p, a, 'a'), **self.side(q, b, 'b'))
                    if p.since or q.since:
                        self.found('asked in mid-turn')
                require(meeting.outcome != 'inside', 'interpenetration')
                if meeting.time is not None and (until is None or meeting.time <= until):
                    times.append(meeting.time)
        return min(times, default=None)

    def moving_pairs(self):
        ps = self.processes
        return [(i, j) for i in range(len(ps)) for j in range(i + 1, len(ps))
                if ps[i].velocity != ps[j].velocity or ps[i].spin != s.ZERO or ps[j].spin != s.ZERO]

    def colliding(self):
        return [(i, j) for i, j in self.moving_pairs() if self.time(self.processes[i], self.processes[j], F(0)) == 0]

    def responded(self, p, q):
        touching = []
        for a, one in self.parts(p):
            for b, two in self.parts(q):
                pair = (self.shape(one), self.shape(two), s.sub(b.position, a.position))
                how = {'turned_a': a.turned, 'turned_b': b.turned}
                if self.oracle.contact(*pair, resolution=self.resolution, **how).relation != 'apart':
                    touching.append(self.requests.Touch(*pair, at=a.position, **how))
        require(touching, 'they collide, and nothing is near')

        def body(o):
            if o.fixed:
                return self.requests.Fixed()
            return self.requests.Body(o.mass(), o.velocity, o.centre(), o.inertia(), o.spin)
        after = self.oracle.response(touching, body(p), body(q), resolution=self.resolution)
        require(after.outcome == 'bounced', 'a bounce that is none')
        return [o.moved(o.leaves, m.velocity, m.spin, F(0)).lasting(None) if not o.fixed else o.lasting(None)
                for o, m in ((p, after.first), (q, after.second))]

    # Transitions

    def step(self, label, among):
        pairs = self.colliding()
        if pairs:
            require(label['kind'] == 'bounce', 'a collision is due')
            require(among == len(pairs), '%d collide', len(pairs))
            i, j = sorted(next(k for k, p in enumerate(self.processes) if n in p.names) for n in label['between'])
            require((i, j) in pairs, 'they do not collide')
            self.processes[i], self.processes[j] = self.responded(self.processes[i], self.processes[j])
            self.begun(self.processes[i])
            self.begun(self.processes[j])
        else:
            require(label['kind'] == 'time', 'nothing collides')
            d = self.least_time()
            require(d == F(label['duration']), 'time stops after %s', d)
            self.now += d
            self.processes = [p.passed(d) for p in self.processes]
            self.end(i for i, p in enumerate(self.processes) if p.spin != s.ZERO and p.since == p.lasts)
        self.found(label['kind'])
        self.settle()

    def least_time(self):
        ends = [p.lasts - p.since for p in self.processes if p.spin != s.ZERO]
        ticks = self.now // self.model.tick
        if ticks < TICKS:
            ends.append((ticks + 1) * self.model.tick - self.now)
        d = min(ends, default=None)
        for i, j in self.moving_pairs():
            t = self.time(self.processes[i], self.processes[j], d)
            d = d if t is None else t
        return d

    def end(self, those):
        for i in those:
            self.processes[i] = self.processes[i].renewed()
            self.begun(self.processes[i])

    def settle(self):
        """The turns of what collides end, until nobody whose turn goes on collides; then those that are due begin."""
        while True:
            colliding = {i for pair in self.colliding() for i in pair}
            ended = [i for i in colliding if self.processes[i].spin != s.ZERO and self.processes[i].lasts is not None]
            if not ended:
                break
            if any(self.processes[i].since for i in ended):
                self.found('contacts in mid-turn')
            self.end(ended)
        for i, p in enumerate(self.processes):
            if p.lasts is None and i not in colliding:
                self.processes[i] = p.plain_turn(self.model.timestep)

    def compare(self, state):
        for p in state.processes:
            mine = next(o for o in self.processes if o.names == p.names)
            require(mine.same(p), '%s', p.difference(mine))


def run(options, oracle, requests, model, path, seen):
    from shapecalculus import LimitExceeded
    with open(path, 'w') as f:
        f.write(model.text())
    done = subprocess.run([options.scc, 'trace', path, '--choose', 'random:1', '--steps', str(options.steps)],
                          stdout=subprocess.PIPE, stderr=subprocess.PIPE, universal_newlines=True)
    require(done.returncode in (0, 2), 'exit code %d: %s', done.returncode, done.stderr.strip()[:600])
    engine = None
    for j in map(json.loads, done.stdout.splitlines()):
        if j['type'] == 'state':
            engine = Engine(oracle, requests, model, r.State(model.bodies, j['state']))
        elif j['type'] == 'transition':
            try:
                engine.step(j['label'], j['of'])
                engine.compare(r.State(model.bodies, j['state']))
            except LimitExceeded:  # numbers have grown too long to be asked about
                engine.found('cut')
                break
            except Difference as d:
                raise Difference('step %d, %s: %s' % (j['step'], j['label']['text'], d))
    for shape in engine.shapes.values():
        oracle.release_shape(shape)
    for what, n in engine.seen.items():
        seen[what] = seen.get(what, 0) + n


def main():
    if hasattr(sys, 'set_int_max_str_digits'):
        sys.set_int_max_str_digits(0)
    parser = argparse.ArgumentParser()
    parser.add_argument('--scc', required=True)
    parser.add_argument('--client', required=True)
    parser.add_argument('--count', type=int, default=40)
    parser.add_argument('--seed', type=int, default=1, help='where the search for models begins')
    parser.add_argument('--steps', type=int, default=12, help='of a run, at most')
    options = parser.parse_args()
    sys.path.insert(0, options.client)
    from shapecalculus import Oracle, requests
    passed, failed, seen, seed = 0, 0, {}, options.seed
    with tempfile.TemporaryDirectory() as folder, Oracle(options.scc) as oracle:
        while passed + failed < options.count:
            model = Model(seed)
            if model.suits():
                try:
                    run(options, oracle, requests, model, os.path.join(folder, 'model.sc'), seen)
                    passed += 1
                except Difference as fault:
                    failed += 1
                    print('model %d: %s' % (seed, str(fault)[:1500]), flush=True)
            seed += 1
    print('seen: %s' % ', '.join('%d %s' % (n, k) for k, n in sorted(seen.items())))
    print('%d passed, %d failed' % (passed, failed))
    sys.exit(1 if failed else 0)


if __name__ == '__main__':
    main()
