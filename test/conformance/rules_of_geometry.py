"""By hand: Definitions 4.1 to 4.5, and the rules of section 1."""

from make_rules import (BIND, BOUNCE, CUBE, SHAPE_CUBE, TIME, Rule, binds, bounces, conditions, cube_of, cubes, dock,
                        edge, face, faces_but, leaf, pair, passes, vertex)
from cases import num, nums, result, unordered


def def_4_1():
    r = Rule('Def-4.1')
    rotated = {'vertices': SHAPE_CUBE['vertices'], 'faces': [f[2:] + f[:2] for f in SHAPE_CUBE['faces']]}
    r.add_next('Every face by another rotation of its tuple.', 'shape.check', rotated,
               result(accepted=True, definition_4_3={'holds': True}))
    r.add_next('The reversed tuple is another face, which looks the other way.', 'shape.check',
               faces_but(1, [7, 6, 5, 4]), result(accepted=False, definition_4_3={'conditions': [
                   {'number': i, 'holds': True} if i == 5 else {'number': i} for i in range(1, 8)]}))
    twice = {'vertices': SHAPE_CUBE['vertices'], 'faces': SHAPE_CUBE['faces'] + [[5, 6, 7, 4]]}
    r.add_next('A face again, rotated: it is the same one.', 'shape.check', twice,
               result(accepted=False, definition_4_3={'conditions': [
                   {'number': i, 'holds': False} if i == 5 else {'number': i} for i in range(1, 8)]}))
    turned = dock().replace('{right}', '{[g,f,b,c]}')
    r.outcomes('A channel names a face by a rotation of its tuple.', turned, [TIME],
               [binds('dock', 'p.right', 'q.left')])
    return r


def def_4_2():
    r = Rule('Def-4.2')
    slanted = dock(v='(1,1,0)', at='(4,4,0)')
    r.outcomes('Edges meet; they are in the closures of the two open faces.', slanted, [TIME],
               [binds('dock', 'p.[c,g]', 'q.[a,e]')])
    corner = dock(v='(1,1,1)', at='(4,4,4)')
    r.outcomes('Corners meet; they are in the closures of the two open faces.', corner, [TIME],
               [binds('dock', 'p.g', 'q.a')])
    only = dock(v='(1,1,0)', at='(4,4,0)').replace('{right}', '{[b,c]}')
    r.outcomes('The closure of the edge [b,c] is the edge, b and c; of these c touches, and nothing but a.', only, [TIME],
               [binds('dock', 'p.c', 'q.a')])
    none = dock(v='(1,1,1)', at='(4,4,4)').replace('{right}', '{[b,c]}')
    r.outcomes('g is not in the closure of [b,c].', none, [TIME], [bounces('p', 'q')])
    return r


def def_4_3():
    r = Rule('Def-4.3')
    r.add_next('The cube of Figure 4.', 'shape.check', SHAPE_CUBE, result(
        accepted=True, faults=[], edges=12, definition_4_3={'holds': True, **conditions(), 'euler': 2,
                                                           'euler_ordered': -10}))
    r.add_next('A cube without its lid.', 'shape.check',
               {'vertices': SHAPE_CUBE['vertices'], 'faces': SHAPE_CUBE['faces'][:1] + SHAPE_CUBE['faces'][2:]},
               result(accepted=False, definition_4_3={'holds': False, **conditions(7)}))
    spare = {'vertices': SHAPE_CUBE['vertices'] + [[0, 0, 0]],
             'faces': SHAPE_CUBE['faces'][:1] + SHAPE_CUBE['faces'][2:]}
    r.add_next('Without its lid, and with a spare vertex: all seven printed conditions hold (D-3).', 'shape.check',
               spare, result(accepted=False, definition_4_3={'holds': True, **conditions()}))
    r.add_next('No handle for what is no solid.', 'shape.define', spare, {'error': {'code': -32002, 'data': {
        'faults': {'some': [{'code': 'SC0304'}]}}}})
    return r


def def_4_4():
    r = Rule('Def-4.4')
    r.add_next('A map of positive determinant.', 'shape.define', {
        **SHAPE_CUBE, 'linear': [[2, 0, 0], [0, 1, 0], [0, 0, '1/2']]}, result(
            vertices=8, edges=12, faces=6, centroid=nums((0, 0, 0)), volume=num(8)))
    for why, m in (('A reflection.', [[-1, 0, 0], [0, 1, 0], [0, 0, 1]]),
                   ('A singular map.', [[1, 0, 0], [0, 1, 0], [1, 1, 0]])):
        r.add_next(why, 'shape.define', {**SHAPE_CUBE, 'linear': m}, {'error': {'code': -32002, 'data': {
            'faults': {'some': [{'code': 'SC0311'}]}}}})
    r.refused('The mass is positive.', 'process p = Cube mass 0 [nil]\n', 'SC0208')
    wall = 'fixed w = Cube at translate (4,0,0)\nprocess p = Cube mass 5 velocity (1,0,0) [nil]\n'
    r.verdict('A fixed body never moves, whatever hits it.', wall, 'always x(w) = 4 and vx(w) = 0', 'holds')
    r.verdict('What hits it goes back as fast as it came.', wall, 'eventually vx(p) = -1', 'holds')
    return r


def mass():
    r = Rule('Mass')
    cube = cube_of(r)
    r.add_next('A cube of side 2 and mass 3: 8, and 3 (2^2 + 2^2) / 12 about each axis.', 'shape.mass',
               {'shape': cube, 'mass': 3}, result(volume=num(8), centroid=nums((0, 0, 0)), mass=num(3),
                                                  inertia_of_mass=[nums((2, 0, 0)), nums((0, 2, 0)),
                                                                   nums((0, 0, 2))]))
    corner = r.give('corner', {'method': 'shape.define', 'params': {
        'vertices': [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]],
        'faces': [[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]]}, 'handle': 'shape', 'release': 'shape.release'})
    r.add_next('The corner of a cube.', 'shape.mass', {'shape': corner}, result(
        volume=num('1/6'), centroid=nums(('1/4', '1/4', '1/4'))))
    r.add_next('Turned by a right angle about z, and moved.', 'shape.mass',
               {'shape': corner, 'turned': [1, 0, 0, 1], 'at': [5, 0, 0]}, result(
                   volume=num('1/6'), centroid=nums(('19/4', '1/4', '1/4'))))
    return r


def contact():
    r = Rule('Contact')
    cube = cube_of(r)
    for why, offset, how in (('Faces touch.', [2, 1, 0], 'touching'), ('Corners touch.', [2, 2, -2], 'touching'),
                             ('A hair too far.', ['2.000000000000000001', 0, 0], 'apart'),
                             ('A hair too near.', ['1.999999999999999999', 0, 0], 'interpenetrating'),
                             ('In the same place.', [0, 0, 0], 'interpenetrating')):
        r.add_next(why, 'contact', {'a': cube, 'b': cube, 'offset': offset}, result(relation=how))
    return r


def touching_():
    r = Rule('Touching')
    cube = cube_of(r)
    r.add_next('Corner to corner: no more than these two touch.', 'contact', {'a': cube, 'b': cube, 'offset': [2, 2, 2]},
               result(pairs=unordered([pair(vertex('g'), vertex('a'), 0)]), region=[nums((1, 1, 1))]))
    r.add_next('Edge along edge: edges, and their ends.', 'contact', {'a': cube, 'b': cube, 'offset': [2, 2, 0]},
               result(pairs=unordered([pair(edge('[c,g]'), edge('[a,e]'), 1), pair(vertex('c'), vertex('a'), 0),
                                       pair(vertex('g'), vertex('e'), 0)]),
                      region=unordered([nums((1, 1, -1)), nums((1, 1, 1))])))
    r.add_next('Edge along a part of an edge: an end inside the other edge touches it.', 'contact',
               {'a': cube, 'b': cube, 'offset': [2, 2, 1]},
               result(pairs=unordered([pair(edge('[c,g]'), edge('[a,e]'), 1), pair(vertex('g'), edge('[a,e]'), 0),
                                       pair(edge('[c,g]'), vertex('a'), 0)]),
                      region=unordered([nums((1, 1, 0)), nums((1, 1, 1))])))
    return r


def highest_():
    r = Rule('Highest')
    cube = cube_of(r)
    for why, offset, x, y, d in (('Faces.', [2, 1, 1], face('right'), face('left'), 2),
                                 ('Edges.', [2, 2, 1], edge('[c,g]'), edge('[a,e]'), 1),
                                 ('Corners.', [-2, 2, 2], vertex('h'), vertex('b'), 0)):
        r.add_next(why, 'contact', {'a': cube, 'b': cube, 'offset': offset}, result(highest=pair(x, y, d)))
    return r


def compound(glue, at='(2,0,0)', extra=''):
    return ('compound Two {\n  part l : Cube mass 1\n  part r : Cube mass 3 at translate %s\n%s}\n'
            'process t = Two velocity (1,0,0) [nil]\n%s' % (at, glue, extra))


def def_4_5():
    r = Rule('Def-4.5')
    r.value('Two cubes, glued; the centre of mass is at 0/4 + 2*3/4.', compound('  glue l.right ~ r.left\n'), [],
            'x(t)', '3/2')
    r.value('They are two basic shapes.', compound('  glue l.right ~ r.left\n'), [], 'size(t)', 2)
    r.refused('The features of a glue touch.', compound('  glue l.right ~ r.left\n', '(3,0,0)'), 'SC0401')
    r.refused('They are the highest pair.', compound('  glue l.[b,c] ~ r.[a,d]\n'), 'SC0402')
    r.refused('Parts do not interpenetrate.', compound('  glue l.right ~ r.left\n', '(1,0,0)'), 'SC0403')
    r.refused('Glues join all parts.', compound(''), 'SC0405')
    return r


# A C of three bars, its caps and its spine drawn in pieces; and the same with other text in between.
CLAMP = """compound Clamp = decompose {
  vertices a (0,0,0) b (6,0,0) c (6,0,1) d (1,0,1) e (1,0,5) f (6,0,5) g (6,0,6) h (0,0,6) m (0,0,3)
           a' (0,2,0) b' (6,2,0) c' (6,2,1) d' (1,2,1) e' (1,2,5) f' (6,2,5) g' (6,2,6) h' (0,2,6) m' (0,2,3)
  faces    front0 [a,b,c,d,m] front1 [d,e,h,m] front2 [e,f,g,h] back [m',h',g',f',e',d',c',b',a']
           below [b,a,a',b'] low_tip [c,b,b',c'] low_jaw [d,c,c',d'] inner [e,d,d',e'] up_jaw [f,e,e',f']
           up_tip [g,f,f',g'] above [h,g,g',h'] spine0 [m,h,h',m'] spine1 [a,m,m',a']
} %s
"""


def decomposed():
    r = Rule('Decomposed')

    def held(where, at='(9,1,3)', v='(-1,0,0)', mine='left', attributes='mass 32'):
        return CLAMP % attributes + (
            'process t = Clamp [<a, {%s}>. nil]\nprocess q = Cube mass 1 velocity %s at translate %s [<~a, {%s}>. nil]\n'
            % (where, v, at, mine))

    r.value('The centre of mass is that of the whole: the spine at 1/2 and the jaws at 7/2, of areas 6 and 10.', held('inner'),
            [], 'x(t) = 19/8 and y(t) = 1 and z(t) = 3', True)
    r.value('So is what a bond gives: 32 of 33.', held('inner'), [TIME, {'kind': 'bind'}], 'vx(t)', '-1/33')
    for what, where, at, v, mine, binds in (
            ('The floor between the jaws.', 'inner', '(9,1,3)', '(-1,0,0)', 'left', True),
            ('Not the tip of a jaw.', 'inner', '(9,1,0)', '(-1,0,0)', 'left', False),
            ('The tip.', 'low_tip', '(9,1,0)', '(-1,0,0)', 'left', True),
            ('A cap, by a name of it, on the lower jaw;', 'front1', '(4,-4,1/2)', '(0,1,0)', 'back', True),
            ('on the upper one;', 'front1', '(4,-4,11/2)', '(0,1,0)', 'back', True),
            ('on the spine;', 'front1', '(1/2,-4,3)', '(0,1,0)', 'back', True),
            ('without its edges, in its middle.', 'only front1', '(1/2,-4,3)', '(0,1,0)', 'back', True),
            ('Not the other cap.', 'back', '(4,-4,1/2)', '(0,1,0)', 'back', False),
            ('The spine from outside.', 'spine0', '(-5,1,1)', '(1,0,0)', 'right', True),
            ('An edge comes to the floor.', 'inner', '(9,1,3)', '(-1,0,0)', '[e,h]', True)):
        r.verdict(what, held(where, at, v, mine), 'eventually bound(t, q)', 'holds' if binds else 'violated')
    r.refused('A corner inside an edge that goes straight on.', held('m'), 'SC0336')
    r.refused('An edge inside a cap.', held('[d, m]'), 'SC0336')
    r.refused('Without a mass.', held('inner', attributes=''), 'SC0208')
    r.refused('Jaws that go through each other.', held('inner').replace('f (6,0,5)', 'f (6,0,1/2)').replace(
        "f' (6,2,5)", "f' (6,2,1/2)"), 'SC0306')
    r.refused('A tip that goes through the spine.', held('inner').replace('c (6,0,1)', 'c (6,0,8)').replace(
        "c' (6,2,1)", "c' (6,2,8)"), 'SC0306')
    return r


def approach():
    r = Rule('Approach')
    cube = cube_of(r)
    for why, offset, velocity, yes in (
            ('Head on.', [2, 0, 0], [-1, 0, 0], True), ('Sliding along a face.', [2, 0, 0], [0, 1, 0], False),
            ('At rest.', [2, 0, 0], [0, 0, 0], False), ('Going away.', [2, 0, 0], [1, 0, 0], False),
            ('An edge against an edge, straight ahead: it will slide along the face.', [2, 2, 0], [-1, 0, 0], False),
            ('An edge against an edge, aslant.', [2, 2, 0], [-1, '-1/1000', 0], True)):
        r.add_next(why, 'contact', {'a': cube, 'b': cube, 'offset': offset, 'velocity': velocity},
                   result(relation='touching', approaching=yes))
    sliding = cubes(at='(2,-3,0)', v='(0,0,0)', w='(0,1,0)')
    r.verdict('A body that slides along another does not collide with it.', sliding, 'always not event bounce', 'holds')
    return r


def ftoc():
    r = Rule('Ftoc')
    cube = cube_of(r)
    for why, offset, velocity, time in (
            ('Face to face: 2 to go, at 2.', [4, 0, 0], [-2, 0, 0], 1),
            ('A third.', [3, '1/2', 0], [-3, 0, 0], '1/3'), ('Corner to corner.', [3, 3, 3], [-1, -1, -1], 1),
            ('The last axis counts.', [3, 4, 1], [-1, -1, 0], 2),
            ('Touching, and coming nearer.', [2, 0, 0], [-1, 0, 0], 0)):
        r.add_next(why, 'first_time_of_contact', {'a': cube, 'b': cube, 'offset': offset, 'velocity': velocity},
                   result(outcome='at', time=num(time)))
    for why, offset, velocity, how in (
            ('A graze of two faces.', [4, 2, 0], [-1, 0, 0], 'never'),
            ('A graze of two edges, which takes no time.', [4, 0, 0], [-1, 1, 0], 'never'),
            ('Away.', [3, 0, 0], [1, 0, 0], 'never'), ('Touching, at rest.', [2, 0, 0], [0, 0, 0], 'never'),
            ('One in the other.', [1, 0, 0], [1, 0, 0], 'inside')):
        r.add_next(why, 'first_time_of_contact', {'a': cube, 'b': cube, 'offset': offset, 'velocity': velocity},
                   result(outcome=how, time=None))
    return r


def response():
    r = Rule('Response')
    cube = cube_of(r)

    def bounce(why, offset, first, second, after, outcome='bounced'):
        r.add_next(why, 'response', {'touching': [{'a': cube, 'b': cube, 'offset': offset}], 'first': first,
                                     'second': second},
                   result(outcome=outcome, first={'velocity': nums(after[0])}, second={'velocity': nums(after[1])}))
    bounce('Equal masses exchange what is along the normal.', [2, 0, 0], {'mass': 1, 'velocity': [1, 2, 0]},
           {'mass': 1, 'velocity': [0, 0, 0]}, ((0, 2, 0), (1, 0, 0)))
    bounce('1 against 3: half back, half on.', [2, 0, 0], {'mass': 1, 'velocity': [1, 0, 0]},
           {'mass': 3, 'velocity': [0, 0, 0]}, (('-1/2', 0, 0), ('1/2', 0, 0)))
    bounce('A wall.', [0, 0, -2], {'mass': 7, 'velocity': [3, 0, -2]}, {'fixed': True}, ((3, 0, 2), (0, 0, 0)))
    bounce('Edge against edge: the cone of both normals holds the whole velocity.', [2, 2, 0], {'fixed': True},
           {'mass': 1, 'velocity': [-1, -2, 5]}, ((0, 0, 0), (1, 2, 5)))
    bounce('Nothing approaches.', [2, 0, 0], {'mass': 1, 'velocity': [0, 1, 0]}, {'mass': 1, 'velocity': [1, 0, 0]},
           ((0, 1, 0), (1, 0, 0)), 'persistent')
    r.add_next('Bodies that are apart have no response.', 'response', {
        'touching': [{'a': cube, 'b': cube, 'offset': [3, 0, 0]}], 'first': {'mass': 1, 'velocity': [1, 0, 0]},
        'second': {'fixed': True}}, {'error': {'code': -32008, 'data': {'relation': 'apart'}}})
    return r


def suites():
    return [def_4_1(), def_4_2(), def_4_3(), def_4_4(), mass(), contact(), touching_(), highest_(), def_4_5(), decomposed(),
            approach(), ftoc(), response()]
