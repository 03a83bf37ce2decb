"""Cases of the geometry: solids, mass, contact, casts and responses, each computed by geometry.py."""

from fractions import Fraction as F
import json
import os
import re

from cases import (Suite, define, feature, mat, num, nums, ordered_name, pair, result, text, unordered, vec)
from geometry import (ZERO, Solid, accepted, add, approaching, bounce, box_directions, dot, first_time_of_contact,
                      highest, mass_properties, printed_conditions, region, relation, scale, separating, sub, touching)
import solids as s


def indices(solid):
    names = list(solid.vertices)
    return [vec(v) for v in solid.vertices.values()], [[names.index(v) for v in f] for f in solid.faces.values()]


# Definition 4.3 -------------------------------------------------------------------------


def read_off(path):
    with open(path, encoding='utf-8') as f:
        words = re.sub(r'#.*', '', f.read()).split()
    assert words[0] == 'OFF'
    n, m, at = int(words[1]), int(words[2]), 4
    vertices = [tuple(F(w) for w in words[at + 3 * i:at + 3 * i + 3]) for i in range(n)]
    at, faces = at + 3 * n, []
    for _ in range(m):
        size = int(words[at])
        faces.append([int(w) for w in words[at + 1:at + 1 + size]])
        at += 1 + size
    return vertices, faces


def verdict(vertices, faces):
    """Both verdicts: that of E0 to E5, and which of the printed conditions fail."""
    points = [tuple(F(a) for a in v) for v in vertices]
    failed = printed_conditions(points, faces)
    members = {'accepted': accepted(points, faces),
               'definition_4_3': {'holds': not failed, 'conditions': [
                   {'number': i, 'holds': i not in failed} for i in range(1, 8)]}}
    return result(**members)


def spoilt(rng, solid):
    """Ways to spoil a solid, and some that leave it what it is: (what, vertices, faces)."""
    vertices, faces = indices(solid)
    middle = [text(a) for a in scale(F(1, len(vertices)), tuple(sum(c) for c in zip(*solid.points)))]
    i, far = rng.randrange(len(faces)), rng.randrange(len(vertices))

    def but(index, *new):
        return faces[:index] + list(new) + faces[index + 1:]
    yield 'rotated tuples', vertices, [f[1:] + f[:1] for f in faces]
    yield 'faces in reverse order', vertices, faces[::-1]
    yield 'without a face', vertices, but(i)
    yield 'a face reversed', vertices, but(i, faces[i][::-1])
    yield 'a face twice', vertices, faces + [faces[i][1:] + faces[i][:1]]
    yield 'all faces reversed', vertices, [f[::-1] for f in faces]
    yield 'a vertex that no face uses', vertices + [middle], faces
    yield 'a vertex pulled through the middle', [
        vec(scale(F(-1, 2), tuple(F(a) for a in v))) if j == far else v for j, v in enumerate(vertices)], faces
    yield 'a vertex twice', vertices + [vertices[far]], faces
    yield 'a face that names no vertex', vertices, but(i, faces[i][:-1] + [len(vertices) + 3])
    wide = [j for j, f in enumerate(faces) if len(f) > 3]
    if wide:
        f = faces[wide[0]]
        yield 'a face cut in two', vertices, but(wide[0], f[:3], f[2:] + f[:1])
        yield 'a face with its corners out of order', vertices, but(wide[0], [f[0], f[2], f[1]] + f[3:])
        lifted = [vec(add(tuple(F(a) for a in v), (F(1, 7), F(1, 5), F(1, 3)))) if j == f[0] else v
                  for j, v in enumerate(vertices)]
        yield 'a corner out of its plane', lifted, faces


def faults_suite(folder):
    suite = Suite('invalid/faults.json', 'What is wrong with indexed face sets that are no convex closed polyhedra.',
                  'by hand: solids/manifest.json')
    with open(os.path.join(folder, 'solids', 'manifest.json'), encoding='utf-8') as f:
        listed = json.load(f)['solids']
    for entry in listed:
        if 'unreadable' not in entry and entry['faults']:
            vertices, faces = read_off(os.path.join(folder, 'solids', entry['file']))
            suite.add(entry['file'][:-4], ['Def-4.3', 'I-2'], 'shape.check', {
                'vertices': [vec(v) for v in vertices], 'faces': faces},
                result(accepted=False, faults={'some': [{'kind': k} for k in entry['faults']]}), note=entry['note'])
    return suite


def solids_suite(folder):
    suite = Suite('geometry/solids.json', 'Is it a convex closed polyhedron? Both verdicts: E0 to E5, and the printed '
                  'conditions of Definition 4.3.')
    with open(os.path.join(folder, 'solids', 'manifest.json'), encoding='utf-8') as f:
        listed = json.load(f)['solids']
    for entry in listed:
        if 'unreadable' in entry or entry['file'] == 'drum.off':
            continue
        vertices, faces = read_off(os.path.join(folder, 'solids', entry['file']))
        expect = verdict(vertices, faces)
        wrong = [c['number'] for c in expect['result']['definition_4_3']['conditions'] if not c['holds']]
        assert expect['result']['accepted'] == entry['accepted'] and wrong == entry['paper_fails'], entry
        suite.add(entry['file'][:-4], ['Def-4.3', 'I-2', 'I-1'], 'shape.check',
                  {'vertices': [vec(v) for v in vertices], 'faces': faces}, expect, note=entry['note'])
    rng = s.seeded('solids')
    for name, solid in [*s.named().items(), ('hull-a', s.random_hull(rng)), ('hull-b', s.random_hull(rng, 9))]:
        for what, vertices, faces in spoilt(rng, solid):
            rules = ['Def-4.3', 'I-2'] + (['Def-4.1'] if what in ('rotated tuples', 'a face twice') else [])
            suite.add('%s, %s' % (name, what), rules, 'shape.check', {'vertices': vertices, 'faces': faces},
                      verdict(vertices, faces))
    return suite


# Mass -----------------------------------------------------------------------------------


def mass_suite():
    suite = Suite('geometry/mass.json', 'Volume, centroid and inertia of uniform solids.')
    rng = s.seeded('mass')
    shapes = {**s.named(), **{'hull-%d' % i: s.random_hull(rng, 5 + i % 5) for i in range(12)}}
    for name, solid in shapes.items():
        handle = suite.give(name, define(solid))
        for way, (turn, at, mass) in enumerate([(None, None, None), (rng.choice(s.QUATERNIONS), None, F(3)),
                                                (rng.choice(s.QUATERNIONS), s.some_vector(rng), F(5, 2))]):
            params, there = {'shape': handle}, solid
            if turn:
                params['turned'], there = vec(turn), s.turned(there, turn)
            if at:
                params['at'], there = vec(at), there.moved(at)
            if mass:
                params['mass'] = text(mass)
            volume, centroid, inertia = mass_properties(there)
            of_mass = [scale((mass or 1) / volume, row) for row in inertia]
            suite.add('%s-%d' % (name, way), ['Mass'], 'shape.mass', params, result(
                volume=num(volume), centroid=nums(centroid), inertia=mat(inertia), mass=num(mass or 1),
                inertia_of_mass=mat(of_mass)))
    return suite


# Contact --------------------------------------------------------------------------------


def couples(rng, suite, count):
    """Couples of shapes, some of them turned, with their handles."""
    shapes = s.named()
    shapes['hull'] = s.random_hull(rng)
    for q in s.QUATERNIONS[:4]:
        shapes['turned cube %s' % (q,)] = s.turned(s.cube(), q)
    names = list(shapes)
    for _ in range(count):
        m, n = rng.choice(names[:4] + names), rng.choice(names[:4] + names)
        yield (m, n, shapes[m], shapes[n], suite.give(m, define(shapes[m])), suite.give(n, define(shapes[n])))


def contact_members(a, b, offset, velocity=None):
    how = relation(a, b, offset)
    if how != 'touching':
        return {'relation': how, 'region': None, 'normals': None, 'pairs': None, 'highest': None,
                'approaching': None if velocity is None else False} if velocity is None else {'relation': how}
    found = touching(a, b, offset)
    f, g = highest(a, b, offset)
    members = {
        'relation': how,
        'region': unordered([nums(p) for p in sorted(region(a, b, offset))]),
        'normals': unordered([nums(n) for n in sorted(separating(a, b, offset))]),
        'pairs': unordered([pair(a, b, x, y, d) for (x, y), d in sorted(
            found.items(), key=lambda i: (ordered_name(a, i[0][0]), ordered_name(b, i[0][1])))]),
        'highest': {'first': feature(a, f), 'second': feature(b, g), 'dimension': found[f, g]}}
    assert found[f, g] == max(found.values())
    if velocity is not None:
        members['approaching'] = approaching(a, b, offset, velocity)
    return members


def contact_suite():
    suite = Suite('geometry/contact.json', 'Relations, contact regions, touching pairs of features, separating '
                  'directions, approach.')
    rng = s.seeded('contact')
    for i, (m, n, a, b, x, y) in enumerate(couples(rng, suite, 170)):
        offset, direction = s.touching_offset(rng, a, b)
        if i % 10 == 8:
            offset = add(offset, scale(F(1, 1000000007), direction))
        if i % 10 == 9:
            offset = sub(offset, scale(F(1, 1000000007), direction))
        params, velocity = {'a': x, 'b': y, 'offset': vec(offset)}, None
        if i % 2:
            velocity = s.some_vector(rng) if rng.random() < 0.5 else rng.choice(
                [ZERO, scale(-1, offset), tuple(F(a) for a in rng.choice([(0, 1, 0), (1, 0, 0), (0, 0, -1)]))])
            params['velocity'] = vec(velocity)
        members = contact_members(a, b, offset, velocity)
        rules = ['Contact']
        if members['relation'] == 'touching':
            rules += ['Touching', 'Highest', 'I-3', 'I-4'] + (['Approach'] if velocity is not None else [])
        suite.add('%d: %s and %s' % (i, m, n), rules, 'contact', params, result(**members))
    return suite


# Casts ----------------------------------------------------------------------------------


def cast_result(found):
    if isinstance(found, str):
        return result(outcome=found, time=None)
    return result(outcome='at', time=num(found))


def aimed(rng, a, b, way):
    """An offset and a velocity that bring the two into some contact, or past each other."""
    offset, direction = s.touching_offset(rng, a, b)
    velocity = s.some_vector(rng)
    if way == 'rest':
        return offset, ZERO
    if way == 'slide':
        return offset, next((v for v in [sub(velocity, scale(dot(velocity, direction) / dot(direction, direction),
                                                             direction))] if v != ZERO), (F(1), F(0), F(0)))
    if way == 'now':
        return offset, velocity
    if way == 'graze':
        velocity = sub(velocity, scale(dot(velocity, direction) / F(dot(direction, direction)), direction))
    elif dot(velocity, direction) > 0:
        velocity = scale(-1, velocity)
    if way == 'near':
        offset = add(offset, scale(F(rng.choice([-1, 1]), 10 ** 9), s.some_vector(rng)))
    if way == 'inside':
        offset = scale(F(1, 2), offset)
    return sub(offset, scale(F(rng.randint(1, 8), 2), velocity)), velocity


def cast_suite():
    suite = Suite('geometry/casts.json', 'First times of contact of two solids in translation.')
    rng = s.seeded('casts')
    ways = ['hit', 'hit', 'hit', 'graze', 'near', 'now', 'slide', 'rest', 'inside', 'hit']
    for i, (m, n, a, b, x, y) in enumerate(couples(rng, suite, 240)):
        way = ways[i % len(ways)]
        offset, velocity = aimed(rng, a, b, way)
        suite.add('%d: %s and %s, %s' % (i, m, n, way), ['Ftoc'] + (['Approach'] if way in ('now', 'slide') else []),
                  'first_time_of_contact', {'a': x, 'b': y, 'offset': vec(offset), 'velocity': vec(velocity)},
                  cast_result(first_time_of_contact(a, b, offset, velocity)))
    # Equal cubes on a grid: the least that an engine can be asked.
    x = suite.give('cube', define(s.cube()))
    for i in range(40):
        offset = tuple(F(rng.randint(-8, 8), 2) for _ in range(3))
        velocity = tuple(F(rng.choice([-2, -1, -1, 0, 0, 1, 1, 2])) for _ in range(3))
        suite.add('grid %d' % i, ['Ftoc'], 'first_time_of_contact', {
            'a': x, 'b': x, 'offset': vec(offset), 'velocity': vec(velocity)}, cast_result(
                first_time_of_contact(s.cube(), s.cube(), offset, velocity)))
    return suite


# Response -------------------------------------------------------------------------------


def body(mass, velocity):
    return {'fixed': True} if mass is None else {'mass': text(mass), 'velocity': vec(velocity)}


def some_masses(rng):
    masses = [F(rng.choice([1, 2, 3, 5]), rng.choice([1, 1, 2])) for _ in range(2)]
    if rng.random() < 0.25:
        masses[rng.randrange(2)] = None
    return masses


def response_result(happens, velocities):
    return result(outcome='bounced' if happens else 'persistent', first={'velocity': nums(velocities[0])},
                  second={'velocity': nums(velocities[1])})


def response_suite():
    suite = Suite('geometry/responses.json', 'Elastic responses of two bodies in translation.')
    rng = s.seeded('responses')
    for i, (m, n, a, b, x, y) in enumerate(couples(rng, suite, 110)):
        offset, direction = s.touching_offset(rng, a, b)
        masses = some_masses(rng)
        velocities = [ZERO if k is None else s.some_vector(rng, 2) for k in masses]
        if i % 4:
            mover = 0 if masses[1] is None else 1
            towards = scale(F(1, 2) - mover, add(offset, scale(F(1, 4), s.some_vector(rng))))
            velocities[mover] = add(velocities[1 - mover], towards)
        happens = approaching(a, b, offset, sub(velocities[1], velocities[0]))
        after = bounce(separating(a, b, offset), masses[0], velocities[0], masses[1], velocities[1]) \
            if happens else velocities
        suite.add('%d: %s and %s' % (i, m, n), ['Response'], 'response', {
            'touching': [{'a': x, 'b': y, 'offset': vec(offset)}], 'first': body(masses[0], velocities[0]),
            'second': body(masses[1], velocities[1])}, response_result(happens, after))
    return suite


def inner_corners_suite():
    """Bodies of several boxes, and reading I-13."""
    suite = Suite('geometry/inner-corners.json', 'Responses of bodies made of several boxes: inner corners do not '
                  'count (I-13).')
    rng = s.seeded('inner corners')
    sizes = [(1, 1, 1), (2, 1, 1), (1, F(1, 2), 1)]
    handles = [suite.give('box %d' % i, define(s.box(*size))) for i, size in enumerate(sizes)]

    def boxes(count):
        """Boxes side by side on a grid of halves."""
        found = []
        while len(found) < count:
            i, at = rng.randrange(3), tuple(F(rng.randint(-3, 3)) for _ in range(2)) + (F(rng.randint(0, 1)),)
            if all(any(abs(at[k] - p[k]) >= sizes[i][k] + sizes[j][k] for k in range(3)) for j, p in found):
                found.append((i, at))
        return found
    made = 0
    while made < 70:
        one, other = boxes(rng.choice([2, 3, 4])), boxes(rng.choice([1, 1, 2]))
        base, hit = rng.choice(one), rng.choice(other)
        axis = rng.randrange(3)
        at = [F(rng.randint(-3, 3), 2) for _ in range(3)]
        at[axis] = rng.choice([-1, 1]) * F(sizes[base[0]][axis] + sizes[hit[0]][axis])
        at = add(sub(base[1], hit[1]), at)
        pairs = []
        for i, p in one:
            for j, q in other:
                half = tuple(F(c + d) for c, d in zip(sizes[i], sizes[j]))
                pairs.append((i, j, scale(-1, half), half, sub(add(q, at), p)))
        if any(all(low[k] < o[k] < high[k] for k in range(3)) for _, _, low, high, o in pairs):
            continue
        pairs = [p for p in pairs if all(p[2][k] <= p[4][k] <= p[3][k] for k in range(3))]
        masses = some_masses(rng)
        velocities = [ZERO if m is None else s.some_vector(rng, 2) for m in masses]
        w = sub(velocities[1], velocities[0])
        cone = box_directions([p[2:] for p in pairs], w)
        if len(pairs) < 2 or (not cone and made % 7):
            continue
        after = bounce(cone, masses[0], velocities[0], masses[1], velocities[1]) if cone else velocities
        suite.add('%d' % made, ['Response', 'I-13'], 'response', {
            'touching': [{'a': handles[i], 'b': handles[j], 'offset': vec(o)} for i, j, _, _, o in pairs],
            'first': body(masses[0], velocities[0]), 'second': body(masses[1], velocities[1])},
            response_result(bool(cone), after))
        made += 1
    return suite


def all_suites(folder):
    return [solids_suite(folder), faults_suite(folder), mass_suite(), contact_suite(), cast_suite(), response_suite(),
            inner_corners_suite()]
