#!/usr/bin/env python3
"""A second implementation of the geometry methods of the oracle: geometry.py, turning.py and near.py behind the
protocol. Slow and exact. It answers -32601 to what it does not do."""

from fractions import Fraction as F
import json
import sys

from geometry import (Solid, ZERO, accepted, add, approaching, bounce, box_directions, cross, dot, first_time_of_contact,
                      highest, mass_properties, primitive, printed_conditions, region, relation, scale, separating, sub,
                      touching)
from near import Unknown, near
from turning import (Body, Mass, Undecided, apply, cast, cayley, grid_of, impact, rotation, speed_bound,
                     turn_phase)

NOT_DONE, BAD_PARAMS, NO_HANDLE, NO_SHAPE = -32601, -32602, -32001, -32002
NOT_IN_CONTACT = -32008


class Fault(Exception):
    def __init__(self, code, **data):
        super().__init__(code)
        self.code, self.data = code, data


def number(x):
    return F(x) if not isinstance(x, float) else F(repr(x))


def vector(v):
    return tuple(number(a) for a in v)


def out(q):
    q = F(q)
    return '%d/%d' % (q.numerator, q.denominator)


def both(q):
    return {'exact': out(q), 'float': float(q)}


def outs(v):
    return [out(a) for a in v]


def feature(solid, f):
    names = list(solid.vertices)
    at = sorted(names.index(v) for v in f)
    if len(f) == 1:
        return {'kind': 'vertex', 'name': names[at[0]], 'vertices': at}
    if len(f) == 2:
        return {'kind': 'edge', 'name': '[%s,%s]' % (names[at[0]], names[at[1]]), 'vertices': at}
    face = solid.names[f]
    return {'kind': 'face', 'name': face, 'vertices': [names.index(v) for v in solid.faces[face]]}


def read(params):
    """Points, and faces as indices; with names."""
    points = [vector(v) for v in params['vertices']]
    names = params.get('names', {})
    vertices = names.get('vertices', ['v%d' % i for i in range(len(points))])
    faces = [[vertices.index(v) if isinstance(v, str) else v for v in f] for f in params['faces']]
    return points, faces, vertices, names.get('faces', ['f%d' % i for i in range(len(faces))])


class Second:
    def __init__(self):
        self.shapes = {}

    def shape(self, params, name, turned=None):
        if params[name] not in self.shapes:
            raise Fault(NO_HANDLE, handle=params[name])
        solid = self.shapes[params[name]]
        if turned and turned in params:
            matrix = rotation(vector(params[turned]))
            return solid.image(lambda v: apply(matrix, v))
        return solid

    def shape_define(self, params):
        points, faces, vertices, names = read(params)
        if not accepted(points, faces):
            raise Fault(NO_SHAPE, faults=[])
        solid = Solid(dict(zip(vertices, points)), {n: tuple(vertices[v] for v in f) for n, f in zip(names, faces)})
        matrix = None
        if 'linear' in params:
            matrix = [vector(r) for r in params['linear']]
            if dot(matrix[0], cross(matrix[1], matrix[2])) <= 0:
                raise Fault(NO_SHAPE, faults=[{'kind': 'bad-transformation', 'code': 'SC0311'}])
        if 'quaternion' in params:
            matrix = rotation(vector(params['quaternion']))
        if matrix:
            solid = solid.image(lambda v: apply(matrix, v))
        handle = 's%d' % (len(self.shapes) + 1)
        self.shapes[handle] = solid
        volume, centroid, _ = mass_properties(solid)
        return {'shape': handle, 'vertices': len(points), 'edges': len(solid.edges), 'faces': len(faces),
                'volume': out(volume), 'centroid': outs(centroid), 'warnings': []}

    def shape_release(self, params):
        self.shape(params, 'shape')
        self.shapes[params['shape']] = None
        return {'released': params['shape']}

    def shape_check(self, params):
        points, faces, _, _ = read(params)
        failed = printed_conditions(points, faces)
        return {'accepted': accepted(points, faces), 'definition_4_3': {
            'holds': not failed, 'conditions': [{'number': i, 'holds': i not in failed} for i in range(1, 8)]}}

    def shape_mass(self, params):
        solid = self.shape(params, 'shape', 'turned').moved(vector(params.get('at', ZERO)))
        volume, centroid, inertia = mass_properties(solid)
        mass = number(params.get('mass', 1))
        return {'volume': out(volume), 'centroid': outs(centroid), 'inertia': [outs(r) for r in inertia],
                'mass': out(mass), 'inertia_of_mass': [outs(scale(mass / volume, r)) for r in inertia]}

    def contact(self, params):
        a, b = self.shape(params, 'a', 'turned_a'), self.shape(params, 'b', 'turned_b')
        offset = vector(params['offset'])
        answer = dict.fromkeys(('region', 'normals', 'pairs', 'highest', 'approaching'))
        answer['relation'] = relation(a, b, offset)
        pairs = None
        if answer['relation'] == 'touching':
            pairs, corners, best = touching(a, b, offset), region(a, b, offset), highest(a, b, offset)
            answer['normals'] = [outs(n) for n in separating(a, b, offset)]
        if 'resolution' in params:
            answer['gap'] = outs(ZERO) if pairs else None
            found = None
            if answer['relation'] == 'apart':
                try:
                    found = near(a, b, offset, number(params['resolution']))
                except Unknown:
                    raise Fault(NOT_DONE) from None
            if found:
                gap, (normal, height), corners, pairs, best = found
                answer.update(relation='near', gap=outs(gap), plane={'normal': outs(normal), 'height': out(height)})
        if pairs:
            answer['region'] = [outs(p) for p in corners]
            answer['pairs'] = [{'first': feature(a, f), 'second': feature(b, g), 'dimension': d}
                               for (f, g), d in pairs.items()]
            answer['highest'] = {'first': feature(a, best[0]), 'second': feature(b, best[1]), 'dimension': pairs[best]}
        if 'velocity' in params and pairs:
            answer['approaching'] = approaching(a, b, offset, vector(params['velocity']))
        return answer

    def first_time_of_contact(self, params):
        a, b = self.shape(params, 'a', 'turned_a'), self.shape(params, 'b', 'turned_b')
        offset, velocity = vector(params['offset']), vector(params['velocity'])
        if not {'span', 'until'} & set(params):
            return self.outcome(first_time_of_contact(a, b, offset, velocity))
        if {'arm_a', 'arm_b'} & set(params):
            raise Fault(NOT_DONE)
        one = self.turning_body(a, ZERO, params, 'a')
        other = self.turning_body(b, velocity, params, 'b')
        other = Body(other.solid.moved(offset), velocity, other.spin, None, other.since)
        grid = params['grid'] if 'grid' in params else grid_of(speed_bound(one, other), number(params['resolution']))
        phase = params.get('phase', 0)
        phase = turn_phase(one, other) if phase == 'turn' else number(phase)
        cell = F(1, 2 ** grid)
        span = number(params['span']) if 'span' in params else ((number(params['until']) + phase) // cell + 1) * cell - phase
        try:
            return {**self.outcome(cast(one, other, span, grid, phase=phase)), 'grid': grid}
        except Undecided:
            raise Fault(NOT_DONE) from None

    @staticmethod
    def turning_body(solid, velocity, params, side):
        """As it is now: it has turned about its reference point, and went where that is."""
        spin, since = vector(params.get('spin_' + side, ZERO)), number(params.get('since_' + side, 0))
        turn = cayley(scale(since / 2, spin))
        return Body(solid.image(lambda p: apply(turn, p)), velocity, spin, None, since)

    @staticmethod
    def outcome(found):
        if isinstance(found, str):
            return {'outcome': found, 'time': None}
        return {'outcome': 'at', 'time': both(found)}

    def response(self, params):
        pairs = [(self.shape(p, 'a'), self.shape(p, 'b'), vector(p['offset']), vector(p.get('at', ZERO)))
                 for p in params['touching']]
        for i, (a, b, offset, _) in enumerate(pairs):
            how = relation(a, b, offset)
            if how != 'touching':
                raise Fault(NOT_IN_CONTACT, at=i, relation=how)
        return self.turning(params, pairs) if 'resolution' in params else self.straight(params, pairs)

    def straight(self, params, pairs):
        bodies = [params['first'], params['second']]
        masses = [None if b.get('fixed') else number(b['mass']) for b in bodies]
        velocities = [vector(b.get('velocity', ZERO)) for b in bodies]
        w = sub(velocities[1], velocities[0])
        if len(pairs) == 1:
            a, b, offset, _ = pairs[0]
            cone = separating(a, b, offset) if approaching(a, b, offset, w) else set()
        else:
            cone = box_directions([self.box(a, b) + (offset,) for a, b, offset, _ in pairs], w)
        after = bounce(cone, masses[0], velocities[0], masses[1], velocities[1]) if cone else velocities
        return {'outcome': 'bounced' if cone else 'persistent', 'first': {'velocity': outs(after[0])},
                'second': {'velocity': outs(after[1])}}

    @staticmethod
    def box(a, b):
        for solid in (a, b):
            if any(sum(map(abs, n)) != 1 for n in solid.face_normals()):
                raise Fault(NOT_DONE)
        axes = [tuple(int(i == j) for j in range(3)) for i in range(3)]
        return (tuple(min(dot(n, p) for p in a.points) - max(dot(n, q) for q in b.points) for n in axes),
                tuple(max(dot(n, p) for p in a.points) - min(dot(n, q) for q in b.points) for n in axes))

    @staticmethod
    def turning(params, pairs):
        if len(pairs) > 1 or any(t in params['touching'][0] for t in ('turned_a', 'turned_b')):
            raise Fault(NOT_DONE)
        a, b, offset, at = pairs[0]
        masses, motions = [], []
        for body in (params['first'], params['second']):
            if body.get('fixed'):
                masses.append(Mass(None, None, ZERO))
                motions.append((ZERO, ZERO))
            else:
                masses.append(Mass(number(body['mass']), [vector(r) for r in body['inertia']], vector(body['centre'])))
                motions.append((vector(body['velocity']), vector(body['spin'])))
        normals = [tuple(F(k) for k in n) for n in separating(a, b, offset)]
        corners = [add(at, x) for x in region(a, b, offset)]

        def speed(n, x):
            points = [add(v, cross(w, sub(x, m.centre))) for (v, w), m in zip(motions, masses)]
            return dot(n, sub(points[1], points[0]))
        happens = any(all(speed(n, x) < 0 for n in normals) for x in corners)
        after = impact(masses[0], motions[0], masses[1], motions[1], [(n, x) for n in normals for x in corners]) \
            if happens else motions
        bodies = [{'velocity': outs(v), 'spin': outs(w)} for v, w in after]
        return {'outcome': 'bounced' if happens else 'persistent', 'first': bodies[0], 'second': bodies[1]}

    def answer(self, request):
        method = getattr(self, request['method'].replace('.', '_'), None)
        if request['method'] not in METHODS or method is None:
            return {'error': {'code': NOT_DONE, 'message': 'not done', 'data': {}}}
        try:
            return {'result': method(request['params'])}
        except Fault as fault:
            return {'error': {'code': fault.code, 'message': 'fault', 'data': fault.data}}


METHODS = ('shape.define', 'shape.release', 'shape.check', 'shape.mass', 'contact', 'first_time_of_contact', 'response')


def main():
    second = Second()
    for line in sys.stdin:
        request = json.loads(line)
        print(json.dumps({'jsonrpc': '2.0', 'id': request['id'], **second.answer(request)}), flush=True)


if __name__ == '__main__':
    main()
