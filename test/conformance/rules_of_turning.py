"""By hand: bodies that turn (section 4 of the rule book)."""

from make_rules import BIND, BOUNCE, SHAPE_CUBE, TIME, Rule, cube_of, cubes, face, leaf, pair, passes
from cases import num, nums, result, unordered

RIGID = 'dynamics constant_spin\n'
SPINNING = RIGID + 'process p = Cube mass 1 spin %s [eps(10). nil]\n'


OWN = SPINNING % '(0,0,1)' + 'process q = Cube mass 1 spin (0,0,4) at translate (40,0,0) [nil]\n'


def turn():
    r = Rule('Turn')
    r.outcomes('|w| d / 2 is at most 1/4: turns of 1/4 for a spin of 2.', SPINNING % '(0,0,2)', [], [passes('1/4')])
    r.outcomes('Turns of 1/2 for one of 1.', SPINNING % '(0,0,1)', [], [passes('1/2')])
    r.outcomes('Turns of 1 for one of 1/2.', SPINNING % '(0,1/2,0)', [], [passes(1)])
    r.state('After a turn it has turned by twice the arc whose tangent is 1/4.', SPINNING % '(0,0,2)', [TIME],
            [leaf('p', turned=['4', '0', '0', '1'])])
    r.state('After two: the quaternion squared, 16 - 1 + 8 k.', SPINNING % '(0,0,2)', [TIME, TIME],
            [leaf('p', turned=['15', '0', '0', '8'])])
    r.value('It spins on.', SPINNING % '(0,0,2)', [TIME, TIME], 'wz(p)', 2)
    r.state('A turn of 1/2 goes on where another one, of 1/8, ends.', OWN, [TIME], [
        {'since': num('1/8'), 'lasts': num('1/2'), **leaf('p', turned=['16', '0', '0', '1'])},
        {'since': num(0), 'lasts': num('1/8'), **leaf('q')}])
    r.state('And then it has turned by as much as in one go: 2 atan(1/4).', OWN, [TIME] * 4, [
        {'since': num(0), 'lasts': num('1/2'), **leaf('p', turned=['4', '0', '0', '1'])},
        {'since': num(0), 'lasts': num('1/8'), **leaf('q')}])
    r.verdict('The spin stays, and so does the energy: 2/3 * 4 / 2.', SPINNING % '(0,0,2)',
              'always (wz(p) = 2 and energy = 4/3) within 2', 'holds')
    r.verdict('Angular momentum is kept, that of a cube along its spin.', SPINNING % '(1/2,1/3,0)',
              'always (angular.x = 1/3 and angular.y = 2/9) within 2', 'holds')
    return r


ABOUT_X = (RIGID + 'resolution 1/2\nprocess p = Cube mass 1 velocity (3,0,0) spin (1/2,0,0) [nil]\n'
           'process q = Cube mass 1 at translate (4,0,0) [%s]\n')


def cast():
    r = Rule('Cast')
    cube = cube_of(r)

    def at(why, offset, velocity, span, grid, outcome, time=None, **more):
        r.add_next(why, 'first_time_of_contact', {'a': cube, 'b': cube, 'offset': offset, 'velocity': velocity,
                                                  'span': span, 'grid': grid, **more},
                   result(outcome=outcome, time=None if time is None else num(time), grid=grid))
    at('Without spin at 2/3: rounded down to 682/1024.', [4, 0, 0], [-3, 0, 0], 1, 10, 'at', '682/1024')
    at('To a grid of whole numbers: 0.', [4, 0, 0], [-3, 0, 0], 1, 0, 'at', 0)
    at('On the grid: as it is.', [4, 0, 0], [-4, 0, 0], 1, 1, 'at', '1/2')
    at('Beyond the span.', [4, 0, 0], [-3, 0, 0], '1/2', 10, 'never')
    at('A span that ends just there: the interiors meet afterwards.', [4, 0, 0], [-4, 0, 0], '1/2', 10, 'never')
    at('A spin about the line of flight does not matter, between faces.', [4, 0, 0], [-3, 0, 0], 1, 10, 'at', '682/1024',
       spin_b=[1, 0, 0])
    at('They turn where they are: the corners go round in a circle of radius sqrt 2, and 2 sqrt 2 is less than 3.',
       [3, 0, 0], [0, 0, 0], 100, 10, 'never', spin_a=[0, 0, '1/3'], spin_b=[0, 0, '1/2'])
    at('One in the other.', [1, 0, 0], [0, 0, 0], 1, 10, 'inside', spin_b=[0, 0, 1])
    at('Both turned by a right angle: as they were.', [4, 0, 0], [-3, 0, 0], 1, 10, 'at', '682/1024',
       turned_a=[1, 0, 0, 1], turned_b=[1, 1, 0, 0])
    r.outcomes('In a rigid model, where neither spins: exactly at 2/3.', RIGID + cubes(v='(3,0,0)'), [], [passes('2/3')])
    # S is at least 3 + 1/2 sqrt 3, and less than 4: K = 3
    r.outcomes('Where one does, at 5/8: with 4 times 1/8 at most 1/2.', ABOUT_X % 'nil', [], [passes('5/8')])
    r.outcomes('Time stops at 3/5 for another reason.', ABOUT_X % 'eps(3/5). nil', [], [passes('3/5')])
    r.outcomes('And then at 5/8 all the same.', ABOUT_X % 'eps(3/5). nil', [TIME], [passes('1/40')])
    return r


def near():
    r = Rule('Near')
    cube = cube_of(r)
    faces = pair(face('right'), face('left'), 2)
    r.add_next('A gap of half the resolution.', 'contact', {'a': cube, 'b': cube, 'offset': ['5/2', 0, 0],
                                                            'resolution': 1}, result(
        relation='near', gap=nums(('1/2', 0, 0)), highest=faces, plane={'normal': nums((1, 0, 0)), 'height': num('5/4')},
        region=unordered([nums(('5/4', y, z)) for y in (-1, 1) for z in (-1, 1)])))
    r.add_next('Exactly the resolution.', 'contact', {'a': cube, 'b': cube, 'offset': [3, 0, 0], 'resolution': 1},
               result(relation='near', highest=faces))
    r.add_next('More.', 'contact', {'a': cube, 'b': cube, 'offset': ['3.000001', 0, 0], 'resolution': 1},
               result(relation='apart', gap=None))
    r.add_next('None.', 'contact', {'a': cube, 'b': cube, 'offset': [2, 0, 0], 'resolution': 1},
               result(relation='touching', highest=faces, gap=nums((0, 0, 0))))
    r.add_next('Less than none.', 'contact', {'a': cube, 'b': cube, 'offset': [1, 0, 0], 'resolution': 1},
               result(relation='interpenetrating', gap=None))
    r.add_next('A tilted cube, whose corners all lie within the resolution of the plane: faces all the same.', 'contact',
               {'a': cube, 'b': cube, 'offset': ['201/100', 0, 0], 'resolution': '1/8', 'turned_b': [1000, 0, 0, 1]},
               result(relation='near', highest={'first': face('right'), 'second': face('left')}))
    return r


THIRDS = [['2/3', 0, 0], [0, '2/3', 0], [0, 0, '2/3']]


def rigid_body(centre, velocity, spin=(0, 0, 0), inertia=None, mass=1):
    return {'mass': mass, 'centre': centre, 'inertia': inertia or THIRDS, 'velocity': velocity, 'spin': list(spin)}


def impact():
    r = Rule('Impact')
    cube = cube_of(r)

    def bounce(why, offset, first, second, after, outcome='bounced'):
        r.add_next(why, 'response', {'touching': [{'a': cube, 'b': cube, 'offset': offset, 'at': [0, 0, 0]}],
                                     'first': first, 'second': second, 'resolution': '1/1024'},
                   result(outcome=outcome, first={'velocity': nums(after[0]), 'spin': nums(after[1])},
                          second={'velocity': nums(after[2]), 'spin': nums(after[3])}))
    zero = (0, 0, 0)
    bounce('Face to face, head on: velocities are exchanged, and nothing turns.', [2, 0, 0], rigid_body(zero, [1, 0, 0]),
           rigid_body((2, 0, 0), zero), (zero, zero, (1, 0, 0), zero))
    bounce('A wall.', [2, 0, 0], rigid_body(zero, [1, 1, 0]), {'fixed': True}, ((-1, 1, 0), zero, zero, zero))
    # An edge whose middle is 1 above the centre, against a wall: m = 1, I = 2/3, 1/m + 1/I = 5/2, J = 2 * 1 / (5/2).
    bounce('A face on half of a wall: the impulse J is at the nearest corners that stop it, 1 - J = -1/5 + ...', [2, 2, 0],
           rigid_body(zero, [1, 0, 0]), {'fixed': True}, ((1, 0, 0), zero, zero, zero), 'persistent')
    bounce('Nothing approaches.', [2, 0, 0], rigid_body(zero, [-1, 0, 0]), rigid_body((2, 0, 0), zero),
           ((-1, 0, 0), zero, zero, zero), 'persistent')
    bounce('A spin about the normal is kept, without friction.', [2, 0, 0], rigid_body(zero, [1, 0, 0], (3, 0, 0)),
           rigid_body((2, 0, 0), zero), (zero, (3, 0, 0), (1, 0, 0), zero))
    return r


TIP = """shape Spike {
  vertices t (0,0,0)  a (-1,-1,-3)  b (1,-1,-3)  c (0,1,-3)
  faces    base [a,c,b]  x [a,b,t]  y [b,c,t]  z [c,a,t]
}
"""


ON_TIP = TIP + RIGID + ('fixed spike = Spike\nprocess p = Cube mass 1 spin (1,0,0) at translate (0,0,1) [nil]\n')
GIVEN_UP = {'error': {'code': -32006, 'data': {'diagnostics': {'some': [{'code': 'SC0602', 'severity': 'error'}]}}}}


def persistent():
    r = Rule('Persistent')
    cube = cube_of(r)
    r.add_next('Faces that slide: nothing approaches.', 'response', {
        'touching': [{'a': cube, 'b': cube, 'offset': [2, 0, 0], 'at': [0, 0, 0]}],
        'first': rigid_body((0, 0, 0), [0, 1, 0]), 'second': rigid_body((2, 0, 0), [0, 0, 0]), 'resolution': '1/1024'},
        result(outcome='persistent', first={'velocity': nums((0, 1, 0)), 'spin': nums((0, 0, 0))}))
    r.add_next('A face that turns on a tip below its middle: the tip stands still against it, and would be inside at '
               'once.', 'successors', {'model': r.model(ON_TIP)}, GIVEN_UP)
    return r


def round_():
    r = Rule('Round')
    body = RIGID + 'process p = Cube mass 1 velocity (%s,0,0) spin (0,0,%s) [eps(10). nil]\n'
    r.value('1/3 is nearest to 1/4 among the quarters, from the first turn on.',
            'round velocity 1/4\n' + body % ('1/3', '1/4'), [TIME], 'vx(p)', '1/4')
    r.value('Of two equally near the one farther from zero: 1/8 becomes 1/4.',
            'round velocity 1/4\n' + body % ('1/8', '1/4'), [TIME], 'vx(p)', '1/4')
    r.value('-1/8 becomes -1/4.', 'round velocity 1/4\n' + body % ('-1/8', '1/4'), [TIME], 'vx(p)', '-1/4')
    r.value('Spins as well: 1/3 becomes 1/4.', 'round velocity 1/4\n' + body % ('1', '1/3'), [TIME], 'wz(p)', '1/4')
    r.value('What does not spin is rounded when something happens to it: at the start.', 'round velocity 1/4\n' + body % ('1/3', '0'),
            [], 'vx(p)', '1/4')
    r.value('Nothing is rounded that is not asked for.', body % ('1/3', '1/4'), [TIME], 'vx(p)', '1/3')
    return r


def suites():
    return [turn(), cast(), near(), impact(), persistent(), round_()]
