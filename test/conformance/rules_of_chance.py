"""By hand: velocities that laws leave to chance."""

from make_rules import BOUNCE, TIME, Rule, bonded, bounces, passes
from cases import num, nums


def draws(process, velocity, chance):
    return {'kind': 'draw', 'process': process, 'velocity': nums(velocity), 'chance': num(chance)}


def drawn(process, *velocity):
    return {'kind': 'draw', 'process': process, 'velocity': nums(velocity)}


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
    r.refused('A kick of 1 for S = 6.', text % (1, '1, (0,0,0), 1'), 'SC0601')
    r.refused('A constant that is no constant.', text % (1, 'x'), 'SC0601')
    return r


RUIN = ('process p = Cube mass 1 [nil]\nmotion p = choose { (1,0,0) weight 2, (-1,0,0) weight 3 }\n'
        'fixed west = Cube absorb at translate (-4,0,0)\nfixed east = Cube absorb at translate (5,0,0)\n')
# Which of two bodies it hits that it comes to at one instant, is chosen and not drawn.
LOTS = ('process p = Cube mass 1 [nil]\nmotion p = choose { (2,0,0), (0,0,2) weight 3 }\n'
        'fixed a = Cube absorb at translate (4,1,0)\nfixed b = Cube absorb at translate (4,-1,0)\n'
        'fixed top = Cube absorb at translate (0,0,4)\n')


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
    return [draw(), diffuse(), i_38(), probability(), expectation()]
