"""By hand: exploration and properties (section 5 of the rule book)."""

from make_rules import (BIND, BOUNCE, CUBE, STRONG, TIME, WEAK, Rule, binds, bonded, bounces, cubes, dock, leaf, passes,
                        releases)
from rules_of_bodies import GRAVITY, LINE, REACT, RELEASE, behaviours
from cases import num, nums, result, unordered

# A cube between two walls: 4 to go each way, at 1; it is back after 8.
SHUTTLE = ('fixed l = Cube at translate (-4,0,0)\nfixed r = Cube at translate (4,0,0)\n'
           'process p = Cube mass 1 velocity (1,0,0) [nil]\n')


def graph():
    r = Rule('Graph')
    r.verdict('The end of a trajectory is a state: p is there, and nothing has happened yet.', cubes(),
              'EF (x(p) = 2 and vx(p) = 1 and EX vx(p) = 0)', 'holds')
    r.verdict('The state after it is another position of the same instant.', cubes(),
              'AG (event bounce(p, q) => x(p) = 2 and vx(p) = 0)', 'holds')
    r.verdict('Inside a trajectory nothing can happen: the bounce is next.', cubes(),
              'AG (x(p) > 0 and x(p) < 2 => AX event bounce(p, q))', 'holds')
    r.verdict('What is true in a state need not be so right after it.', cubes(),
              'EF (event bounce(p, q) and EX true)', 'violated')
    r.verdict('At the instant of the last state there is no other position after it.', cubes(),
              'EF (event bounce(p, q) and EF[0, 0] not event bounce(p, q))', 'violated')
    r.verdict('A position that is no state.', cubes(), 'EF[1, 1] x(p) = 1', 'holds')
    r.verdict('A trajectory that lasts for ever has all positions of it.', cubes(v='(-1,0,0)'), 'EF[1000, 1000] x(p) = -1000',
              'holds')
    return r


def state():
    r = Rule('State')
    r.verdict('A run that comes back is recognised.', SHUTTLE, 'AG AF x(p) = 0', 'holds')
    r.verdict('It never gets farther.', SHUTTLE, 'eventually x(p) = 3', 'violated')
    r.verdict('With all of the absolute time no state recurs.', SHUTTLE, 'always x(p) + time >= -3', 'holds-up-to-bound',
              {'states': 30})
    r.state('Where p is after 2.', SHUTTLE, [TIME], [leaf('p', position=nums((2, 0, 0))), leaf('l'), leaf('r')])
    return r


def jump():
    r = Rule('Jump')
    r.outcomes('Without a law there are no movement steps.', 'timestep 1/10\n' + cubes(), [], [passes(2)])
    r.outcomes('With a law there are.', 'timestep 1/10\n' + cubes(extra='motion p = (vx, vy, vz)\n'), [], [passes('1/10')])
    return r


def quiescent():
    r = Rule('Quiescent')
    r.outcomes('Apart, for ever.', cubes(v='(-1,0,0)'), [], [], 'quiescent')
    r.outcomes('An eps is to come.', cubes('eps(3). nil', v='(-1,0,0)'), [], [passes(3)])
    r.value('As a predicate.', cubes(v='(-1,0,0)'), [], 'quiescent', True)
    r.value('A collision is to come.', cubes(), [], 'quiescent', False)
    r.verdict('They go on for ever.', cubes(v='(-1,0,0)'), 'eventually x(p) < -1000000', 'holds')
    return r


PASSING = cubes(at='(4,0,0)', v='(1,0,0)', w='(0,1,0)')  # at time 2 an edge grazes an edge


def instants():
    r = Rule('Instants')
    r.verdict('Strictly between two events.', cubes(), 'possibly x(p) = 22/7 - 2', 'holds')
    r.verdict('Not farther than to the collision.', cubes(), 'possibly x(p) > 2', 'violated')
    r.verdict('A graze of a single instant.', PASSING, 'possibly touching(p, q)', 'holds')
    r.verdict('At no other one.', PASSING, 'always (touching(p, q) => x(p) = 2)', 'holds')
    r.verdict('A square of a distance: least at 2.', PASSING, 'always distance2(p, q) >= 8', 'holds')
    r.verdict('It is 8 there.', PASSING, 'possibly distance2(p, q) = 8', 'holds')
    r.verdict('At an irrational instant.', PASSING, 'possibly distance2(p, q) = 9', 'holds')
    r.verdict('A bound that is just met, and passed.', cubes(v='(-1,0,0)'), 'always x(p) >= -3 within 3', 'holds')
    r.verdict('And passed.', cubes(v='(-1,0,0)'), 'always x(p) > -3 within 3', 'violated')
    return r


# As in specs/models/window.sc: q catches y without p having caught x iff they part later than 5/4 and by 3/2.
WINDOW = 'split_step %s\n' + behaviours(
    One='omega(hold, {right}). eps(1). <above, {top}>. nil', Other='omega(hold, {left}). eps(2). <below, {bottom}>. nil',
    Falling='<~above, {bottom}>. nil', Rising='<~below, {top}>. nil') + (
        'process pair = p : Cube mass 1 at translate (-1,0,0) [One] <hold, {p.right, q.left}> '
        'q : Cube mass 1 at translate (1,0,0) [Other]\n'
        'process x = Cube scaled (1/2,1/2,1/2) mass 1 velocity (0,0,-1) at translate (-1,0,15/4) [Falling]\n'
        'process y = Cube scaled (1/2,1/2,1/2) mass 1 velocity (0,0,1) at translate (1,0,-5) [Rising]\n')
WINDOW_KEPT = 'always (bound(q, y) => bound(p, x)) within 4'


def verdict():
    r = Rule('Verdict')
    r.verdict('Holds.', dock(), 'eventually bound(p, q)', 'holds')
    r.verdict('Violated.', dock(), 'always not bound(p, q)', 'violated')
    r.verdict('A window between two split instants is not seen.', WINDOW % '1', WINDOW_KEPT, 'holds')
    r.verdict('On a finer grid it is.', WINDOW % '1/4', WINDOW_KEPT, 'violated')
    r.verdict('Undecided: a division by zero.', dock(), 'eventually 1/vy(p) > 0', 'undecided')
    r.verdict('Not where the answer does not depend on it.', dock(), 'eventually (bound(p, q) or 1/vy(p) > 0)', 'holds')
    r.value('No value.', dock(), [], '1/vy(p) > 0', None)
    r.value('False, as one side is.', dock(), [], '1/vy(p) > 0 and vx(p) = 0', False)
    r.value('True, as one side is.', dock(), [], '1/vy(p) > 0 or vx(p) = 1', True)
    r.verdict('What a property bounds by itself is a proof.', SHUTTLE, 'always x(p) <= 2 within 100', 'holds')
    r.verdict('Nothing found up to a bound that is no proof.', SHUTTLE, 'always (time < 1000000)', 'holds-up-to-bound',
              {'states': 20})
    return r


PINCH = ('fixed l = Cube at translate (-2,0,0)\nfixed r = Cube at translate (2,0,0)\n'
         'process p = Cube mass 1 velocity (1,0,0) at translate (0,%s,0) [nil]\n')


def zeno():
    r = Rule('Zeno')
    wedged = PINCH % 0
    r.outcomes('Wedged between two walls: it hits one.', wedged, [], [bounces('p', 'r')])
    r.outcomes('Then the other, at once.', wedged, [BOUNCE], [bounces('p', 'l')])
    r.verdict('It never gets anywhere: what must happen does not.', wedged, 'eventually y(p) = 1', 'violated')
    r.verdict('What never happens does not.', wedged, 'possibly x(p) = 1', 'violated')
    r.verdict('What always holds does.', wedged, 'always x(p) = 0', 'holds')
    return r


def run():
    r = Rule('Run')
    wedged = PINCH % 0
    r.verdict('A run that goes round within one instant is a run.', wedged, 'EG true', 'holds')
    r.verdict('It never ends: there is always a next event.', wedged, 'AG EX true', 'holds')
    r.verdict('On every run a collision with l comes again and again.', wedged, 'AG AF event bounce(p, l)', 'holds')
    r.verdict('What should come on it does not, within any time.', wedged, 'AF[<= 1] x(p) = 1', 'violated')
    r.verdict('Time 1 never comes: no run has a position then.', wedged, 'EF[1, 2] true', 'violated')
    r.verdict('And so everything is true from time 1 on.', wedged, 'AG[1, 2] false', 'holds')
    r.verdict('At rest a run goes on for ever.', cubes(at='(40,0,0)', v='(0,0,0)'), 'EF[1000, 1000] true', 'holds')
    r.verdict('There is no next event.', cubes(at='(40,0,0)', v='(0,0,0)'), 'EX true', 'violated')
    return r


def dead_end():
    from rules_of_turning import GIVEN_UP, ON_TIP
    r = Rule('DeadEnd')
    r.add_next('No transition and no time: the model is given up there.', 'successors', {'model': r.model(ON_TIP)}, GIVEN_UP)
    r.verdict('No next event is any.', ON_TIP, 'AX false', 'holds')
    r.verdict('There is none.', ON_TIP, 'EX true', 'violated')
    r.verdict('What was left.', ON_TIP, 'AG z(p) = 1', 'holds')
    r.verdict('On some run, which is the only one.', ON_TIP, 'EG z(p) = 1', 'holds')
    r.verdict('What should still come does not.', ON_TIP, 'AF z(p) > 1', 'violated')
    r.verdict('Nor can it.', ON_TIP, 'EF z(p) > 1', 'violated')
    r.verdict('g is there already.', ON_TIP, 'A[z(p) = 0 U z(p) = 1]', 'holds')
    r.verdict('f for ever is not f until g.', ON_TIP, 'E[z(p) = 1 U z(p) > 1]', 'violated')
    r.verdict('Time 1 never comes.', ON_TIP, 'EF[1, 1] true', 'violated')
    r.verdict('So that all holds from then on.', ON_TIP, 'AG[1, 1] false', 'holds')
    return r


def event():
    r = Rule('Event')
    r.value('Right after it.', dock(), [TIME, BIND], 'event bind(dock)', True)
    r.value('With its ends, in either order.', dock(), [TIME, BIND], 'event bind(dock, q, p)', True)
    r.value('Not before.', dock(), [TIME], 'event bind(dock)', False)
    r.value('Not at the start.', dock(), [], 'event bind', False)
    r.value('Another name.', dock() + 'process s = Cube mass 1 at translate (0,40,0) [<port, {top}>. nil]\n',
            [TIME, BIND], 'event bind(port)', False)
    r.value('A bounce is one of all leaves.', cubes(), [TIME, BOUNCE], 'event bounce(p, q) and event bounce(q)', True)
    r.value('A weak split is a split.', bonded(RELEASE, 'K', 'L'), [WEAK], 'event split(dock) and event weak', True)
    r.value('And no strong one.', bonded(RELEASE, 'K', 'L'), [WEAK], 'event strong', False)
    r.value('A strong split is one.', bonded(REACT, 'K', 'L'), [STRONG], 'event split(dock) and event strong(dock, p, q)', True)
    r.verdict('Events of one instant follow each other.', LINE % ('nil', 'nil', 'nil'),
              'possibly (event bounce(p) and event bounce(r))', 'violated')
    r.verdict('An event is no stretch of time.', dock(), 'EF EG event bind', 'violated')
    return r


def leads_to():
    r = Rule('LeadsTo')
    r.verdict('Touching leads to being bound.', dock(), 'touching(p, q) leads_to bound(p, q)', 'holds')
    r.verdict('At once.', dock(), 'touching(p, q) leads_to bound(p, q) within 0', 'holds')
    r.verdict('g may hold where f does.', dock(), 'bound(p, q) leads_to bound(p, q)', 'holds')
    r.verdict('From the start it takes 2.', dock(), 'x(p) = 0 leads_to bound(p, q) within 2', 'holds')
    r.verdict('Not less.', dock(), 'x(p) = 0 leads_to bound(p, q) within 19/10', 'violated')
    r.verdict('With an interval.', dock(), 'x(p) = 0 leads_to[2, 2] event bind', 'holds')
    r.verdict('A weak split may be put off for ever.', bonded(RELEASE, 'K', 'L'), 'bound(p, q) leads_to not bound(p, q)',
              'violated')
    return r


def next_():
    r = Rule('Next')
    r.verdict('The next discrete transition, after any time.', dock(), 'EX event bind', 'holds')
    r.verdict('All of them.', dock(), 'AX bound(p, q)', 'holds')
    r.verdict('After it nothing is to come: AX of anything.', dock(), 'AX AX false', 'holds')
    r.verdict('And EX of nothing.', dock(), 'AX EX true', 'violated')
    r.verdict('Not the passing of time.', dock(), 'EX not bound(p, q)', 'violated')
    return r


def until():
    r = Rule('Until')
    r.verdict('Not bound until they touch, and bound.', dock(), 'A[ not bound(p, q) U touching(p, q) ]', 'holds')
    r.verdict('f need not hold where g does.', dock(), 'A[ x(p) < 2 U x(p) = 2 ]', 'holds')
    r.verdict('An open interval has no first instant: x(p) < 2 up to 2, but g holds after it only.', cubes(v='(1,0,0)',
              at='(40,0,0)'), 'E[ x(p) < 2 U x(p) > 2 ]', 'violated')
    r.verdict('With its end it is no better: inside the interval there is always an earlier instant.',
              cubes(v='(1,0,0)', at='(40,0,0)'), 'A[ x(p) <= 2 U x(p) > 2 ]', 'violated')
    r.verdict('f holds where the interval begins, and a little longer.', cubes(v='(1,0,0)', at='(40,0,0)'),
              'A[ x(p) <= 3 U x(p) > 2 ]', 'holds')
    r.verdict('It begins in a state, where f holds, and f goes on to hold.', cubes(v='(1,0,0)', at='(40,0,0)'),
              'E[ x(p) >= 0 U x(p) > 0 ]', 'holds')
    r.verdict('f holds in that state alone.', cubes(v='(1,0,0)', at='(40,0,0)'), 'E[ x(p) = 0 U x(p) > 0 ]', 'violated')
    r.verdict('For a run that begins inside, g is enough.', cubes(v='(1,0,0)', at='(40,0,0)'),
              'AG (x(p) > 0 => A[ false U x(p) > 0 ])', 'holds')
    r.verdict('g never.', dock(), 'E[ true U x(p) > 1000000 and not bound(p, q) ]', 'violated')
    r.verdict('On some run the bond stays.', bonded(RELEASE, 'K', 'L'), 'EG bound(p, q)', 'holds')
    r.verdict('On some it does not.', bonded(RELEASE, 'K', 'L'), 'AG bound(p, q)', 'violated')
    r.verdict('A run that comes to rest stays there.', cubes(v='(0,0,0)'), 'AG (x(p) = 0 and EG x(q) = 4)', 'holds')
    return r


def intervals():
    r = Rule('Intervals')
    r.verdict('At 2, not before.', dock(), 'AF[2, 2] bound(p, q)', 'holds')
    r.verdict('Before 2.', dock(), 'EF[0, 19/10] bound(p, q)', 'violated')
    r.verdict('Both ends are included.', dock(), 'EF[0, 2] bound(p, q)', 'holds')
    r.verdict('Throughout.', dock(), 'AG[0, 1] x(p) <= 1', 'holds')
    r.verdict('A little longer.', dock(), 'AG[0, 1001/1000] x(p) <= 1', 'violated')
    r.verdict('At exactly 1.', dock(), 'AF[1, 1] x(p) = 1', 'holds')
    r.verdict('A run goes on for ever after its last event.', dock(), 'AF[100, 100] x(p) = 51', 'holds')
    r.verdict('Until, within an interval.', dock(), 'A[ not bound(p, q) U[1, 3] bound(p, q) ]', 'holds')
    return r


def truncated():
    r = Rule('Truncated')
    few = {'states': 3}
    r.verdict('Reached within the bound.', SHUTTLE, 'EF x(p) = 2', 'holds', {'states': 3})
    r.verdict('Not decided without the rest.', 'param n = 1000000\n' + SHUTTLE, 'EF (time > n)', 'undecided', few)
    r.verdict('Nor for all runs.', SHUTTLE, 'AF (time > 1000000)', 'undecided', few)
    r.verdict('Nor what would fail.', SHUTTLE, 'AG EF x(p) > 2', 'undecided', few)
    return r


RING = 'for i in 1..3 { process c[i] = Cube mass 1 velocity (0,0,%s) at translate (4*i, 0, 0) [%s] }\n'
BLINK = behaviours(On='eps(1). Off', Off='eps(1). On')


def symmetry():
    r = Rule('Symmetry')
    two = ('for i in 1..2 { process c[i] = Cube mass 1 velocity (3 - 2*i,0,0) at translate (8*i, 0, 0) [nil] }\n'
           'fixed l = Cube at translate (2,0,0)\nfixed r = Cube at translate (22,0,0)\n')
    r.verdict('Bodies that may be exchanged: some of them.', two, 'possibly exists p in c: x(p) = 4', 'holds')
    r.verdict('A name tells them apart.', two, 'possibly x(c[2]) = 4', 'violated')
    r.verdict('So it does here.', two, 'possibly x(c[1]) = 4', 'holds')
    ring = ('fixed w = Cube scaled (1,5,1) at translate (-7,0,0)\nfixed e = Cube scaled (1,5,1) at translate (7,0,0)\n'
            'fixed s = Cube scaled (5,1,1) at translate (0,-7,0)\nfixed n = Cube scaled (5,1,1) at translate (0,7,0)\n'
            'process c[1] = Cube mass 1 velocity (1,-1,0) at translate (-1,-4,0) [nil]\n'
            'process c[2] = Cube mass 1 velocity (-1,1,0) at translate (1,4,0) [nil]\n')
    r.verdict('Both go round, and come to the east, each after half a round of the other.', ring,
              '(possibly x(c[1]) = 5) and (possibly x(c[2]) = 5)', 'holds')
    r.verdict('None stays away from it.', ring, '(always x(c[1]) < 5) or (always x(c[2]) < 5)', 'violated')
    r.verdict('All of them.', two, 'always forall p in c: x(p) >= 4', 'holds')
    return r


def translation():
    r = Rule('Translation')
    raft = BLINK + 'process p = Cube mass 1 velocity (1,0,0) [On]\n'
    r.verdict('A body that drifts and blinks: its states recur but for where it is.', raft, 'AG AF behaviour(p) = Off',
              'holds')
    r.verdict('Velocities may be spoken of.', raft, 'AG (vx(p) = 1 and EF behaviour(p) = On)', 'holds')
    r.verdict('Places tell the states apart: it is there within 20, and not before.', raft, 'eventually x(p) = 20 within 20',
              'holds')
    return r


def order():
    r = Rule('Order')
    many = ''.join('process p%d = Cube mass 1 velocity (1,0,0) at translate (0,%d,0) [nil]\n'
                   'process q%d = Cube mass 1 at translate (4,%d,0) [nil]\n' % (i, 10 * i, i, 10 * i) for i in range(5))
    r.verdict('Five collisions of one instant.', many, 'possibly vx(q0) = 1 and vx(q4) = 1', 'holds')
    r.verdict('Each takes place.', many, 'always vx(p3) = 1 within 1', 'holds')
    r.verdict('None is put off.', many, 'eventually vx(q2) = 1 within 2', 'holds')
    r.verdict('One may be the last.', many, 'possibly (vx(q0) = 0 and vx(q1) = 1 and vx(q2) = 1 and vx(q3) = 1 and vx(q4) = 1)',
              'holds')
    return r


def joined_draws():
    r = Rule('JoinedDraws')
    two = ''.join('process %s = Cube mass 1 at translate (0,%d,0) [nil]\nmotion %s = choose { (1,0,0), (-1,0,0) weight 2 }\n'
                  % (n, 10 * i, n) for i, n in enumerate('pq')) + 'timestep 1 steady\n'
    both = 'x(p) > 0 and x(q) > 0'
    r.measured('Each draws for itself: (1/3)^2.', two, 'P = ? [ eventually %s within 1/2 ]' % both, least='1/9', greatest='1/9')
    r.measured('One of the two: 1 - (2/3)^2.', two, 'P = ? [ eventually (x(p) > 0 or x(q) > 0) within 1/2 ]',
               least='5/9', greatest='5/9')
    r.verdict('Between the draws it is known that p goes to the right, and not where q goes.', two,
              'EF[0, 0] (P >= 1 [ eventually x(p) > 0 within 1/2 ] and EF[0, 1/2] x(q) > 0 and EF[0, 1/2] x(q) < 0)', 'holds')
    r.verdict('After one transition both still rest.', two, 'EX energy = 0', 'holds')
    return r


def isometry():
    r = Rule('Isometry')
    row = ('timestep 2 steady\nblocked wait\nfixed west = Cube at translate (-4,0,0)\nfixed east = Cube at translate (4,0,0)\n'
           'process w = Cube mass 1 at translate (-2,0,0) [nil]\nmotion w = choose { (1,0,0), (-1,0,0)%s }\n')
    even, uneven = row % '', row % ' weight 3'
    r.measured('With 1/2 it stays at the wall.', even, 'P = ? [ eventually x(w) = 0 within 4 ]', least='3/4', greatest='3/4')
    r.measured('Each end is as far from the middle: two steps.', even, 'E = ? [ time U x(w) = 0 ]', least='4', greatest='4')
    r.measured('The other end is none of both: six steps.', even, 'E = ? [ time U x(w) = 2 ]', least='12', greatest='12')
    r.measured('To the left is not to the right: four steps.', uneven, 'E = ? [ time U x(w) = 0 ]', least='8', greatest='8')
    r.measured('20 steps.', uneven, 'E = ? [ time U x(w) = 2 ]', least='40', greatest='40')
    return r


def slice_():
    r = Rule('Slice')
    far = cubes() + ''.join('process f%d = Cube mass 1 velocity (1,0,0) at translate (%d,1000,0) [nil]\n' % (i, 5 * i)
                            for i in range(6)) + 'process g = Cube mass 1 velocity (-1,0,0) at translate (60,1000,0) [nil]\n'
    r.verdict('Who is far away has no influence.', far, 'possibly event bounce(p, q)', 'holds')
    r.verdict('Nor later.', far, 'always x(p) <= 2 within 100', 'holds')
    r.verdict('The far ones collide.', far, 'possibly vx(f0) < 1', 'holds')
    return r


def absolute_time():
    r = Rule('AbsoluteTime')
    r.verdict('There is a time before which it is not there.', SHUTTLE, 'always (time < 2 => x(p) < 2)', 'holds')
    r.verdict('Up to a constant: states recur after it.', SHUTTLE, 'AG (time > 5 => AF x(p) = 0)', 'holds', {'states': 30})
    r.verdict('Which is in the middle of a passing.', SHUTTLE, 'possibly (time = 3 and x(p) = 1)', 'holds')
    r.verdict('And right after it.', SHUTTLE, 'possibly (time > 13 and 2 * time < 27 and x(p) > 0)', 'violated',
              {'states': 30})
    r.verdict('A multiple of time.', SHUTTLE, 'EF (2 * time - 1 >= 9 and AG x(p) < 2)', 'violated', {'states': 30})
    r.verdict('With what changes.', SHUTTLE, 'possibly x(p) + time = 8', 'holds')
    r.verdict('With what stays within bounds: there is one process.', SHUTTLE, 'AG (time > 5 * processes => AF x(p) = 0)',
              'holds', {'states': 30})
    r.verdict('With one of two constants.', SHUTTLE, 'AG (time > (if x(p) < 1 then 3 else 5) => AF x(p) = 0)', 'holds',
              {'states': 30})
    r.measured('The mean of the time is the time.', SHUTTLE, 'E = ? [ time at 3 ]', least=3, greatest=3)
    return r


def settling():
    r = Rule('Settling')
    walk = ('timestep 1 steady\nprocess w = Cube mass 1 [nil]\n'
            'motion w = choose { (1,0,0) weight 1, (-1,0,0) weight 1 }\n')
    few = {'states': 60}
    r.verdict('A walk has no end, and is over for what asks for a time before 2.', walk,
              'possibly (x(w) > 2 and time <= 2)', 'violated', few)
    r.verdict('So it is with what holds after a time.', walk, 'always (time > 2 or x(w) <= 2)', 'holds', few)
    r.verdict('For all runs.', walk, 'AF (time > 2 or x(w) = 1 and time = 1)', 'holds', few)
    r.verdict('For some run, and a left side that ends.', walk, 'E[time < 1 U x(w) > 1]', 'violated', few)
    r.verdict('One operator within another.', walk, 'AG (time >= 1 or EF (x(w) = 0 and time <= 2))', 'holds', few)
    r.verdict('What is next.', walk, 'EF[<= 1] EX x(w) = 1', 'holds', few)
    r.measured('Both steps lead up.', walk, 'P = ? [ eventually (x(w) > 1 and time <= 2) ]', few, least='1/4', greatest='1/4')
    r.measured('It is there right after 1, or time 2 has passed.', walk, 'E = ? [ time U time > 2 or x(w) > 1 ]', few,
               least='7/4', greatest='7/4')
    return r


def drift():
    r = Rule('Drift')
    two = (BLINK + 'process p = Cube mass 1 velocity (-1,0,0) [On]\n'
           'process q = Cube mass 1 velocity (1,0,0) at translate (6,0,0) [On]\n')
    r.verdict('Two fly apart and blink: their states recur but for how far they are from each other.', two,
              'AG AF (behaviour(p) = Off and behaviour(q) = Off)', 'holds', {'states': 30})
    r.verdict('A distance counts up to a constant.', two, 'AG (distance2(p, q) > 400 => AF behaviour(p) = Off)', 'holds',
              {'states': 60})
    r.verdict('And is passed.', two, 'eventually distance2(p, q) > 400', 'holds', {'states': 60})
    r.verdict('A place counts up to one.', two, 'AG (x(q) > 10 => AG x(q) > 10)', 'holds', {'states': 60})
    r.verdict('They never touch.', two, 'AG not touching(p, q)', 'holds', {'states': 30})
    caught = (BLINK + 'process p = Cube mass 2 velocity (1,0,0) [nil]\nprocess q = Cube mass 1 at translate (6,0,0) [nil]\n'
              'process r = Cube mass 1 velocity (%s,0,0) at translate (12,0,0) [On]\n')
    r.verdict('Who is hit goes on at 4/3, and catches whom nobody followed.', caught % '6/5', 'eventually touching(q, r)',
              'holds')
    r.verdict('But nobody who is faster.', caught % '3/2', 'AG (not touching(q, r) and AF behaviour(r) = Off)', 'holds',
              {'states': 60})
    thrown = ('split_step 1\n' + behaviours(Hold='omega(b, {left, right}) push(1). nil')
              + 'process d = p : Cube mass 1 [Hold] <b, {p.right, q.left}> q : Cube mass 1 at translate (2,0,0) [Hold]\n'
              'process r = Cube mass 1 velocity (1,0,0) at translate (6,0,0) [nil]\n')
    r.verdict('Who is pushed off may catch it too, however late.', thrown, 'possibly (touching(q, r) and time > 12)', 'holds')
    return r


def suites():
    return [f() for f in (graph, state, jump, quiescent, instants, verdict, zeno, run, dead_end, event, leads_to, next_, until, intervals,
                          truncated, symmetry, translation, order, joined_draws, isometry, slice_, absolute_time, settling,
                          drift)]
