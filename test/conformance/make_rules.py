"""Cases by hand: a few for each definition, rule and reading, small enough to be followed with a pencil."""

from cases import HAND, Suite, load, num, nums, result, unordered

CUBE = """shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]
           right [b,c,g,f]   front [a,b,f,e]  back [d,h,g,c]
}
"""

TIME, BIND, CLOSE, BOUNCE, ABSORB, WEAK, STRONG = ({'kind': k} for k in ('time', 'bind', 'close', 'bounce', 'absorb', 'weak', 'strong'))


def passes(duration):
    return {'kind': 'time', 'duration': num(duration)}


def binds(name, one, other):
    return {'kind': 'bind', 'name': name, 'ends': unordered([one, other])}


def closes(name, one, other):
    return {'kind': 'close', 'name': name, 'ends': unordered([one, other])}


def releases(name, one, other):
    return {'kind': 'weak', 'name': name, 'ends': unordered([one, other])}


def at_once(*bonds):
    """By lot; each with its push, if it has one."""
    def told(name, one, other, push=None):
        bond = {'name': name, 'ends': unordered([one, other])}
        return bond if push is None else {**bond, 'push': num(push)}

    return {'kind': 'weak', 'bonds': unordered([told(*b) for b in bonds])}


def reacts(*bonds):
    return {'kind': 'strong', 'bonds': unordered([{'name': n, 'ends': unordered([x, y])} for n, x, y in bonds])}


def bounces(one, other):
    return {'kind': 'bounce', 'between': unordered([one, other])}


def absorbs(one, drain):
    return {'kind': 'absorb', 'between': [one, drain]}


class Rule(Suite):
    """The cases of one rule, in a file of its own."""

    def __init__(self, rule, *more):
        super().__init__('rules/%s/cases.json' % rule, 'By hand, for %s of the rule book.' % rule, HAND)
        self.rules = [rule, *more]
        self.rule = rule
        self.count = 0

    def add_next(self, note, method, params, expect, along=None, rules=()):
        self.count += 1
        self.add(str(self.count), self.rules + list(rules), method, params, expect, note=note, along=along)

    def model(self, body, cube=True):
        text = (CUBE if cube else '') + body
        for name, thing in self.given.items():
            if thing['params'].get('text') == text:
                return '@' + name
        return self.give('model %d' % (len(self.given) + 1), load(text))

    def verdict(self, note, model, formula, verdict, limits=None, rules=()):
        params = {'model': self.model(model), 'formula': formula}
        if limits:
            params['limits'] = limits
        self.add_next(note, 'evaluate', params, result(kind='temporal', verdict=verdict), rules=rules)

    def measured(self, note, model, formula, limits=None, **values):
        """Numbers that are asked for: least and greatest, as rationals."""
        told = [{'over': side, 'low': num(values[side]), 'high': num(values[side])}
                for side in ('least', 'greatest') if side in values]
        params = {'model': self.model(model), 'formula': formula, **({'limits': limits} if limits else {})}
        self.add_next(note, 'evaluate', params, result(kind='temporal', verdict='measured', report={'values': told}))

    def value(self, note, model, along, formula, value, rules=()):
        """Of a state predicate (a truth value), or a number."""
        expect = result(kind='state', value=value) if isinstance(value, bool) or value is None \
            else result(kind='number', value=num(value))
        self.add_next(note, 'evaluate', {'model': self.model(model), 'formula': formula}, expect, along, rules)

    def outcomes(self, note, model, along, labels, ending=None, rules=(), **more):
        """All transitions of the state that the labels lead to."""
        self.add_next(note, 'successors', {'model': self.model(model), 'states': 'here'}, result(
            transitions=unordered([{'label': label} for label in labels]), ending=ending, **more), along, rules)

    def named(self, model, along, label, rule):
        """That a transition tells its rule."""
        self.add_next('The transition names its rule.', 'successors', {'model': self.model(model)}, result(
            transitions={'some': [{'label': label, 'rules': {'some': [rule]}}]}), along)

    def state(self, note, model, along, processes, rules=()):
        """Members of the processes of a state."""
        self.add_next(note, 'successors', {'model': self.model(model), 'states': 'here'},
                      result(state={'processes': unordered(processes)}), along, rules)

    def refused(self, note, model, code, rules=()):
        self.add_next(note, 'model.load', {'text': CUBE + model}, {'error': {'code': -32003, 'data': {
            'diagnostics': {'some': [{'code': code, 'severity': 'error'}]}}}}, rules=rules)


def leaf(name, **members):
    return {'leaves': {'some': [{'name': name, **members}]}}


def cubes(p='', q='', extra='', at='(4,0,0)', v='(1,0,0)', w='(0,0,0)', mass=(1, 1)):
    """A cube p from the origin, and a cube q."""
    return ('%sprocess p = Cube mass %s velocity %s [%s]\nprocess q = Cube mass %s velocity %s at translate %s [%s]\n'
            % (extra, mass[0], v, p or 'nil', mass[1], w, at, q or 'nil'))


DOCK = """behaviour Open  on Cube = <dock, {right}>. Bound
behaviour Shut  on Cube = <~dock, {left}>. Bound
behaviour Bound on Cube = nil
"""


def dock(**more):
    return cubes('Open', 'Shut', DOCK, **more)


def bonded(behaviours, p, q, extra='', bond='bond <dock, {p.right, q.left}>\n', v='(0,0,0)'):
    """Two cubes that are bound from the start."""
    return cubes(p, q, behaviours, at='(2,0,0)', v=v, w=v) + bond + extra


SHAPE_CUBE = {'vertices': [[-1, -1, -1], [1, -1, -1], [1, 1, -1], [-1, 1, -1], [-1, -1, 1], [1, -1, 1], [1, 1, 1],
                           [-1, 1, 1]],
              'faces': [[0, 3, 2, 1], [4, 5, 6, 7], [0, 4, 7, 3], [1, 2, 6, 5], [0, 1, 5, 4], [3, 7, 6, 2]],
              'names': {'vertices': list('abcdefgh'), 'faces': ['bottom', 'top', 'left', 'right', 'front', 'back']}}


def cube_of(rule):
    return rule.give('cube', {'method': 'shape.define', 'params': SHAPE_CUBE, 'handle': 'shape',
                              'release': 'shape.release'})


def faces_but(index, face):
    faces = [list(f) for f in SHAPE_CUBE['faces']]
    faces[index] = face
    return {'vertices': SHAPE_CUBE['vertices'], 'faces': faces}


def conditions(*wrong):
    return {'conditions': [{'number': i, 'holds': i not in wrong} for i in range(1, 8)]}


def face(name):
    return {'kind': 'face', 'name': name}


def edge(name):
    return {'kind': 'edge', 'name': name}


def vertex(name):
    return {'kind': 'vertex', 'name': name}


def pair(first, second, dimension):
    return {'first': first, 'second': second, 'dimension': dimension}


def all_suites():
    import rules_of_bodies
    import rules_of_chance
    import rules_of_geometry
    import rules_of_properties
    import rules_of_readings
    import rules_of_regions
    import rules_of_turning
    import rules_of_invariants
    import rules_of_zones
    return [s for m in (rules_of_geometry, rules_of_bodies, rules_of_turning, rules_of_properties, rules_of_readings,
                        rules_of_zones, rules_of_invariants, rules_of_chance, rules_of_regions)
            for s in m.suites()]
