"""By hand: behaviours, processes and networks (sections 2 and 3 of the rule book)."""

from make_rules import (ABSORB, BIND, BOUNCE, CLOSE, STRONG, TIME, WEAK, Rule, absorbs, binds, bonded, bounces, closes, cubes, dock, leaf,
                        passes, reacts, releases)
from cases import num, nums, result, unordered

ON = 'behaviour %s on Cube = %s\n'


def behaviours(**definitions):
    return ''.join(ON % (name, text) for name, text in definitions.items())


def def_5_1():
    r = Rule('Def-5.1')
    alone = 'process p = Cube mass 1 [K]\n'
    r.refused('A name that reaches itself at once.', behaviours(K='K + nil') + alone, 'SC0501')
    r.refused('A delay of 0 guards nothing.', behaviours(K='eps(0). K') + alone, 'SC0501')
    r.refused('Two names that reach each other at once.', behaviours(K='L', L='<a, {top}>. nil + K') + alone, 'SC0501')
    r.refused('A channel without features.', behaviours(K='<a, {}>. nil') + alone, 'SC0503')
    r.refused('A negative delay.', behaviours(K='eps(-1). nil') + alone, 'SC0502')
    r.value('A positive delay guards.', behaviours(K='eps(1). K') + alone, [], 'behaviour(p) = K', True)
    return r


def pre():
    r = Rule('Pre')
    r.outcomes('The two channels meet at time 2.', dock(), [], [passes(2)])
    r.outcomes('They bind, and nothing else is possible.', dock(), [TIME], [binds('dock', 'p.right', 'q.left')])
    r.value('What follows the prefix is left.', dock(), [TIME, BIND], 'behaviour(p) = Bound and behaviour(q) = Bound', True)
    r.value('The channel was on offer.', dock(), [TIME], 'offers(p, dock) and offers(q, ~dock)', True)
    r.value('It is not any more.', dock(), [TIME, BIND], 'offers(p, dock) or offers(q, ~dock)', False)
    r.outcomes('Two equal names do not bind.', dock().replace('~', ''), [TIME], [bounces('p', 'q')])
    return r


RELEASE = behaviours(K='omega(dock, {right}). Gone', L='omega(dock, {left}). Gone', Gone='nil')
REACT = behaviours(K='rho({<dock, {right}>}). Gone', L='rho({<dock, {left}>}). Gone', Gone='nil')


def weak():
    r = Rule('Weak')
    r.outcomes('Both offer it; time may pass as well.', bonded(RELEASE, 'K', 'L'), [],
               [releases('dock', 'p.right', 'q.left'), passes(1)])
    r.value('Both have gone on.', bonded(RELEASE, 'K', 'L'), [WEAK], 'behaviour(p) = Gone and behaviour(q) = Gone', True)
    return r


def strong():
    r = Rule('Strong')
    r.outcomes('It is urgent.', bonded(REACT, 'K', 'L'), [], [reacts(('dock', 'p.right', 'q.left'))])
    r.value('Both have gone on.', bonded(REACT, 'K', 'L'), [STRONG], 'behaviour(p) = Gone and behaviour(q) = Gone', True)
    return r


def sum_():
    r = Rule('Sum')
    choice = behaviours(K='<a, {right}>. One + <b, {right}>. Two', L='<~b, {left}>. nil', M='<~a, {left}>. nil + <~b, {left}>. nil',
                        One='nil', Two='nil')
    r.outcomes('One of two summands has a partner.', cubes('K', 'L', choice), [TIME], [binds('b', 'p.right', 'q.left')])
    r.value('The other summand is gone.', cubes('K', 'L', choice), [TIME, BIND], 'behaviour(p) = Two and not offers(p, a)', True)
    r.outcomes('Both have one.', cubes('K', 'M', choice), [TIME],
               [binds('a', 'p.right', 'q.left'), binds('b', 'p.right', 'q.left')])
    return r


def def_():
    r = Rule('Def')
    names = behaviours(K='L', L='<dock, {right}>. Done', Shut='<~dock, {left}>. nil', Done='nil')
    r.outcomes('A name of a name.', cubes('K', 'Shut', names), [TIME], [binds('dock', 'p.right', 'q.left')])
    r.value('It goes on as what it stands for does.', cubes('K', 'Shut', names), [TIME, BIND], 'behaviour(p) = Done', True)
    r.value('Until then it is itself.', cubes('K', 'Shut', names), [TIME], 'behaviour(p) = K', True)
    return r


def eps0():
    r = Rule('Eps0')
    text = behaviours(Done='nil', Shut='eps(0). <~dock, {left}>. nil')
    r.value('What is behind it is on offer.', cubes('eps(0). <dock, {right}>. Done', 'Shut', text), [],
            'offers(p, dock) and offers(q, ~dock)', True)
    r.outcomes('And binds.', cubes('eps(0). eps(0). <dock, {right}>. Done', 'Shut', text), [TIME],
               [binds('dock', 'p.right', 'q.left')])
    named = behaviours(K='eps(0). Z', Far='K', Z='<dock, {right}>. K', Shut='<~dock, {left}>. nil', Other='Z')
    for note, body in [('A name that it brings up is the origin at once,', 'K'), ('also through another name,', 'Far'),
                       ('and after one more of them.', 'eps(0). K')]:
        r.value(note, cubes(body, 'Shut', named), [], 'behaviour(p) = Z and not (behaviour(p) = K or behaviour(p) = Far)', True)
    r.value('So it is where a prefix goes on to it.', cubes('K', 'Shut', named), [TIME, BIND], 'behaviour(p) = Z', True)
    r.value('Without it a name for a name is the origin.', cubes('Other', 'Shut', named), [], 'behaviour(p) = Other', True)
    return r


def time_behaviour():
    r = Rule('TimeBehaviour')
    text = behaviours(Shut='<~dock, {left}>. nil', Done='nil')

    def waits(t):
        return cubes('eps(%s). <dock, {right}>. Done' % t, 'Shut', text)
    r.outcomes('It is over before the other comes.', waits(1), [], [passes(1)])
    r.outcomes('Then the rest of the way.', waits(1), [TIME], [passes(1)])
    r.outcomes('And they bind.', waits(1), [TIME, TIME], [binds('dock', 'p.right', 'q.left')])
    r.outcomes('It is over just in time.', waits(2), [TIME], [binds('dock', 'p.right', 'q.left')])
    r.outcomes('It comes too late.', waits('5/2'), [TIME], [bounces('p', 'q')])
    both = cubes('eps(1). <a, {top}>. nil + eps(3/2). <b, {top}>. nil', '', text, at='(40,0,0)', v='(0,0,0)')
    r.outcomes('Both sides of a sum age: the first after 1.', both, [], [passes(1)])
    r.outcomes('The second after 1/2 more.', both, [TIME], [passes('1/2')])
    r.value('Time decides no choice: both are on offer.', both, [TIME, TIME], 'offers(p, a) and offers(p, b)', True)
    r.outcomes('Nothing is left to come.', both, [TIME, TIME], [], 'quiescent')
    nested = cubes('eps(1). eps(1/2). <a, {top}>. nil', '', text, at='(40,0,0)', v='(0,0,0)')
    r.outcomes('One after the other.', nested, [TIME], [passes('1/2')])
    return r


CHAIN = behaviours(N='nil')
THREE = ('process r = %s\n')


def def_5_2():
    r = Rule('Def-5.2')
    one, two, three = ('s1 : Cube mass 1 [N]', 's2 : Cube mass 1 at translate (2,0,0) [N]',
                       's3 : Cube mass 1 at translate (4,0,0) [N]')
    left = CHAIN + THREE % ('(%s <a, {s1.right, s2.left}> %s) <b, {s2.right, s3.left}> %s' % (one, two, three))
    right = CHAIN + THREE % ('%s <a, {s1.right, s2.left}> (%s <b, {s2.right, s3.left}> %s)' % (one, two, three))
    for text in (left, right):
        r.value('Three leaves, one process.', text, [], 'size(s1) = 3 and same(s1, s3) and processes = 1', True)
        r.state('Two bonds, however they are put together.', text, [], [{'bonds': unordered([
            {'name': 'a', 'ends': unordered(['s1.right', 's2.left'])},
            {'name': 'b', 'ends': unordered(['s2.right', 's3.left'])}])}])
    r.outcomes('An empty network: nothing ever happens.', 'network nil\n', [], [], 'quiescent')
    return r


def well_formed():
    r = Rule('WellFormed')
    r.refused('Bodies that interpenetrate.', cubes(at='(1,0,0)'), 'SC0403')
    r.value('Bodies that touch.', cubes(at='(2,0,0)', v='(0,0,0)'), [], 'touching(p, q)', True)
    r.refused('A channel on a feature of another shape.', behaviours(K='<a, {lid}>. nil') + cubes('K'), 'SC0203')
    r.refused('Bound bodies of different velocities.', cubes(at='(2,0,0)') + 'bond <a, {p.right, q.left}>\n', 'SC0404')
    r.verdict('Momentum is kept by a bond.', dock(mass=(1, 3)), 'always momentum.x = 1', 'holds')
    r.verdict('Energy is kept by a bounce.', cubes(mass=(1, 3)), 'always energy = 1/2', 'holds')
    r.verdict('A bond takes some of it: 1/2 becomes 1/8.', dock(mass=(1, 3)),
              'always (bound(p, q) => energy = 1/8)', 'holds')
    return r


def weak_split():
    r = Rule('WeakSplit')
    r.outcomes('One of two offers it: nothing ever happens.', bonded(RELEASE, 'K', 'nil'), [], [], 'quiescent')
    r.outcomes('Another name.', bonded(RELEASE.replace('dock', 'port'), 'K', 'L'), [], [], 'quiescent')
    other = behaviours(K='omega(dock, {left}). nil', L='omega(dock, {left}). nil')
    r.outcomes('The end of the bond is not in the closure.', bonded(other, 'K', 'L'), [], [], 'quiescent')
    lower = bonded(RELEASE, 'K', 'L', bond='bond <dock, {p.[b,c], q.[a,d]}>\n')
    r.outcomes('A bond of edges, in the closures of the faces.', lower, [],
               [releases('dock', 'p.[b,c]', 'q.[a,d]'), passes(1)])
    r.value('It falls into two.', bonded(RELEASE, 'K', 'L'), [WEAK], 'processes', 2)
    r.verdict('It never has to happen.', bonded(RELEASE, 'K', 'L'), 'eventually not bound(p, q)', 'violated')
    r.verdict('It may.', bonded(RELEASE, 'K', 'L'), 'possibly not bound(p, q)', 'holds')
    r.named(bonded(RELEASE, 'K', 'L'), [], WEAK, 'WeakSplit')
    return r


TRIPLE = ('process p = Cube mass 1 [%s]\nprocess q = Cube mass 1 at translate (2,0,0) [%s]\n'
          'process r = Cube mass 1 at translate (4,0,0) [%s]\n'
          'bond <a, {p.right, q.left}>\nbond <b, {q.right, r.left}>\n')


def strong_split():
    r = Rule('StrongSplit')
    both = behaviours(P='rho({<a, {right}>}). nil', Q='rho({<a, {left}>, <b, {right}>}). Done', R='rho({<b, {left}>}). nil',
                      Done='nil', One='rho({<a, {left}>}). nil + rho({<b, {right}>}). nil')
    bonds = (('a', 'p.right', 'q.left'), ('b', 'q.right', 'r.left'))
    r.outcomes('Two bonds that hang together react as one.', both + TRIPLE % ('P', 'Q', 'R'), [], [reacts(*bonds)])
    r.value('All three are free.', both + TRIPLE % ('P', 'Q', 'R'), [STRONG], 'processes = 3 and behaviour(q) = Done', True)
    r.outcomes('Each entry needs a bond of its own: r is not ready.', both + TRIPLE % ('P', 'Q', 'nil'), [], [], 'quiescent')
    r.outcomes('Either of two, each by itself.', both + TRIPLE % ('P', 'One', 'R'), [],
               [reacts(bonds[0]), reacts(bonds[1])])
    r.verdict('It is urgent: no time passes before it.', both + TRIPLE % ('P', 'Q', 'R'),
              'eventually processes = 3 within 0', 'holds')
    r.named(bonded(REACT, 'K', 'L'), [], STRONG, 'StrongSplit')
    return r


LINE = ('process p = Cube mass 1 velocity (1,0,0) [%s]\nprocess q = Cube mass 1 at translate (4,0,0) [%s]\n'
        'process r = Cube mass 1 velocity (-1,0,0) at translate (8,0,0) [%s]\n')


def collision():
    r = Rule('Collision')
    apart = cubes() + 'process r = Cube mass 1 velocity (1,0,0) at translate (0,10,0) [nil]\n' \
        'process s = Cube mass 1 at translate (4,10,0) [nil]\n'
    r.outcomes('Two collisions at one instant, in either order.', apart, [TIME], [bounces('p', 'q'), bounces('r', 's')])
    r.outcomes('The other one is left.', apart, [TIME, bounces('r', 's')], [bounces('p', 'q')])
    r.outcomes('From both sides.', LINE % ('nil', 'nil', 'nil'), [TIME], [bounces('p', 'q'), bounces('q', 'r')])
    r.outcomes('After the first, q moves towards r: they collide still.', LINE % ('nil', 'nil', 'nil'),
               [TIME, bounces('p', 'q')], [bounces('q', 'r')])
    r.outcomes('And then q towards p again.', LINE % ('nil', 'nil', 'nil'), [TIME, bounces('p', 'q'), bounces('q', 'r')],
               [bounces('p', 'q')])
    r.outcomes('Until all go apart.', LINE % ('nil', 'nil', 'nil'),
               [TIME, bounces('p', 'q'), bounces('q', 'r'), bounces('p', 'q')], [], 'quiescent')
    return r


def bind():
    r = Rule('Bind')
    r.value('The whole moves with the momentum of both.', dock(mass=(1, 3)), [TIME, BIND], 'vx(p) = 1/4 and vx(q) = 1/4', True)
    fixed = dock().replace('process q = Cube mass 1 velocity (0,0,0)', 'fixed q = Cube')
    r.value('What binds to a fixed body stops.', fixed, [TIME, BIND], 'vx(p)', 0)
    two = behaviours(K='<a, {right}>. One + <a, {top, right}>. Two', L='<~a, {left}>. nil', One='nil', Two='nil')
    r.outcomes('Two summands, one transition each; their labels are alike.', cubes('K', 'L', two), [TIME],
               [binds('a', 'p.right', 'q.left')] * 2)
    lower = behaviours(K='<a, {[b,c], [f,g]}>. nil', L='<~a, {left}>. nil')
    r.outcomes('Of the highest dimension among the pairs that are open: two edges against the face.', cubes('K', 'L', lower),
               [TIME], [binds('a', 'p.[b,c]', 'q.[a,d]'), binds('a', 'p.[f,g]', 'q.[e,h]')])
    r.outcomes('Shifted, the edges lie inside the face.', cubes('K', 'L', lower, at='(4,0,1)'), [TIME],
               [binds('a', 'p.[f,g]', 'q.left')])
    r.outcomes('No candidate with a face that does not touch.', dock().replace('{right}', '{top, left}'), [TIME],
               [binds('dock', 'p.[f,g]', 'q.[e,h]')])
    r.named(dock(), [TIME], BIND, 'Bind')
    return r


# Four cubes around a square, p and q below s and r; bonds join them but for p and s, or all.
SQUARE = ("""process p = Cube mass 1 velocity %(v)s [%(p)s]
process q = Cube mass 1 velocity %(v)s at translate (2,0,0) [%(q)s]
process r = Cube mass 1 velocity %(v)s at translate (2,0,2) [%(r)s]
process s = Cube mass 1 velocity %(v)s at translate (0,0,2) [%(s)s]
bond <link, {p.right, q.left}>
bond <link, {q.top, r.bottom}>
bond <link, {r.left, s.right}>
""")
RING = SQUARE + 'bond <link, {p.top, s.bottom}>\n'


def square(p='nil', q='nil', r='nil', s='nil', v='(0,0,0)', bonds='bonds cyclic\n', form=SQUARE):
    return bonds + form % {'p': p, 'q': q, 'r': r, 's': s, 'v': v}


def close():
    r = Rule('Close')
    up, down = '<a, {top}>. eps(1). nil', '<~a, {bottom}>. nil'
    closing = [closes('a', 'p.top', 's.bottom')]
    r.outcomes('No time passes.', square(up, s=down, v='(3,0,0)'), [], closing)
    r.outcomes('Both ends continue.', square(up, s=down), closing, [passes(1)])
    r.value('It moves on as it does, with one bond more.', square(up, s=down, v='(3,0,0)'), [CLOSE], 'vx(p) = 3 and bonds() = 4', True)
    r.outcomes('A channel that opens later.', square('eps(2). ' + up, s=down), [TIME], closing)
    r.outcomes('Of equal names none closes.', square(up, s='<a, {bottom}>. nil'), [], [], 'quiescent')
    r.outcomes('Nor of leaves that a bond joins.', square('<a, {right}>. nil', '<~a, {left}>. nil'), [], [], 'quiescent')
    r.outcomes('Two that touch by an edge, which closures have.', square(up, r='<~a, {left}>. nil'), [],
               [closes('a', 'p.[f,g]', 'r.[a,d]')])
    r.outcomes('Not by faces alone.', square('<a, {only top}>. nil', r='<~a, {left}>. nil'), [], [], 'quiescent')
    both = '<a, {top}>. nil + <b, {top}>. nil'
    r.outcomes('One of two channels.', square(both, s='<~a, {bottom}>. nil + <~b, {bottom}>. nil'), [],
               closing + [closes('b', 'p.top', 's.bottom')])
    r.outcomes('Then the two have a bond.', square('<a, {top}>. <a, {top}>. nil', s='<~a, {bottom}>. <~a, {bottom}>. nil'),
               [CLOSE], [], 'quiescent')
    r.named(square(up, s=down), [], CLOSE, 'Close')
    return r


def bounce():
    r = Rule('Bounce')
    r.outcomes('Nothing is open.', cubes(), [TIME], [bounces('p', 'q')])
    r.state('Equal masses exchange their velocities.', cubes(v='(1,0,0)', w='(-2,1,0)', at='(8,-2,0)'), [TIME, BOUNCE], [
        {'velocity': nums((-2, 0, 0)), **leaf('p')}, {'velocity': nums((1, 1, 0)), **leaf('q')}])
    r.state('1 against 3.', cubes(mass=(1, 3)), [TIME, BOUNCE], [
        {'velocity': nums(('-1/2', 0, 0)), **leaf('p')}, {'velocity': nums(('1/2', 0, 0)), **leaf('q')}])
    r.outcomes('Then they go apart.', cubes(), [TIME, BOUNCE], [], 'quiescent')
    r.named(cubes(), [TIME], BOUNCE, 'Bounce')
    return r


def absorb():
    r = Rule('Absorb')
    drain = 'fixed drain = Cube absorb at translate (6,0,0)\n'
    text = cubes(w='(2,0,0)', at='(3,0,0)') + drain
    gone = [TIME, ABSORB]
    r.outcomes('What hits it never bounces.', text, [TIME], [absorbs('q', 'drain')])
    r.state('Nothing else changes.', text, gone, [
        {'velocity': nums((1, 0, 0)), 'leaves': [{'name': 'p', 'position': nums(('1/2', 0, 0))}]},
        {'velocity': nums((0, 0, 0)), **leaf('drain')}])
    r.outcomes('The next follows.', text, gone, [passes('7/2')])
    r.outcomes('What slides along it goes on.', cubes(v='(0,0,0)', w='(0,1,0)', at='(4,-3,0)') + drain, [], [], 'quiescent')
    r.value('Numbers count nothing of it.', text, gone, 'processes = 2 and size(q) = 0 and energy = 1/2 and momentum.x = 1', True)
    r.value('Facts about it are false.', text, gone, 'gone(q) and not gone(p) and not same(q, q) and not touching(q, drain)', True)
    r.verdict('Where it is has no value.', text, 'AG x(q) < 100', 'undecided')
    r.verdict('Whoever asks first is told.', text, 'AG (gone(q) or x(q) < 100)', 'holds')
    r.verdict('It is a choice that excludes a bounce.', text, 'EF event bounce(q)', 'violated')
    r.verdict('The event tells both.', text, 'AF event absorb(q, drain)', 'holds')
    r.outcomes('A whole process goes, by its first leaf.', bonded('', 'nil', 'nil', v='(1,0,0)') + drain, [TIME],
               [absorbs('p', 'drain')])
    r.outcomes('Another collision at that instant is possible as well.', ABSORBED_BESIDE, [], [absorbs('p', 'drain'), bounces('p', 'wall')])
    r.outcomes('Resolved together, nothing of the cluster bounces while one may be absorbed.',
               'collisions together\n' + ABSORBED_BESIDE, [], [absorbs('p', 'drain')])
    r.outcomes('In turn, two that rest beside it may be hit first.', ABSORBED_OR, [],
               [bounces('p', 'q'), absorbs('p', 'drain'), absorbs('p', 'sink')])
    r.outcomes('Together it is absorbed, by one or the other.', 'collisions together\n' + ABSORBED_OR, [],
               [absorbs('p', 'drain'), absorbs('p', 'sink')])
    r.state('And what it hit besides stays as it is.', 'collisions together\n' + ABSORBED_OR, [ABSORB],
            [{'velocity': nums((0, 0, 0)), **leaf('q')}, leaf('drain'), leaf('sink')])
    binds_too = 'collisions together\n' + ABSORBED_OR.replace('[nil]', '[<a, {right}>. nil]', 1).replace('[nil]', '[<~a, {left}>. nil]', 1)
    r.outcomes('Or it binds, and then the whole is absorbed.', binds_too, [],
               [binds('a', 'p.right', 'q.left'), absorbs('p', 'drain'), absorbs('p', 'sink')])
    r.outcomes('Looked at afresh.', binds_too, [BIND], [absorbs('p', 'drain'), absorbs('p', 'sink')])
    r.refused('What moves does not absorb.', 'process p = Cube mass 1 absorb [nil]\n', 'SC0409')
    r.refused('What absorbs does nothing.', 'fixed p = Cube absorb [eps(1). nil]\n', 'SC0409')
    r.named(text, [TIME], ABSORB, 'Absorb')
    return r


ABSORBED_BESIDE = """process p = Cube mass 1 velocity (1,0,0) [nil]
fixed drain = Cube absorb at translate (2,1,0)
fixed wall = Cube at translate (2,-1,0)
"""

ABSORBED_OR = """process p = Cube mass 1 velocity (1,1,1) [nil]
process q = Cube mass 1 at translate (2,1,0) [nil]
fixed drain = Cube absorb at translate (0,2,0)
fixed sink = Cube absorb at translate (0,0,2)
"""

GRAVITY = 'process p = Cube mass 2 at translate (0,0,10) [nil]\nmotion p = (vx, vy, vz - 2*dt)\n'


def time():
    r = Rule('Time')
    r.outcomes('To the collision.', cubes(), [], [passes(2)])
    r.outcomes('To the end of a delay.', cubes('eps(1/3). nil'), [], [passes('1/3')])
    r.outcomes('To a split instant.', bonded(RELEASE, 'K', 'L', extra='split_step 1/4\n'), [],
               [releases('dock', 'p.right', 'q.left'), passes('1/4')])
    r.outcomes('To the end of a movement step.', 'timestep 2/3\n' + GRAVITY, [], [passes('2/3')])
    r.outcomes('Not while something collides.', cubes('eps(2). nil'), [TIME], [bounces('p', 'q')])
    r.state('Bodies go straight on.', cubes('eps(1/2). nil', v='(1,2,3)', at='(40,0,0)'), [TIME], [
        leaf('p', position=nums(('1/2', 1, '3/2'))), leaf('q', position=nums((40, 0, 0)))])
    r.named(cubes(), [], TIME, 'Time')
    return r


def steer():
    r = Rule('Steer')
    r.value('At the start dt is 0.', GRAVITY, [], 'vz(p)', 0)
    r.value('After a step of 1.', GRAVITY, [TIME], 'vz(p)', -2)
    r.value('The step went on with the velocity before.', GRAVITY, [TIME], 'z(p)', 10)
    r.value('After another.', GRAVITY, [TIME, TIME], 'z(p) = 8 and vz(p) = -4', True)
    whole = bonded('', 'nil', 'nil', 'motion p = (vx + 3*dt, vy, vz)\n')
    r.value('In a compound the whole takes the mean by mass: 3 of one of two equal masses.', whole, [TIME], 'vx(q)', '3/2')
    held = ('fixed q = Cube at translate (2,0,0) [nil]\nprocess p = Cube mass 1 [nil]\nbond <dock, {p.right, q.left}>\n'
            'motion p = (vx + dt, vy, vz)\n')
    r.outcomes('What is bound to a fixed body is not steered.', held, [], [], 'quiescent')
    return r


def successors():
    r = Rule('Successors')
    text = RELEASE + LINE.replace('velocity (-1,0,0) at translate (8,0,0)', 'at translate (6,0,0)') % ('nil', 'K', 'L') \
        + 'bond <dock, {q.right, r.left}>\n'
    r.outcomes('A weak split, or time.', text, [], [releases('dock', 'q.right', 'r.left'), passes(1)])
    r.outcomes('After 2 the first arrives: it bounces, or the bond is released before.', text, [TIME, TIME], [
        releases('dock', 'q.right', 'r.left'), bounces('p', 'q')])
    r.outcomes('A strong split and a collision: both are urgent.',
               text.replace('omega(dock, {right})', 'eps(2). rho({<dock, {right}>})')
               .replace('omega(dock, {left})', 'eps(2). rho({<dock, {left}>})'), [TIME],
               [reacts(('dock', 'q.right', 'r.left')), bounces('p', 'q')])
    r.outcomes('One body: no event ever.', 'process p = Cube mass 1 velocity (1,0,0) [nil]\n', [], [], 'quiescent')
    return r


def suites():
    return [f() for f in (def_5_1, pre, weak, strong, sum_, def_, eps0, time_behaviour, def_5_2, well_formed, weak_split,
                          strong_split, collision, bind, close, bounce, absorb, time, steer, successors)]
