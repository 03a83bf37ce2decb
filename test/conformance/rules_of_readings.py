"""By hand: the readings (section 6 of the rule book)."""

from make_rules import (BIND, BOUNCE, CLOSE, SHAPE_CUBE, STRONG, TIME, WEAK, Rule, binds, bonded, bounces, closes, conditions, cube_of,
                        cubes, dock, edge, face, leaf, pair, passes, reacts, releases, vertex)
from rules_of_turning import RIGID
from rules_of_bodies import GRAVITY, LINE, REACT, RELEASE, RING, TRIPLE, behaviours, square
from cases import num, nums, result, unordered


def i_1():
    r = Rule('I-1')
    r.add_next('12 edges, not 24.', 'shape.check', SHAPE_CUBE, result(edges=12, definition_4_3={
        'euler': 2, 'euler_ordered': -10}))
    r.outcomes('An edge may be named either way round.', dock(v='(1,1,0)', at='(4,4,0)').replace('{right}', '{[g,c]}'),
               [TIME], [binds('dock', 'p.[c,g]', 'q.[a,e]')])
    return r


def i_2():
    r = Rule('I-2')
    inside_out = {'vertices': SHAPE_CUBE['vertices'], 'faces': [f[::-1] for f in SHAPE_CUBE['faces']]}
    r.add_next('Inside out: no printed condition speaks of orientation (D-3).', 'shape.check', inside_out, result(
        accepted=False, definition_4_3={'holds': True, **conditions()}, faults={'some': [{'code': 'SC0309'}]}))
    cut = {'vertices': SHAPE_CUBE['vertices'], 'faces': SHAPE_CUBE['faces'][1:] + [[0, 3, 2], [0, 2, 1]]}
    r.add_next('A face cut in two: an angle of 180 degrees.', 'shape.check', cut, result(
        accepted=False, definition_4_3={'holds': False, **conditions(6)}, faults={'some': [{'code': 'SC0308'}]}))
    return r


def i_3():
    r = Rule('I-3')
    cube = cube_of(r)
    inner = [nums((1, y, z)) for y in ('1/2', 1) for z in ('1/2', 1)]
    r.add_next('Shifted faces: a corner of each lies inside the face of the other, and edges cross. Edges that lie in '
               'one plane and have no point in common inside do not touch.', 'contact',
               {'a': cube, 'b': cube, 'offset': [2, '3/2', '3/2']}, result(region=unordered(inner), pairs=unordered([
                   pair(face('right'), face('left'), 2), pair(vertex('g'), face('left'), 0),
                   pair(face('right'), vertex('a'), 0), pair(edge('[c,g]'), face('left'), 1),
                   pair(edge('[f,g]'), face('left'), 1), pair(face('right'), edge('[a,d]'), 1),
                   pair(face('right'), edge('[a,e]'), 1), pair(edge('[c,g]'), edge('[a,d]'), 0),
                   pair(edge('[f,g]'), edge('[a,e]'), 0)])))
    return r


def i_4():
    r = Rule('I-4')
    cube = cube_of(r)
    r.add_next('Among pairs whose contact is of dimension 1, the edges: their insides hold that of the region.', 'contact',
               {'a': cube, 'b': cube, 'offset': [2, 0, -2]}, result(highest=pair(edge('[b,c]'), edge('[e,h]'), 1)))
    r.refused('A glue of edges of faces that touch.', 'compound Two {\n  part l : Cube mass 1\n  part r : Cube mass 1 at '
              'translate (2,0,0)\n  glue l.[b,c] ~ r.[a,d]\n}\nprocess t = Two [nil]\n', 'SC0402')
    return r


def i_5():
    r = Rule('I-5')
    one = bonded('', 'nil', 'nil')
    other = bonded('', 'nil', 'nil', bond='bond <dock, {q.left, p.right}>\n')
    for text in (one, other):
        r.state('The ends of a bond in any order.', text, [], [{'bonds': unordered([
            {'name': 'dock', 'ends': unordered(['p.right', 'q.left'])}])}])
    swapped = '\n'.join(dock().split('\n')[:-3] + dock().split('\n')[-3:-1][::-1]) + '\n'
    r.outcomes('Processes in any order.', swapped, [TIME], [binds('dock', 'p.right', 'q.left')])
    return r


def i_6():
    r = Rule('I-6')
    r.outcomes('Only one end offers it.', bonded(RELEASE, 'nil', 'L'), [], [], 'quiescent')
    r.outcomes('A bar is ignored.', bonded(RELEASE.replace('omega(dock, {right})', 'omega(~dock, {right})'), 'K', 'L'), [],
               [releases('dock', 'p.right', 'q.left'), passes(1)])
    return r


def i_7():
    r = Rule('I-7')
    four = ('process s = Cube mass 1 at translate (6,0,0) [%s]\nbond <c, {r.right, s.left}>\n')
    text = behaviours(P='rho({<a, {right}>}). nil', Q='rho({<a, {left}>}). nil', R='rho({<c, {right}>}). nil',
                      S='rho({<c, {left}>}). nil') + TRIPLE % ('P', 'Q', 'R') + four % 'S'
    a, c = ('a', 'p.right', 'q.left'), ('c', 'r.right', 's.left')
    r.outcomes('Two reactions at two ends of one process.', text, [], [reacts(a), reacts(c)])
    r.outcomes('The other one is left.', text, [reacts(a)], [reacts(c)])
    return r


def i_8():
    r = Rule('I-8')
    text = behaviours(K='<a, {left, right}>. nil', L='<~a, {right}>. nil', R='<~a, {left}>. nil') + LINE % ('L', 'K', 'R')
    r.outcomes('Either comes first.', text, [TIME], [binds('a', 'p.right', 'q.left'), binds('a', 'q.right', 'r.left')])
    r.outcomes('The other finds nothing open any more, and bounces.', text, [TIME, binds('a', 'p.right', 'q.left')],
               [bounces('p', 'r')])
    return r


def i_9():
    r = Rule('I-9')
    text = bonded(RELEASE, 'eps(1/2). K', 'L', extra='split_step 1/3\n')
    r.outcomes('It becomes enabled when the delay is over.', text, [], [passes('1/2')])
    r.outcomes('Its clock starts then.', text, [TIME], [releases('dock', 'p.right', 'q.left'), passes('1/3')])
    other = bonded(RELEASE, 'K', 'L', extra='split_step 2\nprocess r = Cube mass 1 at translate (0,40,0) [eps(1/2). nil]\n')
    r.outcomes('The delay of another process is no split instant.', other, [TIME], [passes('3/2')])
    r.outcomes('But 2 is.', other, [TIME, TIME], [releases('dock', 'p.right', 'q.left'), passes(2)])
    for note, idle in [('A delay of its own that brings up nothing', 'nil'),
                       ('Nor one that offers the same bond once more', 'K')]:
        own = bonded(RELEASE, 'J', 'L', extra='split_step 2\nbehaviour J on Cube = omega(dock, {right}). Gone + eps(1/2). %s\n'
                     % idle)
        r.outcomes(note + ' is no split instant.', own, [TIME], [passes('3/2')])
        r.outcomes('But 2 is, as without it.', own, [TIME, TIME], [releases('dock', 'p.right', 'q.left'), passes(2)])
    return r


def i_10():
    r = Rule('I-10')
    r.value('dt is 0 at the first.', GRAVITY, [], 'vz(p)', 0)
    cut = GRAVITY + 'process q = Cube mass 1 velocity (1,0,0) at translate (0,40,0) [nil]\n' \
        'process r = Cube mass 1 at translate (5/2,40,0) [nil]\n'
    r.outcomes('A collision after 1/2 ends the step.', cut, [], [passes('1/2')])
    r.value('After it, dt is 1/2.', cut, [TIME, BOUNCE], 'vz(p)', -1)
    r.value('And then 1: the sum is that of all time.', cut, [TIME, BOUNCE, TIME], 'vz(p)', -3)
    return r


def i_11():
    r = Rule('I-11')
    r.state('Both go on as the whole did.', bonded(RELEASE, 'K', 'L', v='(1,2,3)'), [WEAK], [
        {'velocity': nums((1, 2, 3)), **leaf('p')}, {'velocity': nums((1, 2, 3)), **leaf('q')}])
    fixed = RELEASE + ('fixed q = Cube at translate (2,0,0) [L]\nprocess p = Cube mass 1 [K]\n'
                       'bond <dock, {p.right, q.left}>\n')
    r.value('From a fixed body, from rest.', fixed, [WEAK], 'speed2(p)', 0)
    return r


def i_12():
    r = Rule('I-12')
    r.outcomes('They touch, and do not approach: nothing binds.', dock(v='(0,0,0)', at='(2,0,0)'), [], [], 'quiescent')
    r.outcomes('Nor while they slide.', dock(v='(0,1,0)', at='(2,0,0)'), [], [], 'quiescent')
    r.outcomes('They approach.', dock(at='(2,0,0)'), [], [binds('dock', 'p.right', 'q.left')])
    for where, what, bonds in (
            ('v.left', 'q slides down along v and lands on u: where it slides', [('p.v.left', 'q.right')]),
            ('u.back', 'Where it lands', [('p.u.back', 'q.front')]),
            ('u.back, v.left', 'Either', [('p.u.back', 'q.front'), ('p.v.left', 'q.right')])):
        r.outcomes(what + '.', CORNER % where, [passes(2)], [binds('dock', *b) for b in bonds])
    r.outcomes('Not where it does not touch.', CORNER % 'u.front', [passes(2)], [bounces('p', 'q')])
    r.outcomes('A channel on an edge is compatible also beside one on the face: the highest dimension is that of the two.',
               dock(at='(2,0,0)').replace('<dock, {right}>. Bound', '<dock, {right}>. Bound + <b, {[b,c]}>. Bound').replace(
                   '<~dock, {left}>. Bound', '<~dock, {left}>. Bound + <~b, {left}>. Bound'),
               [], [binds('dock', 'p.right', 'q.left'), binds('b', 'p.[b,c]', 'q.[a,d]')])
    return r


CORNER = '''compound L {
  part u : Cube mass 1
  part w : Cube mass 1 at translate (2,0,0)
  part v : Cube mass 1 at translate (2,2,0)
  glue u.right ~ w.left
  glue w.back ~ v.front
}
behaviour Open on L = <dock, {%s}>. nil
behaviour Shut on Cube = <~dock, {right, front}>. nil
process p = L [Open]
process q = Cube mass 1 velocity (0,-1,0) at translate (0,4,0) [Shut]
'''


def i_13():
    r = Rule('I-13')
    cube = cube_of(r)
    floor = [{'a': cube, 'b': cube, 'offset': [x, 0, 2]} for x in (-1, 1)]
    r.add_next('A floor of two tiles is one plate.', 'response', {
        'touching': floor, 'first': {'fixed': True}, 'second': {'mass': 1, 'velocity': [1, 0, -1]}},
        result(outcome='bounced', second={'velocity': nums((1, 0, 1))}))
    seam = [{'a': cube, 'b': cube, 'offset': [x, 0, 2]} for x in (-2, 0)]
    r.add_next('A cube flush with a tile, at the seam to the next: its side does not count.', 'response', {
        'touching': seam, 'first': {'fixed': True}, 'second': {'mass': 1, 'velocity': [-1, 0, -1]}},
        result(outcome='bounced', second={'velocity': nums((-1, 0, 1))}))
    r.add_next('At the edge of a single tile it does.', 'response', {
        'touching': seam[:1], 'first': {'fixed': True}, 'second': {'mass': 1, 'velocity': [1, 0, -1]}},
        result(outcome='bounced', second={'velocity': nums((-1, 0, 1))}))
    step = [{'a': cube, 'b': cube, 'offset': [0, 0, 2]}, {'a': cube, 'b': cube, 'offset': [2, 0, 1]}]
    r.add_next('A floor and a wall: both count.', 'response', {
        'touching': step, 'first': {'fixed': True}, 'second': {'mass': 1, 'velocity': [-1, 0, -1]}},
        result(outcome='bounced', second={'velocity': nums((1, 0, 1))}))
    return r


def i_14():
    r = Rule('I-14')
    text = behaviours(K='eps(2). L + <a, {top}>. nil', L='<b, {top}>. nil')
    aged = text + 'process p = Cube mass 1 [K]\nprocess q = Cube mass 1 at translate (40,0,0) [eps(1). nil]\n'
    r.value('What K became by ageing is K still.', aged, [TIME], 'behaviour(p) = K', True)
    alone = behaviours(K='eps(2). L', L='<b, {top}>. nil') + 'process p = Cube mass 1 [K]\n'
    r.value('When an eps is over, the name behind it is the new origin.', alone, [TIME], 'behaviour(p) = L', True)
    r.value('And no more the old one.', alone, [TIME], 'behaviour(p) = K', False)
    names = behaviours(L='<b, {top}>. nil', J='eps(1). L')
    aging = 'process q = Cube mass 1 at translate (40,0,0) [eps(4). nil]\n'
    for note, body, along in [
            ('A name that is a summand does not count, also when it is the only one that is left.', 'L + eps(3). nil', 1),
            ('Nor one that comes up as a summand,', 'eps(1). L + eps(2). nil', 1),
            ('and is left alone later,', 'eps(1). L + eps(2). nil', 2),
            ('or comes up when the others have gone,', 'eps(2). L + eps(1). nil', 2),
            ('or at the same time,', 'eps(2). L + eps(2). nil', 1),
            ('or after a name.', 'eps(1). J + eps(1). nil', 2)]:
        text = names + behaviours(M=body) + aging + 'process p = Cube mass 1 [M]\n'
        r.value(note, text, [TIME] * along, 'behaviour(p) = M', True)
    return r


def i_15():
    r = Rule('I-15')
    text = GRAVITY + 'process q = Cube mass 1 velocity (1,0,0) at translate (0,40,0) [nil]\n' \
        'process r = Cube mass 1 at translate (3,40,0) [nil]\n'
    r.value('Something collides when the step has ended: not steered yet.', text, [TIME], 'vz(p)', 0)
    r.value('It is part of the collision after which nothing collides any more.', text, [TIME, BOUNCE], 'vz(p)', -2)
    r.value('And of the passing of time where nothing collides.', GRAVITY, [TIME], 'vz(p)', -2)
    return r


def i_16():
    r = Rule('I-16')
    text = bonded(RELEASE, 'K', 'L', extra='split_step 1/2\n')
    for along in ([], [TIME], [TIME, TIME]):
        r.state('A multiple of the split step is 0.', text, along, [{'clock': num(0)}])
    r.verdict('So that the state recurs, and a run that waits is followed for ever.', text, 'EG bound(p, q)', 'holds')
    return r


def i_17():
    r = Rule('I-17')
    text = behaviours(K='eps(1). (K + K)') + 'process p = Cube mass 1 [K]\n'
    r.verdict('It comes back to where it was.', text, 'AG AF behaviour(p) = K', 'holds')
    twice = REACT.replace('rho({<dock, {right}>})', 'rho({<dock, {right}>, <dock, {right}>})')
    r.outcomes('An entry that is written twice counts once.', bonded(twice, 'K', 'L'), [],
               [reacts(('dock', 'p.right', 'q.left'))])
    redundant = REACT.replace('rho({<dock, {right}>})', 'rho({<dock, {right}>, <dock, {right, [b,c]}>})')
    r.outcomes('Also when the features of one are listed redundantly (D-21).', bonded(redundant, 'K', 'L'), [],
               [reacts(('dock', 'p.right', 'q.left'))])
    more = REACT.replace('rho({<dock, {right}>})', 'rho({<dock, {right}>, <dock, {right, top}>})')
    r.outcomes('Another closure is another entry, which finds no bond.', bonded(more, 'K', 'L'), [], [], 'quiescent')
    return r


def i_18():
    r = Rule('I-18')

    def rigid(note, text, yes):
        from make_rules import CUBE
        r.add_next(note, 'model.load', {'text': CUBE + text}, result(rigid=yes))
    rigid('Nothing turns.', cubes(), False)
    rigid('A spin of zero.', 'process p = Cube mass 1 spin (0,0,0) [nil]\n', False)
    rigid('A spin.', 'process p = Cube mass 1 spin (0,0,1/9) [nil]\n', True)
    rigid('Declared.', 'dynamics free_body\n' + cubes(), True)
    r.value('In a translational model nothing turns, hit off centre.', cubes(at='(4,1,0)'), [TIME, BOUNCE],
            'wz(p) = 0 and vx(q) = 1', True)
    return r


PLATE = 'shape Plate = Cube scaled (2, 1, 1/2)\nprocess p = Plate mass 1 spin (1/4,1/4,0) [eps(10). nil]\n'


def i_19():
    r = Rule('I-19')
    for said in ('', 'dynamics constant_spin\n'):
        r.verdict('constant_spin, also if nothing is said: the spin stays, and so does the energy.', said + PLATE,
                  'always (wx(p) = 1/4 and wy(p) = 1/4 and wz(p) = 0) within 3', 'holds')
    for along in ([], [TIME], [TIME] * 3):
        r.value('free_body: at the start of each turn the angular momentum is what it was: 5/12 and 17/12 times 1/4.',
                'dynamics free_body\n' + PLATE, along, 'angular.x = 5/48 and angular.y = 17/48 and angular.z = 0', True)
    r.verdict('And the spin changes.', 'dynamics free_body\n' + PLATE, 'possibly wx(p) != 1/4 within 3', 'holds')
    return r


def i_20():
    r = Rule('I-20')
    two = RIGID + ('process p = Cube mass 1 spin (0,0,3) [nil]\n'
                   'process q = Cube mass 1 at translate (40,0,0) [eps(10). nil]\n')
    r.outcomes('3 d / 2 <= 1/4 for d = 1/8: halved three times.', two, [], [passes('1/8')])
    r.outcomes('2 d / 2 = 1/4 just does.', two.replace('(0,0,3)', '(0,0,1/2)'), [], [passes(1)])
    return r


def i_21():
    r = Rule('I-21')
    cube = cube_of(r)
    for why, offset, velocity, resolution, grid, time in (
            ('Speed 3, resolution 3/8: 3/8 in 1/8. At 2/3, which is 5/8 on that grid.', [4, 0, 0], [-3, 0, 0], '3/8', 3,
             '5/8'),
            ('A resolution of 3: whole steps.', [4, 0, 0], [-3, 0, 0], 3, 0, 0)):
        r.add_next(why, 'first_time_of_contact', {'a': cube, 'b': cube, 'offset': offset, 'velocity': velocity, 'span': 1,
                                                  'resolution': resolution},
                   result(outcome='at', time=num(time), grid=grid))
    return r


def i_22():
    r = Rule('I-22')
    cube = cube_of(r)
    for why, tilt, second in (('Tilted by less than the resolution: a face.', 1000, face('left')),):
        r.add_next(why, 'contact', {'a': cube, 'b': cube, 'offset': ['201/100', 0, 0], 'resolution': '1/8',
                                    'turned_b': [tilt, 0, 0, 1]},
                   result(relation='near', highest={'first': face('right'), 'second': second}))
    r.add_next('By more: an edge.', 'contact', {'a': cube, 'b': cube, 'offset': ['5/2', 0, 0], 'resolution': '1/4',
                                                'turned_b': [4, 0, 0, 1]},
               result(relation='near', highest={'first': face('right'), 'second': {'kind': 'edge'}}))
    return r


def i_23():
    r = Rule('I-23')
    text = RELEASE + RIGID + ('process p = Cube mass 1 velocity (0,-1/4,0) spin (0,0,1/4) at translate (-1,0,0) [K]\n'
                      'process q = Cube mass 1 velocity (0,1/4,0) spin (0,0,1/4) at translate (1,0,0) [L]\n'
                      'bond <dock, {p.right, q.left}>\n')
    r.state('Each has the spin of the whole, and the velocity that its centre had.', text, [WEAK], [
        {'velocity': nums((0, '-1/4', 0)), 'spin': nums((0, 0, '1/4')), **leaf('p')},
        {'velocity': nums((0, '1/4', 0)), 'spin': nums((0, 0, '1/4')), **leaf('q')}])
    r.value('So energy is kept: (1/16 + 1/16)/2 + 2 * 2/3 * 1/16 / 2.', text, [], 'energy', '5/48')
    r.value('After the split.', text, [WEAK], 'energy', '5/48')
    return r


def i_24():
    r = Rule('I-24')
    text = RIGID + 'process p = Cube mass 1 spin (0,0,1/4) [nil]\nmotion p = (vx + dt, vy, vz)\n'
    r.value('A law gives a velocity.', text, [TIME], 'vx(p)', 1)
    r.value('No torque.', text, [TIME], 'wz(p)', '1/4')
    text = '%sprocess p = Cube mass 1 velocity (1,0,0) spin (0,0,1/4) [nil]\nmotion p = %s\n'
    faster = '(vx, vy, vz) spin (wx, wy, wz + dt/8)'
    r.value('A spin beside it: at first dt is 0.', text % (RIGID, faster), [], 'wz(p)', '1/4')
    r.value('After a step of 1.', text % (RIGID, faster), [TIME], 'wz(p)', '3/8')
    r.value('The velocity stays as it is.', text % (RIGID, faster), [TIME], 'vx(p)', 1)
    r.value('What is free keeps the angular momentum of the spin: 2/3 * 3/8.',
            text % ('dynamics free_body\n', faster), [TIME], 'angular.z', '1/4')
    two = RIGID + ('process p = Cube mass 1 velocity (0,-3/2,0) spin (0,0,1) [nil]\n'
                   'process q = Cube mass 3 velocity (0,1/2,0) spin (0,0,1) at translate (2,0,0) [nil]\n'
                   'bond <a, {p.right, q.left}>\n')
    r.value('In a whole by mass: (1 * 3 + 3 * 1)/4.', two + 'motion p = (vx, vy, vz) spin (0,0,3)\n', [], 'wz(q)', '3/2')
    r.value('What both give.', two + 'motion (vx, vy, vz) spin (0,0,3)\n', [], 'wz(q)', 3)
    return r


def i_25():
    r = Rule('I-25')
    near = 'resolution 1/4\ndynamics constant_spin\n' + cubes('', '', at='(%s,0,0)', v='(0,0,0)')
    for at, yes in (('2', True), ('9/4', True), ('17/8', True), ('226/100', False)):
        r.value('At %s: %s 1/4 apart.' % (at, 'at most' if yes else 'more than'), near % at, [], 'touching(p, q)', yes)
    return r


def i_26():
    r = Rule('I-26')
    plain = RIGID + 'process p = Cube mass 1 velocity (1/3,0,0) spin (1/7,0,0) [eps(10). nil]\n'
    r.value('Nothing is rounded unless the model says so.', plain, [TIME], 'vx(p) = 1/3 and wx(p) = 1/7', True)
    r.value('Where it says so, places are not: 1/3 after a step of 1, or what was rounded.', 'round velocity 1/4\n' + plain,
            [TIME], 'vx(p) = 1/4 and wx(p) = 1/4', True)
    hit = cubes(mass=(1, 2))
    r.value('Masses 1 and 2: -1/3 and 2/3.', hit, [TIME, BOUNCE], 'vx(p) = -1/3 and vx(q) = 2/3', True)
    r.value('Also where nothing turns.', 'round velocity 1/4\n' + hit, [TIME, BOUNCE], 'vx(p) = -1/4 and vx(q) = 3/4', True)
    return r


def i_27():
    from rules_of_turning import GIVEN_UP, ON_TIP, TIP
    r = Rule('I-27')
    text = TIP + ('fixed spike = Spike\nprocess p = Cube mass 1 velocity (0,0,-1) %s at translate (0,0,2) [nil]\n')
    r.add_next('A face that turns on a tip: given up.', 'successors', {'model': r.model(ON_TIP)}, GIVEN_UP)
    r.outcomes('A face that comes down on a tip bounces.', 'dynamics constant_spin\nresolution 1/1024\n' + text % '', [TIME],
               [bounces('spike', 'p')])
    return r


def i_28():
    r = Rule('I-28')
    apart = RIGID + cubes('', '', at='(40,0,0)', v='(-1,0,0)').replace('mass 1 velocity (-1,0,0)',
                                                               'mass 1 velocity (-1,0,0) spin (0,0,1)')
    r.outcomes('They go apart, whatever turns.', apart, [], [], 'quiescent')
    towards = apart.replace('velocity (-1,0,0)', 'velocity (1,0,0)')
    r.value('They may meet.', towards, [], 'quiescent', False)
    return r


# Tilted by twice the arc whose tangent is 1/2, face to face, across (3, 4, 0).
TILTED = (RIGID + 'round velocity 1/2\n'
          'process p = Cube mass 1 velocity (%s,0) at rotate quaternion (2,0,0,1) [nil]\n'
          'process q = Cube mass 1 at translate (6/5,8/5,0) * rotate quaternion (2,0,0,1) [nil]\n'
          'process r = Cube mass 1 velocity (2/3,0,0) at translate (90,0,0) [nil]\n')


def i_29():
    r = Rule('I-29')
    r.value('(13/50, -1/5) is (1/2, 0) in halves, which leads into q: it waits.', TILTED % '13/50,-1/5', [],
            'vx(p) = 13/50 and vy(p) = -1/5', True)
    r.value('Others do not wait for it.', TILTED % '13/50,-1/5', [], 'vx(r)', '1/2')
    r.value('(-2/5, 1/5) is (-1/2, 0), which leads away.', TILTED % '-2/5,1/5', [], 'vx(p) = -1/2 and vy(p) = 0', True)
    both = (RIGID + 'round velocity 1/4\n' + cubes(at='(2,0,0)', v='(1/8,0,0)', w='(1/8,0,0)'))
    r.value('Both at once: one after the other they would be in each other\'s way.', both, [],
            'vx(p) = 1/4 and vx(q) = 1/4', True)
    return r


def i_30():
    r = Rule('I-30')
    far = ('process %s = Cube mass 1 spin (0,0,1/2) [eps(10). nil]\nprocess a = Cube mass 1 velocity (3,0,0) at translate (0,90,0) '
           '[nil]\nprocess b = Cube mass 1 at translate (4,90,0) [nil]\n')
    text = RIGID + far % 'p'
    for along, what in (([TIME], 'A contact'), ([TIME, BOUNCE], 'A collision')):
        r.state(what + ' at 2/3, far away: the turn goes on.', text, along,
                [{'since': num('2/3'), 'lasts': num(1), **leaf('p')}, leaf('a'), leaf('b')])
    r.outcomes('And it is over at 1.', text, [TIME, BOUNCE], [passes('1/3')])
    r.state('Those that do not spin have no turns.', text, [TIME, BOUNCE], [
        leaf('p'), {'since': num(0), 'lasts': num(0), **leaf('a')}, {'since': num(0), 'lasts': num(0), **leaf('b')}])
    return r


TWO = ('process p = Cube mass 1 velocity (1,0,0) at translate (-3,0,0) [nil]\nprocess q = Cube mass 1 at translate (0,1,0) '
       '[nil]\nprocess r = Cube mass 1 at translate (0,-1,0) [nil]\n')


FALLING = ('timestep 1 %s\nprocess ball = Cube mass 1 [nil]\nprocess p = Cube mass 1 velocity (3,0,0) at translate (0,90,0) '
           '[nil]\nprocess q = Cube mass 1 at translate (4,90,0) [nil]\nmotion ball = (vx, vy, vz - dt)\n')


def i_31():
    r = Rule('I-31')
    after = [TIME, BOUNCE]
    r.value('A step of all ends with a collision far away, at 2/3.', FALLING % '', after, 'vz(ball)', '-2/3')
    r.value('A step of one does not.', FALLING % 'local', after, 'vz(ball)', 0)
    r.outcomes('It ends at 1.', FALLING % 'local', after, [passes('1/3')])
    r.value('And then its law is asked, with dt = 1.', FALLING % 'local', after + [TIME], 'vz(ball)', -1)
    r.state('The ball is in a step, of which 1/3 remains; the others have none.', FALLING % 'local', after, [
        {'step': {'remaining': num('1/3'), 'phase': 'moving'}, **leaf('ball', waited=num('2/3'))},
        {'step': None, **leaf('p', waited=num(0))}, {'step': None, **leaf('q', waited=num(0))}])
    return r


def i_32():
    r = Rule('I-32')
    all_three = {'kind': 'bounce', 'between': unordered(['p', 'q', 'r'])}
    r.outcomes('One by one, if nothing is said.', TWO, [TIME], [bounces('p', 'q'), bounces('p', 'r')])
    r.outcomes('As one.', 'collisions together\n' + TWO, [TIME], [all_three])
    r.value('1 = -1/3 + 2/3 + 2/3 and 1 = 1/9 + 4/9 + 4/9.', 'collisions together\n' + TWO, [TIME, BOUNCE],
            'vx(p) = -1/3 and vx(q) = 2/3 and vx(r) = 2/3', True)
    return r


def i_33():
    r = Rule('I-33')
    rest = dock(v='(0,0,0)', at='(2,0,0)')
    r.outcomes('At rest against each other.', 'binding contact\n' + rest, [], [binds('dock', 'p.right', 'q.left')])
    slide = dock(v='(0,1,0)', at='(2,5,0)')
    r.outcomes('Edges come to touch after 3.', 'binding contact\n' + slide, [], [passes(3)])
    r.outcomes('And bind.', 'binding contact\n' + slide, [TIME], [binds('dock', 'p.[c,g]', 'q.[a,e]')])
    r.refused('Not where bodies turn.', 'binding contact\ndynamics free_body\n' + rest, 'SC0901')
    return r


def i_34():
    r = Rule('I-34')
    corner = dock(v='(1,1,0)', at='(4,4,0)')
    edges = ('p.[c,g]', 'q.[a,e]')
    r.outcomes('A face has its edges.', corner, [TIME], [binds('dock', *edges)])
    only = corner.replace('{right}', '{only right}')
    r.outcomes('Alone it has not.', only, [TIME], [bounces('p', 'q')])
    r.outcomes('An edge that is listed itself.', corner.replace('{right}', '{only right, only [c,g]}'), [TIME],
               [binds('dock', *edges)])
    r.outcomes('Face to face.', dock().replace('{right}', '{only right}'), [TIME], [binds('dock', 'p.right', 'q.left')])
    r.refused('There is no first instant at which open faces meet.', 'binding contact\n' + only, 'SC0901')
    return r


def i_35():
    r = Rule('I-35')
    after = [TIME, BOUNCE]
    r.value('A step that a collision ends: the law is asked at 2/3.', FALLING % '', after, 'vz(ball)', '-2/3')
    r.value('One that keeps its beat.', FALLING % 'steady', after, 'vz(ball)', 0)
    r.outcomes('It ends at 1.', FALLING % 'steady', after, [passes('1/3')])
    r.value('And then the law is asked, with dt = 1.', FALLING % 'steady', after + [TIME], 'vz(ball)', -1)
    return r


def i_36():
    r = Rule('I-36')
    pair = behaviours(P='rho({<dock, {right}>}) push(1/2). nil', Q='rho({<dock, {left}>}) push(1). nil')
    text = bonded(pair, 'P', 'Q')
    split = {'kind': 'strong', 'bonds': [{'name': 'dock', 'ends': ['p.right', 'q.left'], 'push': num('3/2')}]}
    r.outcomes('The label tells what both ends say.', text, [], [split])
    r.value('They part along x, with impulses of 3/2.', text, [STRONG], 'vx(p) = -3/2 and vx(q) = 3/2', True)
    r.value('Energy is 3/2 * 3/2, of nothing; momentum stays.', text, [STRONG], 'energy = 9/4 and momentum.x = 0', True)
    r.value('Nothing is said.', bonded(behaviours(P='rho({<dock, {right}>}). nil', Q='rho({<dock, {left}>}). nil'), 'P',
            'Q'), [STRONG], 'vx(p) = 0 and vx(q) = 0', True)
    r.refused('What is split is not pulled.', bonded(pair.replace('1/2', '0-1/2'), 'P', 'Q'), 'SC0208')
    return r


def i_37():
    r = Rule('I-37')
    up, down = '<a, {top}>. nil', '<~a, {bottom}>. nil'
    r.outcomes('If nothing is said bonds are a tree.', square(up, s=down, bonds=''), [], [], 'quiescent')
    r.outcomes('Nor if it is said.', square(up, s=down, bonds='bonds acyclic\n'), [], [], 'quiescent')
    r.refused('Nor is a ring declared.', square(form=RING, bonds=''), 'SC0406')
    r.value('With the switch it is.', square(form=RING), [], 'bonds() = 4 and size(p) = 4', True)
    r.refused('But two leaves have one bond.', square(form=RING) + 'bond <more, {p.top, s.bottom}>\n', 'SC0406')
    two = 'rho({<link, {%s}>, <link, {%s}>}). nil'
    corners = [two % f for f in (('right', 'top'), ('left', 'top'), ('bottom', 'left'), ('right', 'bottom'))]
    all_four = reacts(('link', 'p.right', 'q.left'), ('link', 'q.top', 'r.bottom'), ('link', 'r.left', 's.right'),
                      ('link', 'p.top', 's.bottom'))
    r.outcomes('A reaction of a ring.', square(*corners, form=RING), [], [all_four])
    r.value('It falls into four.', square(*corners, form=RING), [STRONG], 'size(p) = 1 and bonds() = 0', True)
    r.outcomes('No leaf leaves out a bond of it.', square(*corners[:3], s='rho({<link, {right}>}). nil', form=RING), [], [],
               'quiescent')
    one = ['rho({<link, {right}>}) push(3). nil', 'rho({<link, {left}>}). nil']
    r.value('One bond goes, and the ring is one; a push on it is nothing.', square(*one, form=RING), [STRONG],
            'size(p) = 4 and bonds() = 3 and energy = 0', True)
    weak = square('omega(link, {top}). nil', s='omega(link, {bottom}). nil', form=RING)
    r.value('So it is with a weak split.', weak, [WEAK], 'size(p) = 4 and bonds() = 3', True)
    hook = behaviours(Up='<a, {top}>. rho({<a, {top}>}). Up', Down='<~a, {bottom}>. rho({<a, {bottom}>}). Down')
    r.outcomes('What a split releases may close again, at once.', square('Up', s='Down', bonds='bonds cyclic\n' + hook),
               [CLOSE, STRONG], [closes('a', 'p.top', 's.bottom')])
    meeting = ('bonds cyclic\nprocess p = Cube mass 1 velocity (1,0,0) [<a, {right}>. <a, {right}>. nil]\n'
               'process q = Cube mass 1 at translate (4,0,1) [<~a, {left}>. nil]\n'
               'process r = Cube mass 1 at translate (4,0,-1) [<~a, {left}>. nil]\nbond <link, {q.bottom, r.top}>\n')
    r.outcomes('A binding makes one bond.', meeting, [TIME], [binds('a', 'p.right', 'q.left'), binds('a', 'p.right', 'r.left')])
    r.outcomes('The other closes then.', meeting, [TIME, binds('a', 'p.right', 'q.left')], [closes('a', 'p.right', 'r.left')])
    return r


def suites():
    return [f() for f in (i_1, i_2, i_3, i_4, i_5, i_6, i_7, i_8, i_9, i_10, i_11, i_12, i_13, i_14, i_15, i_16, i_17, i_18,
                          i_19, i_20, i_21, i_22, i_23, i_24, i_25, i_26, i_27, i_28, i_29, i_30,
                          i_31, i_32, i_33, i_34, i_35, i_36, i_37)]
