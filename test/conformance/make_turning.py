"""Cases of bodies that turn: casts, responses, contact within resolution; computed by turning.py and geometry.py."""

from fractions import Fraction as F

from cases import TURNING, Suite, define, feature, mat, num, nums, pair, result, text, unordered, vec
from geometry import ZERO, add, cross, dot, highest, mass_properties, region, relation, scale, separating, sub, touching
from make_geometry import cast_result
from near import Unknown, near
from turning import Body, Undecided, apply, cast, cayley, grid_of, impact, mass_of, speed_bound, turn_phase
import solids as s


def small(rng, size=2):
    return tuple(F(rng.randint(-4 * size, 4 * size), 8) for _ in range(3))


def cast_suite():
    suite = Suite('geometry/rigid-casts.json', 'First times of contact of two solids that move and turn, rounded down '
                  'to the grid.', TURNING)
    rng = s.seeded('rigid casts')
    shapes = {k: v for k, v in s.named().items() if k in ('cube', 'plank', 'tetrahedron', 'octahedron', 'pyramid')}
    names = sorted(shapes)
    made = 0
    while made < 60:
        m, n = rng.choice(names), rng.choice(names)
        qa, qb = rng.choice([None, rng.choice(s.QUATERNIONS)]), rng.choice([None, rng.choice(s.QUATERNIONS)])
        a, b = (s.turned(x, q) if q else x for x, q in ((shapes[m], qa), (shapes[n], qb)))
        offset = scale(F(rng.randint(5, 8), 2), rng.choice([(1, 0, 0), (0, 1, 0), (0, 0, -1), (-1, 1, 0), (0, 1, 1)]))
        velocity = add(scale(F(-1, 2), offset), small(rng, 1)) if made % 4 else small(rng)
        spins = [ZERO if made % 5 == i else scale(F(1, 2), small(rng, 1)) for i in range(2)]
        one = Body(a, ZERO, spins[0])
        other = Body(b.moved(offset), velocity, spins[1])
        span = F(rng.choice([1, 2, 3]))
        resolution = F(1, rng.choice([64, 1024, 1 << 20]))
        bound = speed_bound(one, other)
        grid = grid_of(bound, resolution)
        # How square roots are rounded is left open: it must not matter.
        if grid != grid_of(bound * F(101, 100), resolution):
            continue
        try:
            found = cast(one, other, span, grid)
        except Undecided:
            continue
        if found == 'inside' and made % 20:
            continue
        params = {'a': suite.give(m, define(shapes[m])), 'b': suite.give(n, define(shapes[n])), 'offset': vec(offset),
                  'velocity': vec(velocity), 'span': text(span)}
        params.update({'spin_' + k: vec(w) for k, w in zip('ab', spins) if w != ZERO})
        params.update({'turned_' + k: vec(q) for k, q in zip('ab', (qa, qb)) if q})
        if made % 2:
            params['grid'] = grid
        else:
            params['resolution'] = text(resolution)
        expect = cast_result(found)
        expect['result']['grid'] = grid
        suite.add('%d: %s and %s' % (made, m, n), ['Cast', 'Turn', 'I-21'], 'first_time_of_contact', params, expect)
        made += 1
    in_mid_turn(suite, shapes)
    return suite


def in_mid_turn(suite, shapes):
    """Asked when turns have begun already: the grid counts from now, from the last of their beginnings, or from any time."""
    rng = s.seeded('rigid casts in mid-turn')
    names, made = sorted(shapes), 0
    while made < 30:
        m, n = rng.choice(names), rng.choice(names)
        spins = [ZERO if made % 5 == i else scale(F(1, 2), small(rng, 1)) for i in range(2)]
        since = [F(rng.randint(0, 20), rng.choice([16, 24, 100])) for _ in range(2)]
        turns = [cayley(scale(t / 2, w)) for t, w in zip(since, spins)]
        a, b = (shapes[x].image(lambda p, turn=turn: apply(turn, p)) for x, turn in zip((m, n), turns))
        offset = scale(F(rng.randint(5, 8), 2), rng.choice([(1, 0, 0), (0, 1, 0), (0, 0, -1), (-1, 1, 0), (0, 1, 1)]))
        velocity = add(scale(F(-1, 2), offset), small(rng, 1))
        one, other = Body(a, ZERO, spins[0], None, since[0]), Body(b.moved(offset), velocity, spins[1], None, since[1])
        grid = rng.choice([2, 4, 7])
        given = rng.choice([None, 'turn', 'turn', F(rng.randint(0, 40), 64)])
        phase = turn_phase(one, other) if given == 'turn' else given or F(0)
        span = F(rng.choice([1, 2]))
        upto = made % 3 == 2
        if upto:
            cell = F(1, 2 ** grid)
            until, span = span, ((span + phase) // cell + 1) * cell - phase
        try:
            found = cast(one, other, span, grid, phase=phase)
        except Undecided:
            continue
        if isinstance(found, str) and made % 6:
            continue
        params = {'a': suite.give(m, define(shapes[m])), 'b': suite.give(n, define(shapes[n])), 'offset': vec(offset),
                  'velocity': vec(velocity), 'grid': grid}
        params.update({'until': text(until)} if upto else {'span': text(span)})
        params.update({'spin_' + k: vec(w) for k, w in zip('ab', spins) if w != ZERO})
        params.update({'since_' + k: text(t) for k, t in zip('ab', since)})
        if given is not None:
            params['phase'] = given if given == 'turn' else text(given)
        expect = cast_result(found)
        expect['result']['grid'] = grid
        suite.add('in mid-turn %d: %s and %s' % (made, m, n), ['Cast', 'Turn', 'I-21'], 'first_time_of_contact', params,
                  expect)
        made += 1


def moving(mass, motion):
    if mass.mass is None:
        return {'fixed': True}
    return {'mass': text(mass.mass), 'centre': vec(mass.centre), 'inertia': [vec(r) for r in mass.inertia],
            'velocity': vec(motion[0]), 'spin': vec(motion[1])}


def approaches(rows, normals, corners, speed):
    """At some corner, against each of the normals."""
    return any(all(speed(n, x) < 0 for n in normals) for x in corners)


def response_suite():
    suite = Suite('geometry/rigid-responses.json', 'Elastic responses of two rigid bodies that touch.', TURNING)
    rng = s.seeded('rigid responses')
    shapes = {k: v for k, v in s.named().items() if k in ('cube', 'plank', 'tetrahedron', 'octahedron', 'wedge')}
    names = sorted(shapes)
    made, still = 0, 0
    while made < 60:
        m, n = rng.choice(names), rng.choice(names)
        a, b = shapes[m], shapes[n]
        offset, _ = s.touching_offset(rng, a, b)
        at = rng.choice([ZERO, s.some_vector(rng)])
        normals, corners = separating(a, b, offset), region(a, b, offset)
        if len(normals) * len(corners) > 8:
            continue
        masses = [mass_of(a.moved(at), F(rng.choice([1, 2, 3]))), mass_of(b.moved(add(at, offset)), F(1))]
        motions = [(small(rng), small(rng, 1)), (small(rng), small(rng, 1))]
        if made % 6 == 5:
            masses[1], motions[1] = mass_of(b.moved(add(at, offset)), None), (ZERO, ZERO)
        corners = [add(at, x) for x in sorted(corners)]
        rows = [(tuple(F(k) for k in direction), x) for direction in sorted(normals) for x in corners]

        def speed(direction, x):
            points = [add(v, cross(w, sub(x, k.centre))) for (v, w), k in zip(motions, masses)]
            return dot(direction, sub(points[1], points[0]))
        happens = approaches(rows, sorted(normals), corners, speed)
        if not happens:
            still += 1
            if still % 6:
                continue
        after = impact(masses[0], motions[0], masses[1], motions[1], rows) if happens else motions
        members = [{'velocity': nums(v), 'spin': nums(w)} for v, w in after]
        suite.add('%d: %s and %s' % (made, m, n), ['Impact', 'Bounce'] if happens else ['Impact', 'Persistent'],
                  'response', {
                      'touching': [{'a': suite.give(m, define(a)), 'b': suite.give(n, define(b)),
                                    'offset': vec(offset), 'at': vec(at)}],
                      'first': moving(masses[0], motions[0]), 'second': moving(masses[1], motions[1]),
                      'resolution': '1/1048576'},
                  result(outcome='bounced' if happens else 'persistent', first=members[0], second=members[1]))
        made += 1
    return suite


def near_members(a, b, offset, resolution):
    """What is expected of a contact within resolution of two solids that do not interpenetrate."""
    if relation(a, b, offset) == 'touching':
        f, g = highest(a, b, offset)
        found, corners, gap, plane = touching(a, b, offset), region(a, b, offset), ZERO, None
        how = 'touching'
    else:
        found = near(a, b, offset, resolution)
        if found is None:
            return {'relation': 'apart', 'gap': None, 'region': None, 'pairs': None, 'highest': None}
        gap, plane, corners, found, (f, g) = found
        how = 'near'
    members = {'relation': how, 'gap': nums(gap), 'region': unordered([nums(p) for p in sorted(corners)]),
               'pairs': unordered([pair(a, b, x, y, d) for (x, y), d in found.items()]),
               'highest': {'first': feature(a, f), 'second': feature(b, g), 'dimension': found[f, g]}}
    if plane:
        members['plane'] = {'normal': nums(plane[0]), 'height': num(plane[1])}
    return members


def near_suite():
    suite = Suite('geometry/near.json', 'Contact within resolution: two solids a little apart are seen as if they '
                  'touched.', TURNING.replace('turning.py', 'near.py'))
    rng = s.seeded('near')
    shapes = {k: v for k, v in s.named().items() if k in ('cube', 'plank', 'tetrahedron', 'octahedron', 'wedge')}
    names = sorted(shapes)
    made = 0
    while made < 70:
        m, n = rng.choice(names), rng.choice(names)
        resolution = F(1, rng.choice([8, 64, 1024]))
        turns = [rng.choice([None, None, (rng.choice([8, 50, 1000, 5000]), *rng.choice([(1, 0, 0), (0, 1, 0), (1, -1, 2)])),
                             rng.choice(s.QUATERNIONS)]) for _ in range(2)]
        a, b = (s.turned(shapes[k], q) if q else shapes[k] for k, q in zip((m, n), turns))
        offset, direction = s.touching_offset(rng, a, b)
        step = rng.choice([0, 1, 2, 2, 3, 4, 7, 12]) * resolution / 8 / max(map(abs, direction))
        offset = add(offset, scale(step, direction))
        if relation(a, b, offset) == 'interpenetrating':
            continue
        try:
            members = near_members(a, b, offset, resolution)
        except Unknown:
            continue
        params = {'a': suite.give(m, define(shapes[m])), 'b': suite.give(n, define(shapes[n])), 'offset': vec(offset),
                  'resolution': text(resolution)}
        params.update({'turned_' + k: vec(q) for k, q in zip('ab', turns) if q})
        suite.add('%d: %s and %s' % (made, m, n), ['Near', 'I-22'], 'contact', params, result(**members))
        made += 1
    return suite


def all_suites():
    return [cast_suite(), response_suite(), near_suite()]
