"""Reads what scc prints, into the terms of calculus.py."""

from fractions import Fraction as F
import re

import calculus as c


class Difference(Exception):
    """Between scc and the naive calculus."""


TOKEN = re.compile(r"\s*([A-Za-z_][A-Za-z0-9_']*|\d+|.)")


class Reader:
    """Behaviours and sites, in the syntax of the language."""

    def __init__(self, text, parts):
        self.tokens = TOKEN.findall(text)
        self.parts = {p.name: p for p in parts}

    def take(self, expected=None):
        token = self.tokens.pop(0)
        if expected is not None and token != expected:
            raise Difference('cannot read behaviour: %s where %s expected' % (token, expected))
        return token

    def peek(self):
        return self.tokens[0] if self.tokens else None

    def sum(self):
        summands = [self.prefix()]
        while self.peek() == '+':
            self.take()
            summands.append(self.prefix())
        return summands[0] if len(summands) == 1 else ('sum', tuple(summands))

    def prefix(self):
        token = self.take()
        if token == '(':
            b = self.sum()
            self.take(')')
            return b
        if token == 'nil':
            return ('nil',)
        if token == '<':
            name, barred, sites = self.channel()
            return ('open', name, barred, sites, self.rest())
        if token == 'omega' and self.peek() == '(':
            self.take('(')
            name = self.take()
            self.take(',')
            sites = self.sites()
            self.take(')')
            return ('weak', name, sites, self.rest())
        if token == 'rho' and self.peek() == '(':
            self.take('(')
            self.take('{')
            entries = []
            while self.take('<'):
                name, _, sites = self.channel()
                entries.append((name, sites))
                if self.take() == '}':
                    break
            self.take(')')
            return ('strong', frozenset(entries), self.rest())
        if token == 'eps' and self.peek() == '(':
            self.take('(')
            t = self.number()
            self.take(')')
            return ('eps', t, self.rest())
        return ('name', token)

    def rest(self):
        self.take('.')
        return self.prefix()

    def number(self):
        text = ''
        while self.peek() not in (')', ',', '}'):
            text += self.take()
        return F(text)

    def channel(self):
        barred = self.peek() == '~'
        if barred:
            self.take()
        name = self.take()
        self.take(',')
        sites = self.sites()
        self.take('>')
        return name, barred, sites

    def sites(self):
        self.take('{')
        found = []
        while True:
            found.append(self.site())
            if self.take() == '}':
                return frozenset(found)

    def site(self):
        """part.face, part.[v,w], face, [v,w]."""
        part = None
        while True:
            token = self.take()
            if token == '[':
                names = [self.take()]
                while self.take() == ',':
                    names.append(self.take())
                return part, frozenset(names)
            if self.peek() == '.':
                self.take()
                part = token
                continue
            for vertices, face in self.parts[part].faces.items():
                if face == token:
                    return part, vertices
            return part, frozenset([token])


class Output:
    """What scc prints about one model, in the terms of calculus.py."""

    def __init__(self, bodies):
        self.bodies = bodies
        self.known = {}

    def behaviour(self, leaf, text):
        body = self.bodies[leaf]
        key = (leaf, text)
        if key not in self.known:
            reader = Reader(text, body.parts)
            self.known[key] = c.canonical(reader.sum())
            if reader.tokens:
                raise Difference('cannot read behaviour %s' % text)
        return self.known[key]

    def end(self, text):
        leaf, rest = text.split('.', 1)
        return (leaf,) + Reader(rest, self.bodies[leaf].parts).site()

    def bond(self, name, ends):
        return name, frozenset(self.end(e) for e in ends)

    def vector(self, v):
        return tuple(F(a) for a in v)

    def state(self, s, time):
        processes = []
        for p in s['processes']:
            leaves = [c.Leaf(l['name'], self.vector(l['position']), self.behaviour(l['name'], l['behaviour']),
                             l['origin']) for l in p['leaves']]
            bonds = frozenset(self.bond(b['name'], b['ends']) for b in p['bonds'])
            clock = None if p['clock'] is None else F(p['clock'])
            draw = p.get('draw')
            processes.append(c.Process(self.vector(p['velocity']), clock, tuple(sorted(leaves)), bonds,
                                       self.vector(draw) if isinstance(draw, list) else draw))
        processes.sort(key=lambda p: p.leaves[0].name)
        step = s['step'] and (F(s['step']['remaining']), s['step']['phase'])
        return c.State(tuple(processes), step, F(time))

    def label(self, label, before):
        kind = label['kind']
        if kind == 'time':
            return ('time', F(label['duration']))
        if kind in ('bind', 'close', 'weak'):
            return (kind, self.bond(label['name'], label['ends']))
        if kind == 'strong':
            return ('strong', frozenset(self.bond(b['name'], b['ends']) for b in label['bonds']))
        if kind == 'bounce':
            return ('bounce', frozenset(self.process_of(name, before) for name in label['between']))
        if kind == 'draw':
            drawn = self.vector(label['velocity'])
            return ('draw', self.process_of(label['process'], before), drawn, F(label['chance']))
        raise Difference('label %s' % label)

    def process_of(self, name, state):
        for p in state.processes:
            leaves = frozenset(l.name for l in p.leaves)
            if name in leaves:
                return leaves
        raise Difference('no process %s' % name)
