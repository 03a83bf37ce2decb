"""How cases are written down: numbers, features, suites, the manifest."""

from fractions import Fraction as F
import json
import os
import re

from geometry import name_of

VERSION = 1
NAIVE = 'computed by test/conformance/geometry.py from the definitions, by brute force; scc agrees'
TURNING = 'computed by test/conformance/turning.py from the definitions, by brute force; scc agrees'
HAND = 'by hand'


def text(q):
    """A number as it stands in params."""
    q = F(q)
    return q.numerator if q.denominator == 1 else '%d/%d' % (q.numerator, q.denominator)


def num(q):
    """A number as it is expected."""
    q = F(q)
    return {'exact': '%d/%d' % (q.numerator, q.denominator), 'float': float(q)}


def vec(v):
    return [text(a) for a in v]


def nums(v):
    return [num(a) for a in v]


def mat(m):
    return [nums(row) for row in m]


def unordered(items):
    return {'set': items}


def result(**members):
    return {'result': members}


def kind_of(feature):
    return ('vertex', 'edge', 'face')[min(len(feature), 3) - 1]


def ordered_name(solid, feature):
    """As the language names it: an edge by its vertices in the order of the shape."""
    if len(feature) == 2:
        order = list(solid.vertices)
        return '[%s]' % ','.join(sorted(feature, key=order.index))
    return name_of(solid, feature)


def feature(solid, f):
    return {'kind': kind_of(f), 'name': ordered_name(solid, f)}


def pair(a, b, f, g, dimension):
    return {'first': feature(a, f), 'second': feature(b, g), 'dimension': dimension}


def define(solid, linear=None, quaternion=None):
    params = {'vertices': [vec(v) for v in solid.vertices.values()],
              'faces': [list(f) for f in solid.faces.values()],
              'names': {'vertices': list(solid.vertices), 'faces': list(solid.faces)}}
    if linear:
        params['linear'] = [vec(r) for r in linear]
    if quaternion:
        params['quaternion'] = vec(quaternion)
    return {'method': 'shape.define', 'params': params, 'handle': 'shape', 'release': 'shape.release'}


def files_of(folder, model, within=''):
    """The files that a model names, and those that these name: by their paths from the model; those that are there."""
    found = {}
    for name in re.findall(r'(?:mesh|decompose|import)\s+(?:file=)?"([^"]*)"', model):
        path = os.path.normpath(os.path.join(within, name)).replace(os.sep, '/')
        if os.path.exists(os.path.join(folder, path)):
            with open(os.path.join(folder, path), encoding='utf-8') as f:
                found[path] = f.read()
            if path.endswith(('.sc', '.xml')):
                found.update(files_of(folder, found[path], os.path.dirname(path)))
    return found


def load(model, **more):
    return {'method': 'model.load', 'params': {'text': model, **more}, 'handle': 'model', 'release': 'model.release'}


class Suite:
    """One file of cases that share what is given."""

    def __init__(self, file, about, obtained=NAIVE):
        self.file, self.about, self.obtained = file, about, obtained
        self.given, self.cases = {}, []

    def give(self, name, thing):
        self.given[name] = thing
        return '@' + name

    def add(self, name, rules, method, params, expect, obtained=None, note=None, along=None):
        case = {'id': '%s/%s' % (self.file[:-len('.json')], name), 'rules': rules, 'method': method}
        if note:
            case['note'] = note
        case['params'] = params
        if along is not None:
            case['along'] = along
        case['expect'] = expect
        case['obtained'] = obtained or self.obtained
        self.cases.append(case)

    def write(self, folder):
        """One case or thing given a line, so that differences can be read."""
        path = os.path.join(folder, self.file)
        os.makedirs(os.path.dirname(path), exist_ok=True)
        ids = [c['id'] for c in self.cases]
        assert len(set(ids)) == len(ids), [i for i in ids if ids.count(i) > 1]
        head = json.dumps({'format': 'scc-conformance-cases', 'version': VERSION, 'about': self.about})[:-1]
        lines = [head + ', "given": {']
        lines.append(',\n'.join('%s: %s' % (json.dumps(n), json.dumps(g)) for n, g in self.given.items()))
        lines.append('}, "cases": [')
        lines.append(',\n'.join(json.dumps(c) for c in self.cases))
        lines.append(']}')
        with open(path, 'w', encoding='utf-8') as f:
            f.write('\n'.join(line for line in lines if line) + '\n')


def write_manifest(folder, suites, semantics, ids, codes, commands):
    """Where the cases of each rule, reading and diagnostic are. `codes`: code -> ids of cases, `commands`: inputs that
    only a command line can be given; `semantics`: the version of the rule book."""
    rules = {i: {'cases': 0, 'files': []} for i in ids}
    for s in suites:
        for case in s.cases:
            for rule in case['rules']:
                rules[rule]['cases'] += 1
                if s.file not in rules[rule]['files']:
                    rules[rule]['files'].append(s.file)
    manifest = {'format': 'scc-conformance', 'version': VERSION, 'protocol': 1, 'semantics': semantics,
                'cases': sum(len(s.cases) for s in suites),
                'suites': [{'file': s.file, 'about': s.about, 'cases': len(s.cases)} for s in suites],
                'rules': rules, 'diagnostics': codes, 'commands': commands, 'solids': 'solids/manifest.json'}
    with open(os.path.join(folder, 'manifest.json'), 'w', encoding='utf-8') as f:
        json.dump(manifest, f, indent=1)
        f.write('\n')
