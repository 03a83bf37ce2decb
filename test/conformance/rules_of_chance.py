"""By hand: what is left to chance, velocities by laws, and weak splits."""

from make_rules import (absorbs, at_once, BIND, BOUNCE, DOCK, TIME, WEAK, Rule, binds, bonded, bounces, cubes, leaf, passes, reacts,
                        releases)
from cases import num, nums, result, unordered


def draws(process, velocity, chance, spin=None):
    drawn = {'kind': 'draw', 'process': process, 'velocity': nums(velocity), 'chance': num(chance)}
    return drawn if spin is None else {**drawn, 'spin': nums(spin)}


def drawn(process, *velocity):
    return {'kind': 'draw', 'process': process, 'velocity': nums(velocity)}


RIGID = 'dynamics constant_spin\n'
WALKER = 'process p = Cube mass 1 [nil]\nmotion p = choose { (1,0,0) weight 2, (-1,0,0) weight 1 }\n'
BOTH = [draws('p', (-1, 0, 0), '1/3'), draws('p', (1, 0, 0), '2/3')]
OTHER = 'process q = Cube mass 1 velocity (0,0,%d) at translate (%d,0,0) [nil]\nmotion q = %s\n'


def draw():
    r = Rule('Draw')
    r.outcomes('Each with its share, before time passes.', WALKER, [], BOTH)
    r.outcomes('Then a step passes.', WALKER, [drawn('p', 1, 0, 0)], [passes(1)])
    r.outcomes('At its end it draws again.', WALKER, [drawn('p', 1, 0, 0), TIME], BOTH)
    r.value('What is drawn is the velocity.', WALKER, [drawn('p', -1, 0, 0), TIME], 'x(p)', -1)
    kicks = '{ (0,1,0) weight 1/2, (0,2,0) weight mass - 1, (0,0,1), (0,1,0) weight 1, (1/(mass - 1),0,0) weight 0 }'
    r.outcomes('A velocity that is named twice; others of weight 0, one of which has no value.',
               'process p = Cube mass 1 [nil]\nmotion p = choose %s\n' % kicks, [],
               [draws('p', (0, 1, 0), '3/5'), draws('p', (0, 0, 1), '2/5')])
    r.outcomes('A family of velocities, relative to its own.',
               'process p = Cube mass 1 velocity (0,0,5) [nil]\n'
               'motion p = choose { for i in -1..1: (vx, vy, vz) + (i,0,0) weight 1 + i*i }\n', [],
               [draws('p', (-1, 0, 5), '2/5'), draws('p', (0, 0, 5), '1/5'), draws('p', (1, 0, 5), '2/5')])
    coin = 'choose { (1,0,0), (-1,0,0) }'
    left = WALKER + OTHER % (3, -9, coin)
    r.outcomes('The one on the left goes first, though it is declared last.', left, [],
               [draws('q', (-1, 0, 0), '1/2'), draws('q', (1, 0, 0), '1/2')])
    r.outcomes('Then the other.', left, [drawn('q', 1, 0, 0)], BOTH)
    r.value('Until both have drawn, both go on as before.', left, [drawn('q', 1, 0, 0)], 'vz(q) = 3 and vx(q) = 0', True)
    r.value('Then both as they have drawn.', left, [drawn('q', 1, 0, 0), drawn('p', -1, 0, 0)],
            'vx(q) = 1 and vz(q) = 0 and vx(p) = -1', True)
    falls = WALKER + OTHER % (3, -9, '(vx, vy, vz - 1)')
    r.outcomes('A law that is certain draws nothing.', falls, [], BOTH)
    r.value('It is asked at once with those who draw, and takes effect with them.', falls, [], 'vz(q)', 3)
    r.value('Here.', falls, [drawn('p', 1, 0, 0)], 'vz(q)', 2)
    wall = WALKER + 'fixed w = Cube at translate (2,0,0)\n'
    r.outcomes('A draw comes before a collision, and may lead into one.', wall, [drawn('p', 1, 0, 0)],
               [bounces('p', 'w')])
    r.outcomes('A collision at an instant at which laws have been asked changes no draw.', wall,
               [drawn('p', 1, 0, 0), BOUNCE], [passes(1)])
    r.refused('A negative weight.', WALKER.replace('weight 1', 'weight -1'), 'SC0601')
    r.refused('Nothing to choose.', WALKER.replace('weight 1', 'weight 0').replace('weight 2', 'weight 0'), 'SC0601')
    spun = RIGID + 'process p = Cube mass 1 spin (0,0,1/4) [nil]\nmotion p = choose { %s }\n'
    r.outcomes('A spin is drawn with its velocity.', spun % '(1,0,0) spin (0,0,1) weight 2, (0,1,0) spin (0,0,-1)', [],
               [draws('p', (0, 1, 0), '1/3', (0, 0, -1)), draws('p', (1, 0, 0), '2/3', (0, 0, 1))])
    r.outcomes('Without one it is the spin that there is; of one velocity the lesser spin comes first.',
               spun % '(1,0,0), (1,0,0) spin (0,0,1/4), (1,0,0) spin (0,1/8,0) weight 2', [],
               [draws('p', (1, 0, 0), '1/2', (0, '1/8', 0)), draws('p', (1, 0, 0), '1/2', (0, 0, '1/4'))])
    r.named(WALKER, [], BOTH[0], 'Draw')
    return r


def diffuse():
    r = Rule('Diffuse')
    text = 'timestep %s\nprocess p = Cube mass 1 velocity (1,0,0) [nil]\nmotion p = diffuse(%s)\n'
    axes = [(1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1)]
    r.outcomes('S = 2 * 1 * 3/6 = 1: kicks of 1, and never none.', text % (1, '1/6'), [],
               [draws('p', a, '1/6') for a in axes])
    r.outcomes('S = 2 * 1/2 * 3/12 = 1/4: kicks of 1/2, that is a velocity of 1.', text % ('1/2', '1/12'), [],
               [draws('p', a, '1/6') for a in axes])
    r.outcomes('S = 3/4 needs a kick of 1, and rests with 1/4.', text % (1, '1/8'), [],
               [draws('p', a, '1/8') for a in axes] + [draws('p', (0, 0, 0), '1/4')])
    r.outcomes('Along one axis, with a drift and a kick of 2.', text % (1, '(1/2, 0, 0), (vx + 1, 3, 0), 2'), [],
               [draws('p', (4, 3, 0), '1/8'), draws('p', (0, 3, 0), '1/8'), draws('p', (2, 3, 0), '3/4')])
    r.outcomes('A kick by its name, without a drift.', text % (1, '(1/2, 0, 0), h = 2'), [],
               [draws('p', (2, 0, 0), '1/8'), draws('p', (-2, 0, 0), '1/8'), draws('p', (0, 0, 0), '3/4')])
    turning = RIGID + 'timestep %s\nprocess p = Cube mass 1 [nil]\nmotion p = diffuse(%s)\n'
    r.outcomes('T = 1/17: a tangent of 1/4, whose 1 - cos is 2/17; a spin of 1/2.',
               turning % (1, '0, turning = (0, 0, 1/17)'), [],
               [draws('p', (0, 0, 0), '1/4', (0, 0, '-1/2')), draws('p', (0, 0, 0), '1/2', (0, 0, 0)),
                draws('p', (0, 0, 0), '1/4', (0, 0, '1/2'))])
    r.state('The kick turns by twice the arc whose tangent is 1/4.', turning % (1, '0, turning = (0, 0, 1/17)'),
            [{**draws('p', (0, 0, 0), '1/4', (0, 0, '1/2'))}, TIME], [leaf('p', turned=['4', '0', '0', '1'])])
    r.outcomes('T = 6/17: a tangent of 1/2 turns twice, with 1 - cos = 128/289; in a step of 1/2 a spin of 2.',
               turning % ('1/2', '0, turning = (12/17, 0, 0)'), [],
               [draws('p', (0, 0, 0), '51/128', (-2, 0, 0)), draws('p', (0, 0, 0), '26/128', (0, 0, 0)),
                draws('p', (0, 0, 0), '51/128', (2, 0, 0))])
    r.outcomes('Independent of the velocity.', turning % (1, '(1/2, 0, 0), h = 1, turning = (0, 1/17, 0)'), [],
               [draws('p', (x, 0, 0), chance, (0, spin, 0)) for x in (-1, 1)
                for spin, chance in (('-1/2', '1/8'), (0, '1/4'), ('1/2', '1/8'))])
    r.outcomes('A kick by its name, after a drift.', text % (1, '(1/2, 0, 0), (vx + 1, 3, 0), h = 2'), [],
               [draws('p', (4, 3, 0), '1/8'), draws('p', (0, 3, 0), '1/8'), draws('p', (2, 3, 0), '3/4')])
    r.refused('A kick by its name and by its place.', text % (1, '1/8, (0,0,0), 1, h = 1'), 'SC0206')
    r.refused('A kick of 1 for S = 6.', text % (1, '1, (0,0,0), 1'), 'SC0601')
    r.refused('A constant that is no constant.', text % (1, 'x'), 'SC0601')
    return r


def blocked():
    r = Rule('Blocked')
    right, left, ways = '(1,0,0)', '(-1,0,0)', 'process %s = Cube mass 1 at translate (%s,0,0) [nil]\nmotion %s = choose { %s }\n'

    def row(how, *walkers):
        """Of cubes 2 wide between walls, so that 0, 2, 4 and 6 are their places where steps last 2."""
        walls = 'fixed west = Cube at translate (-2,0,0)\nfixed east = Cube at translate (8,0,0)\n'
        bodies = ''.join(ways % (name, x, name, kick) for name, x, kick in walkers)
        return 'timestep 2 steady\n%s%s' % ('blocked %s\n' % how if how else '', walls + bodies)

    def after(note, how, walkers, velocities):
        draws = [{'kind': 'draw'}] * len(walkers)
        formula = ' and '.join('vx(%s) = %s' % (w[0], v) for w, v in zip(walkers, velocities))
        r.value(note, row(how, *walkers), draws, formula, True)

    train = [('p', 0, right), ('q', 2, right), ('r', 4, right)]
    after('A row moves as one.', 'wait', train, [1, 1, 1])
    after('Not into a wall.', 'wait', [('p', 2, right), ('q', 4, right), ('r', 6, right)], [0, 0, 0])
    after('Two that are kicked into one place both wait.', 'wait', [('p', 2, right), ('q', 6, left)], [0, 0])
    after('So does what would follow one of them.', 'wait', [('p', 0, right), ('q', 2, right), ('r', 6, left)], [0, 0, 0])
    after('Into two places they go.', 'wait', [('p', 0, right), ('q', 6, left)], [1, -1])
    after('A kick that ends at a wall is taken.', 'wait', [('p', 4, right)], [1])
    after('One that ends beyond it is not.', 'wait', [('p', 4, '(2,0,0)')], [0])
    after('Unless what it hits on the way stops it.', 'stop', [('p', 4, '(2,0,0)')], [2])
    after('What touches stops at once.', 'stop', [('p', 6, right), ('q', 2, right)], [0, 1])
    after('Both stop if both move on.', 'stop', [('p', 2, right), ('q', 4, left)], [0, 0])
    after('What is merely hit goes on.', 'stop', [('p', 2, '(2,0,0)'), ('q', 4, right)], [0, 1])
    draw = [{'kind': 'draw'}]
    r.outcomes('There is no bounce, and time passes.', row('wait', ('p', 6, right)), draw, [passes(2)])
    r.outcomes('Nor here.', row('stop', ('p', 6, right)), draw, [passes(2)])
    r.outcomes('Where nothing is said, there is.', row('', ('p', 6, right)), draw, [bounces('east', 'p')])
    r.outcomes('Or this.', row('bounce', ('p', 6, right)), draw, [bounces('east', 'p')])
    r.outcomes('It is stopped on its way.', row('stop', ('p', 4, '(2,0,0)')), draw, [passes(1)])
    r.outcomes('And waits for its next draw.', row('stop', ('p', 4, '(2,0,0)')), draw + [TIME], [passes(1)])
    ball = row('stop', ('p', 4, '(0,0,0)')) + 'process ball = Cube mass 1 velocity (1,0,0) at translate (1,0,0) [nil]\n'
    r.outcomes('A ball comes.', ball, draw, [passes(1)])
    r.outcomes('It bounces.', ball, draw + [TIME], [bounces('p', 'ball')])
    r.value('As off a wall.', ball, draw + [TIME, BOUNCE], 'vx(ball) = -1 and vx(p) = 0', True)
    binding = (DOCK + 'timestep 2 steady\nblocked wait\nfixed lock = Cube at translate (2,0,0) [Shut]\n'
               'process p = Cube mass 1 [Open]\nmotion p = choose { (1,0,0) }\n')
    r.outcomes('What fits binds.', binding, draw, [binds('dock', 'p.right', 'lock.left')])
    for text in ('dynamics free_body', 'round velocity 1/2'):
        r.refused('Not in such a model.', text + '\n' + row('wait', ('p', 6, right)), 'SC0901')
    return r


def ties():
    r = Rule('Ties')

    def odds(note, text, along, *transitions):
        """All transitions of a state: a label, and its chance or None."""
        told = [{'label': label, **({'chance': num(chance)} if chance else {})} for label, chance in transitions]
        r.add_next(note, 'successors', {'model': r.model('collisions drawn\n' + text), 'states': 'here'},
                   result(transitions=unordered(told)), along)

    site, key = '<a, {left, right}>. nil', '<~a, {left, right}>. nil'
    two = ('process s = Cube mass 1 [%s]\nprocess p = Cube mass 1 velocity (1,0,0) at translate (-2,0,0) [%s]\n'
           'process q = Cube mass 1 velocity (-1,0,0) at translate (2,0,0) [%s]\n')
    p, q = binds('a', 'p.right', 's.left'), binds('a', 'q.left', 's.right')
    race = two % (site, key, key)
    odds('Each as likely as the other.', race, [], (p, '1/2'), (q, '1/2'))
    r.outcomes('The same transitions as in turn.', 'collisions in_turn\n' + race, [], [p, q])
    odds('One that is left has nothing to draw.', race, [p], (bounces('s', 'q'), None))
    r.measured('One number.', 'collisions drawn\n' + race, 'P = ? [ eventually bound(p, s) ]', least='1/2', greatest='1/2')
    r.measured('From 0 to 1 where nothing is said.', race, 'P = ? [ eventually bound(p, s) ]', least=0, greatest=1)
    by_b = binds('b', 'p.right', 's.left')
    both = two % (site + ' + <b, {left}>. nil', key + ' + <~b, {right}>. nil', key)
    odds('Who acts, and then what they do.', both, [], (p, '1/4'), (by_b, '1/4'), (q, '1/2'))
    edges = two % ('<a, {top, bottom}>. nil + <b, {left}>. nil + <c, {right}>. nil', '<~a, {right}>. nil + <~b, {right}>. nil',
                   '<~c, {left}>. nil')
    ways = [binds('a', 'p.[b,c]', 's.[a,d]'), binds('a', 'p.[f,g]', 's.[e,h]')]
    odds('Then by which features.', edges, [], (ways[0], '1/8'), (ways[1], '1/8'), (by_b, '1/4'),
         (binds('c', 'q.left', 's.right'), '1/2'))
    follows = two % ('<a, {left}>. nil + <a, {left}>. eps(1). nil + <a, {left}>. nil', key, key)
    odds('Ways to go on are different, and equal summands are one.', follows, [], (p, '1/4'), (p, '1/4'),
         (bounces('s', 'q'), '1/2'))
    gone = ('process p = Cube mass 1 velocity (1,1,1) [nil]\nprocess q = Cube mass 1 at translate (2,1,0) [nil]\n'
            'fixed drain = Cube absorb at translate (0,2,0)\nfixed sink = Cube absorb at translate (0,0,2)\n')
    odds('Bounces and absorptions.', gone, [], (bounces('p', 'q'), '1/3'), (absorbs('p', 'drain'), '1/3'),
         (absorbs('p', 'sink'), '1/3'))
    reaction = bonded('', 'rho({<dock, {right}>}). nil', 'rho({<dock, {left}>}). nil',
                      'process r = Cube mass 1 velocity (0,1,0) at translate (0,-2,0) [nil]\n')
    odds('A reaction and a collision of one process.', reaction, [], (reacts(('dock', *PQ)), '1/2'), (bounces('p', 'r'), '1/2'))
    weak = race + ('process u = Cube mass 1 at translate (0,9,0) [omega(dock, {right}). nil]\n'
                   'process v = Cube mass 1 at translate (2,9,0) [omega(dock, {left}). nil]\nbond <dock, {u.right, v.left}>\n')
    odds('A weak split stays free.', weak, [], (p, '1/2'), (q, '1/2'), (releases('dock', 'u.right', 'v.left'), None))
    weak = 'collisions drawn\n' + weak
    r.measured('Whatever is chosen.', weak, 'P = ? [ eventually bound(p, s) ]', least='1/2', greatest='1/2')
    r.measured('And this is chosen.', weak, 'P = ? [ bonds(a) = 0 U bonds(dock) = 0 ]', least=0, greatest=1)
    return r


def drawn_lot(decision, one, other, chance, name='dock'):
    return {'kind': 'lot', 'name': name, 'ends': unordered([one, other]), 'decision': decision, 'chance': num(chance)}


def lot(decision, *ends):
    """One to follow: of this bond, if it is told."""
    found = {'kind': 'lot', 'decision': decision}
    return {**found, 'ends': unordered(list(ends))} if ends else found


PQ, RP, PT = ('p.right', 'q.left'), ('r.right', 'p.left'), ('p.top', 't.bottom')
RELEASE, KEEP = lot('release'), lot('keep')
FREE = 'omega(dock, {left}). nil'


def by_chance(*chances):
    """The cube p lets go of q by these chances, and becomes nil."""
    return ' + '.join('omega(dock, {right}) %s. nil' % c for c in chances)


def shared(then):
    """Cubes r, p and q in a row: p lets go by lot, and goes on as it is told."""
    return bonded('behaviour Lets on Cube = omega(dock, {left, right}) chance 1/2. %s\n' % then, 'Lets', FREE,
                  'process r = Cube mass 1 at translate (-2,0,0) [omega(dock, {right}). nil]\nbond <dock, {r.right, p.left}>\n')


STAR = ('behaviour Lets on Cube = omega(dock, {left, right, top}) chance 1/2. Lets\n', 'Lets', FREE,
        'process r = Cube mass 1 at translate (-2,0,0) [omega(dock, {right}). nil]\nbond <dock, {r.right, p.left}>\n'
        'process t = Cube mass 1 at translate (0,0,2) [omega(dock, {bottom}). nil]\nbond <dock, {p.top, t.bottom}>\n')
# Two pairs of cubes, of which the one that is declared last stands to the left.
PAIRS = ('process u = Cube mass 1 at translate (-12,0,0) [omega(dock, {right}) chance 1/4. nil]\n'
         'process v = Cube mass 1 at translate (-10,0,0) [omega(dock, {left}). nil]\nbond <dock, {u.right, v.left}>\n')

# Two that choose what becomes of them; and four in a row, of which the outer ones go.
EITHER = 'omega(dock, {left}). One + omega(dock, {left}). Two'
CHOOSERS = PAIRS.replace('1/4', '1').replace('[omega(dock, {left}). nil]', '[%s]' % EITHER)
PUSHED = bonded('', 'omega(dock, {right}) push(1) chance 1. nil', FREE,
                'process s = Cube mass 1 at translate (4,0,0) [omega(dock, {right}). nil]\n'
                'process t = Cube mass 1 at translate (6,0,0) [omega(dock, {left}) push(1) chance 1. nil]\n'
                'bond <other, {q.right, s.left}>\nbond <dock, {s.right, t.left}>\n')
# One dimer goes in one of two ways, by chance; an end of the other one chooses between two, here or there.
DRAWN_ELSEWHERE = bonded('behaviour R on Cube = nil\nbehaviour S on Cube = nil\nbehaviour K on Cube = nil\n',
                         'omega(dock, {right}) chance 1/2. R + omega(dock, {right}) chance 1/2. S', FREE,
                         'process u = Cube mass 1 at translate (%d,0,0) [omega(dock, {right}) chance 1. nil]\n'
                         'process v = Cube mass 1 at translate (%d,0,0) [omega(dock, {left}). K + omega(dock, {left}). nil]\n'
                         'bond <dock, {u.right, v.left}>\n')
KNOWS = 'Pmax = ? [ eventually not bound(p, q) and (behaviour(p) = R and behaviour(v) = K or behaviour(p) = S and not behaviour(v) = K) ]'


def lots():
    r = Rule('Lot')
    third = bonded('', by_chance('chance 1/3'), FREE)
    both = [drawn_lot('release', *PQ, '1/3'), drawn_lot('keep', *PQ, '2/3')]
    r.outcomes('No lots are drawn at the start, and it is released by them alone.', third, [], [passes(1)])
    r.outcomes('At the next split instant: released with probability 1/3.', third, [TIME], both)
    r.outcomes('It is kept, and time passes.', third, [TIME, KEEP], [passes(1)])
    r.outcomes('At each split instant anew.', third, [TIME, KEEP, TIME], both)
    r.outcomes('Then it is released.', third, [TIME, RELEASE], [releases('dock', *PQ)])
    r.outcomes('And is gone.', third, [TIME, RELEASE, WEAK], [], 'quiescent')
    r.outcomes('Both ends draw: 1/2 times 1/3.', bonded('', by_chance('chance 1/2'), 'omega(dock, {left}) chance 1/3. nil'), [TIME],
               [drawn_lot('release', *PQ, '1/6'), drawn_lot('keep', *PQ, '5/6')])
    r.outcomes('What is certain leaves nothing to keep.', bonded('', by_chance('chance 1'), FREE), [TIME],
               [drawn_lot('release', *PQ, 1)])
    r.outcomes('The chance 0 offers nothing.', bonded('', by_chance('chance 0'), FREE), [], [], 'quiescent')
    r.outcomes('Neither does the rate 0.', bonded('', by_chance('rate 0'), FREE), [], [], 'quiescent')
    r.outcomes('Two ways.', bonded('', by_chance('chance 1/4') + ' + omega(dock, {right}) chance 1/2. eps(1). nil', FREE), [TIME],
               [drawn_lot('release', *PQ, '1/4'), drawn_lot('release', *PQ, '1/2'), drawn_lot('keep', *PQ, '1/4')])
    r.outcomes('What is written twice counts twice.', bonded('', by_chance('chance 1/6', 'chance 1/6'), FREE), [TIME], both)
    free = bonded('', by_chance('chance 1/3', ''), FREE)
    r.outcomes('Beside a free choice.', free, [], [releases('dock', *PQ), passes(1)])
    r.outcomes('Which does not count for the lots.', free, [TIME], both)
    r.outcomes('And is there after them.', free, [TIME, KEEP], [releases('dock', *PQ), passes(1)])
    r.outcomes('The other end is free, and chooses.', bonded('', by_chance('chance 1/3'), FREE + ' + omega(dock, {left}). eps(1). nil'),
               [TIME, RELEASE], [releases('dock', *PQ)] * 2)
    r.outcomes('By two summands of which the same comes it is released in one way.',
               bonded('', by_chance('chance 1/3'), FREE + ' + omega(dock, {left, top}). nil'), [TIME, RELEASE], [releases('dock', *PQ)])
    r.outcomes('Before the release: the one to the left draws first.', shared('nil'), [TIME],
               [drawn_lot('release', *RP, '1/2'), drawn_lot('keep', *RP, '1/2')])
    r.outcomes('Then the other.', shared('nil'), [TIME, RELEASE],
               [drawn_lot('release', *PQ, '1/2'), drawn_lot('keep', *PQ, '1/2')])
    r.outcomes('Both are to be released, and share p: one is first.', shared('nil'), [TIME, RELEASE, RELEASE],
               [drawn_lot('first', *RP, '1/2'), drawn_lot('first', *PQ, '1/2')])
    second = [TIME, RELEASE, RELEASE, lot('first', *PQ)]
    r.outcomes('It is released.', shared('nil'), second, [releases('dock', *PQ)])
    r.outcomes('p offers nothing more: the other is kept.', shared('nil'), [*second, WEAK], [], 'quiescent')
    r.outcomes('p offers the same again: the other is released, too.', shared('Lets'), [*second, WEAK], [releases('dock', *RP)])
    r.outcomes('One of three.', bonded(*STAR), [TIME, RELEASE, RELEASE, RELEASE],
               [drawn_lot('first', *e, '1/3') for e in (RP, PQ, PT)])
    r.outcomes('Then one of two.', bonded(*STAR), [TIME, RELEASE, RELEASE, RELEASE, lot('first', *PQ), WEAK],
               [drawn_lot('first', *e, '1/2') for e in (RP, PT)])
    pairs = bonded('', by_chance('chance 1/3'), FREE, PAIRS)
    left = drawn_lot('release', 'u.right', 'v.left', '1/4')
    r.outcomes('The process on the left goes first.', pairs, [TIME], [left, drawn_lot('keep', 'u.right', 'v.left', '3/4')])
    r.outcomes('Then the other, before anything is released.', pairs, [TIME, RELEASE], both)
    r.outcomes('What is to be released is, when all have drawn.', pairs, [TIME, RELEASE, KEEP], [releases('dock', 'u.right', 'v.left')])
    uv = ('dock', 'u.right', 'v.left')
    r.outcomes('If it is several bonds, they are released at once.', pairs, [TIME, RELEASE, RELEASE], [at_once(('dock', *PQ), uv)])
    r.outcomes('Nothing is bound then.', pairs, [TIME, RELEASE, RELEASE, WEAK], [], 'quiescent')
    r.verdict('Nobody sees which of the two was first.', pairs,
              'EF (bound(p, q) and not bound(u, v)) and EF (bound(u, v) and not bound(p, q))', 'holds')
    sure = bonded('', by_chance('chance 1'), FREE, PAIRS.replace('1/4', '1'))
    r.verdict('Where both surely go, they go together.', sure,
              'AG (bound(p, q) and bound(u, v) or not bound(p, q) and not bound(u, v))', 'holds')
    r.outcomes('Two in a row of four, with pushes: as the one goes, so does the other.', PUSHED, [TIME, RELEASE, RELEASE],
               [at_once(('dock', 'p.right', 'q.left', 1), ('dock', 's.right', 't.left', 1))])
    r.value('What is between them is pushed from both sides.', PUSHED, [TIME, RELEASE, RELEASE, WEAK],
            'vx(p) = -1 and vx(q) = 0 and vx(s) = 0 and vx(t) = 1', True)
    chooses = bonded('behaviour One on Cube = nil\nbehaviour Two on Cube = nil\n', by_chance('chance 1'), EITHER, CHOOSERS)
    choice = {'kind': 'lot', 'name': 'dock', 'ends': unordered(['u.right', 'v.left']), 'decision': 'choose'}
    drawn = [TIME, RELEASE, RELEASE]
    r.outcomes('Two may go in two ways: the first one chooses, when all lots are drawn.', chooses, drawn, [choice] * 2)
    r.outcomes('The last one chooses as it goes.', chooses, [*drawn, lot('choose')], [at_once(('dock', *PQ), uv)] * 2)
    for side, far in (('On the right', 10), ('On the left', -10)):
        r.measured('%s: who chooses knows what has been drawn.' % side, DRAWN_ELSEWHERE % (far, far + 2), KNOWS, greatest=1)
    faster = bonded('', by_chance('chance 1/3'), FREE, 'motion (vx + 1, vy, vz)\n')
    r.value('No law is asked while lots are pending.', faster, [TIME], 'vx(p)', 1)
    r.value('Then they are.', faster, [TIME, KEEP], 'vx(p)', 2)
    r.value('Not before it is released.', faster, [TIME, RELEASE], 'vx(p)', 1)
    r.value('But then.', faster, [TIME, RELEASE, WEAK], 'vx(p) = 2 and vx(q) = 2', True)
    rate = 'split_step 1/2\n' + bonded('', by_chance('rate 1'), FREE)
    # A convergent of 1 - exp(-1/2); no fraction of a lesser denominator is as near.
    r.outcomes('The rate 1 in a step of 1/2.', rate, [TIME],
               [drawn_lot('release', *PQ, '487202/1238221'), drawn_lot('keep', *PQ, '751019/1238221')])
    ways = 'behaviour One on Cube = nil\nbehaviour Two on Cube = nil\n'
    rates = bonded(ways, 'omega(dock, {right}) rate 2. One + omega(dock, {right}) rate 1. Two', FREE)
    beside = 'split_step 1/2\n' + bonded('', by_chance('chance 1/4', 'rate 1'), FREE)
    r.outcomes('A chance beside a rate: each is what it says.', beside, [TIME],
               [drawn_lot('release', *PQ, '1/4'), drawn_lot('release', *PQ, '487202/1238221'), drawn_lot('keep', *PQ, '1765855/4952884')])
    between = 'split_step 1/2\n' + bonded('', by_chance('rate 1/3', 'chance 1/4', 'rate 2/3'), FREE)
    r.outcomes('Rates compete with rates alone.', between, [TIME],
               [drawn_lot('release', *PQ, '487202/3714663'), drawn_lot('release', *PQ, '1/4'),
                drawn_lot('release', *PQ, '974404/3714663'), drawn_lot('keep', *PQ, '1765855/4952884')])
    r.measured('Rates compete.', rates, 'P = ? [ eventually behaviour(p) = One ]', least='2/3', greatest='2/3')
    r.measured('By the second instant: 1 - (2/3)^2.', third, 'P = ? [ eventually not bound(p, q) within 2 ]', least='5/9', greatest='5/9')
    r.measured('It lasts three steps on average.', third, 'E = ? [ time U not bound(p, q) ]', least=3, greatest=3)
    r.named(third, [TIME], both[0], 'Lot')
    r.refused('No probability.', bonded('', by_chance('chance 3/2'), FREE), 'SC0208')
    r.refused('No instants to draw at.', 'split_step any\n' + third, 'SC0505')
    for note, chances in (('More than 1.', ('chance 2/3', 'chance 1/2')), ('Also with a rate.', ('chance 1/2', 'rate 1'))):
        r.add_next(note, 'successors', {'model': r.model(bonded('', by_chance(*chances), FREE))},
                   {'error': {'code': -32006, 'data': {'diagnostics': {'some': [{'code': 'SC0603', 'severity': 'error'}]}}}}, [TIME])
    return r


def i_39():
    r = Rule('I-39')
    lets = DOCK.replace('nil', 'omega(dock, {left, right}) chance 1/2. nil')
    quarter = [drawn_lot('release', *PQ, '1/4'), drawn_lot('keep', *PQ, '3/4')]
    late = cubes('Open', 'Shut', lets, v='(4/3,0,0)')
    r.outcomes('Nothing is bound, and no instant is waited for.', late, [], [passes('3/2')])
    r.outcomes('Bound at 3/2, it is drawn for at 2.', late, [TIME, BIND], [passes('1/2')])
    r.outcomes('With the chances of both ends: 1/4.', late, [TIME, BIND, TIME], quarter)
    r.outcomes('Then at 3.', late, [TIME, BIND, TIME, KEEP], [passes(1)])
    r.outcomes('Bound at a split instant, it waits for the next one.', cubes('Open', 'Shut', lets), [TIME, BIND], [passes(1)])
    event = bonded('', by_chance('chance 1/3'), FREE, 'process r = Cube mass 1 at translate (0,9,0) [eps(3/4). nil]\n')
    both = [drawn_lot('release', *PQ, '1/3'), drawn_lot('keep', *PQ, '2/3')]
    r.outcomes('What happens between two instants.', event, [], [passes('3/4')])
    r.outcomes('Does not shift them.', event, [TIME], [passes('1/4')])
    r.state('All processes tell how long ago the last one was.', event, [TIME],
            [{**leaf('p'), 'lots': {'since': num('3/4'), 'pending': []}},
             {**leaf('r'), 'lots': {'since': num('3/4'), 'pending': []}}])
    r.outcomes('At 1.', event, [TIME, TIME], both)
    r.outcomes('What becomes releasable as time comes to the instant is drawn for at once.',
               bonded('', 'eps(1). ' + by_chance('chance 1/3'), FREE), [TIME], both)
    pending = {'name': 'dock', 'ends': unordered(PQ), 'decided': 'undecided', 'by': []}
    r.state('A state tells for what is still to draw.', event, [TIME, TIME],
            [{**leaf('p'), 'lots': {'since': num(0), 'pending': [pending]}}, {**leaf('r'), 'lots': {'since': num(0), 'pending': []}}])
    by = [{'leaf': 'p', 'summand': 'omega(dock, {right}) chance 1/3. nil'}]
    r.state('And by what is to be released.', event, [TIME, TIME, RELEASE],
            [{**leaf('p'), 'lots': {'since': num(0), 'pending': [{**pending, 'decided': 'release', 'by': by}]}}, leaf('r')])
    r.measured('From a free end nothing is chosen but what becomes of it: q goes on as Goes, or not, where it is released.',
               bonded('behaviour Goes on Cube = nil\n', by_chance('chance 1/3'), FREE + ' + omega(dock, {left}). Goes'),
               'P = ? [ eventually behaviour(q) = Goes within 1 ]', least=0, greatest='1/3')
    return r


RUIN = ('process p = Cube mass 1 [nil]\nmotion p = choose { (1,0,0) weight 2, (-1,0,0) weight 3 }\n'
        'fixed west = Cube absorb at translate (-4,0,0)\nfixed east = Cube absorb at translate (5,0,0)\n')
# Which of two bodies it hits that it comes to at one instant, is chosen and not drawn.
LOTS = ('process p = Cube mass 1 [nil]\nmotion p = choose { (2,0,0), (0,0,2) weight 3 }\n'
        'fixed a = Cube absorb at translate (4,1,0)\nfixed b = Cube absorb at translate (4,-1,0)\n'
        'fixed top = Cube absorb at translate (0,0,4)\n')

# Lots at 1, 2, … until the bond is released; the behaviour Z comes by itself, without a transition.
DECAY = ('split_step 1\nbehaviour Z on Cube = nil\nprocess p = Cube mass 1 [omega(a, {right}) chance 1/2. eps(1/2). Z]\n'
         'process q = Cube mass 1 at translate (2,0,0) [omega(a, {left}). nil]\nbond <a, {p.right, q.left}>\n')

# Two pairs, with lots at 1 for both.
TWO_PAIRS = ('split_step 1\nprocess p = Cube mass 1 [omega(a, {right}) chance 1/3. nil]\n'
             'process q = Cube mass 1 at translate (2,0,0) [omega(a, {left}). nil]\n'
             'process u = Cube mass 1 at translate (10,0,0) [omega(b, {right}) chance 1/2. nil]\n'
             'process v = Cube mass 1 at translate (12,0,0) [omega(b, {left}). nil]\n'
             'bond <a, {p.right, q.left}>\nbond <b, {u.right, v.left}>\n')

# One reaction releases both bonds.
REACTION = ('process p = Cube mass 1 [rho({<a, {right}>}). nil]\n'
            'process q = Cube mass 1 at translate (2,0,0) [rho({<a, {left}>, <b, {right}>}). nil]\n'
            'process r = Cube mass 1 at translate (4,0,0) [rho({<b, {left}>}). nil]\n'
            'bond <a, {p.right, q.left}>\nbond <b, {q.right, r.left}>\n')


def probability():
    r = Rule('Probability')
    lost, won = 'event absorb(p, west)', 'event absorb(p, east)'
    r.measured('Ruin: (r^2 - r^5) / (1 - r^5) for r = 3/2.', RUIN, 'P = ? [ eventually %s ]' % lost,
               least='171/211', greatest='171/211')
    r.measured('The other end has the rest.', RUIN, 'Pmax = ? [ eventually %s ]' % won, greatest='40/211')
    r.verdict('It walks for ever with probability 0.', RUIN, 'P >= 1 [ eventually gone(p) ]', 'holds')
    r.verdict('Though there is a run that does.', RUIN, 'eventually gone(p)', 'violated')
    r.measured('By the fourth step: 2 to the left, or 3, or 4 with one back.', RUIN,
               'P = ? [ eventually gone(p) within 4 ]', least='373/625', greatest='373/625')
    r.measured('Always is what is left.', RUIN, 'P = ? [ always not gone(p) within 4 ]', least='252/625', greatest='252/625')
    r.measured('In a window of time.', RUIN, 'P = ? [ eventually[3, 5] %s ]' % lost, least='108/625', greatest='108/625')
    r.measured('P = 3/5 (3/5 + 2/5 P).', RUIN, 'P = ? [ not x(p) > 0 U %s ]' % lost, least='9/19', greatest='9/19')
    r.verdict('Less than it is.', RUIN, 'P > 4/5 [ eventually %s ]' % lost, 'holds')
    r.verdict('More than it is.', RUIN, 'P >= 9/10 [ eventually %s ]' % lost, 'violated')
    r.verdict('Exactly it.', RUIN, 'P >= (171/211) [ eventually %s ]' % lost, 'holds')
    r.verdict('Not more than it.', RUIN, 'P > (171/211) [ eventually %s ]' % lost, 'violated')
    r.verdict('Nested: from everywhere.', RUIN, 'AG (P > 1/10 [ eventually gone(p) within 4 ])', 'holds')
    a = 'event absorb(p, a)'
    r.measured('What is not drawn is chosen: 1/4, or not at all.', LOTS, 'P = ? [ eventually %s ]' % a, least=0, greatest='1/4')
    r.verdict('All that is chosen counts.', LOTS, 'P > 0 [ eventually %s ]' % a, 'violated')
    r.verdict('Or the best choice.', LOTS, 'Pmax >= 1/4 [ eventually %s ]' % a, 'holds')
    r.verdict('Not above.', LOTS, 'P <= 1/4 [ eventually %s ]' % a, 'holds')
    return r


def expectation():
    r = Rule('Expectation')
    lost = 'event absorb(p, west)'
    r.measured('Ruin: 10 - 25 (1 - r^2) / (1 - r^5) for r = 3/2.', RUIN, 'E = ? [ time U gone(p) ]',
               least='1110/211', greatest='1110/211')
    r.measured('An event that is counted.', RUIN, 'E = ? [ %s U gone(p) ]' % lost, least='171/211', greatest='171/211')
    r.verdict('Infinite, as there are runs that never come to it.', RUIN, 'E <= 1000 [ time U %s ]' % lost, 'violated')
    r.measured('After one and a half steps: -1/5 (1 + 1/2).', RUIN, 'E = ? [ x(p) at 3/2 ]', least='-3/10', greatest='-3/10')
    r.measured('Of a square.', RUIN, 'E = ? [ x(p) * x(p) at 1 ]', least=1, greatest=1)
    r.verdict('Who is gone is nowhere.', RUIN, 'E = ? [ x(p) at 2 ]', 'undecided')
    r.measured('By cases.', RUIN, 'E = ? [ (if gone(p) then 0 else 1) at 4 ]', least='252/625', greatest='252/625')
    r.verdict('More than 5.', RUIN, 'E >= 5 [ time U gone(p) ]', 'holds')
    r.verdict('Not 6.', RUIN, 'E < 6 [ time U gone(p) ]', 'holds')
    r.measured('What is chosen: which of two it hits.', LOTS, 'E = ? [ event absorb(p, a) U gone(p) ]', least=0, greatest='1/4')
    r.measured('The transition that leads to g is counted.', DECAY, 'E = ? [ event weak U event weak ]', least=1, greatest=1)
    r.measured('And so are lots, each, whatever becomes of them.', DECAY, 'E = ? [ not event weak U event weak ]', least=2,
               greatest=2)
    r.measured('The passing of time is not, nor what comes after g.', DECAY, 'E = ? [ not event bind U behaviour(p) = Z ]',
               least=3, greatest=3)
    r.measured('Nothing is, where g holds from the start.', DECAY, 'E = ? [ not event bind U bound(p, q) ]', least=0, greatest=0)
    r.measured('Draws are counted.', RUIN, 'E = ? [ not event weak U time > 3/2 ]', least=2, greatest=2)
    r.measured('Until g begins: x(p) > 1 after 1.', cubes(), 'E = ? [ time U x(p) > 1 ]', least=1, greatest=1)
    r.measured('After all that happens at that instant.', cubes(), 'E = ? [ vx(p) at 2 ]', least=0, greatest=0)
    r.measured('Bonds that go at once are counted each.', TWO_PAIRS, 'E = ? [ event weak U time > 1 ]', least='5/6', greatest='5/6')
    r.measured('No bond has two names.', TWO_PAIRS, 'E = ? [ event weak(a) and event weak(b) U time > 1 ]', least=0, greatest=0)
    r.measured('Of each bond by itself.', TWO_PAIRS, 'E = ? [ event weak and not event weak(b) U time > 1 ]', least='1/3',
               greatest='1/3')
    r.measured('A reaction counts as often as it releases bonds.', REACTION, 'E = ? [ event strong U event strong ]', least=2,
               greatest=2)
    r.measured('And once, of one of them.', REACTION, 'E = ? [ not event strong(a) U event strong ]', least=1, greatest=1)
    return r


def i_38():
    r = Rule('I-38')
    whole = bonded('', 'nil', 'nil', 'motion p = choose { (4,0,0), (-4,0,0) }\nmotion q = choose { (4,0,0), (0,0,0) weight 3 }\n')
    r.outcomes('Two of one mass: (4 or -4, and 4 or 0) / 2.', whole, [],
               [draws('p', (-2, 0, 0), '3/8'), draws('p', (0, 0, 0), '1/8'), draws('p', (2, 0, 0), '3/8'),
                draws('p', (4, 0, 0), '1/8')])
    coin = bonded('', 'nil', 'nil', 'motion choose { (1,0,0), (-1,0,0) }\n')
    r.outcomes('Two ways lead to rest.', coin, [],
               [draws('p', (-1, 0, 0), '1/4'), draws('p', (0, 0, 0), '1/2'), draws('p', (1, 0, 0), '1/4')])
    held = ('fixed q = Cube at translate (2,0,0) [nil]\nprocess p = Cube mass 1 [nil]\nbond <dock, {p.right, q.left}>\n'
            'motion p = choose { (1,0,0), (-1,0,0) }\n')
    r.outcomes('What is bound to a fixed body draws nothing.', held, [], [], 'quiescent')
    return r


def suites():
    return [draw(), diffuse(), blocked(), ties(), i_38(), lots(), i_39(), probability(), expectation()]
