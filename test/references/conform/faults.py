"""Faults that a simulator may have, each put into a right trace, with what scc conform has to say of it.

A fault is a scene, a seed, a change of the items of its run, and the kind and the first rule of the divergence that it
is to be told as; or, for a trace that cannot be of the model at all, the code of a diagnostic.
"""

import copy


def events(items, kind=None):
    """The places of events, of one kind or of all."""
    return [n for n, i in enumerate(items) if i['what'] in ('bind', 'bounce', 'weak', 'strong')
            and kind in (None, i['what'])]


def until_next(items, place):
    """The places from an event on to the next one, without it."""
    later = [n for n in events(items) if n > place]
    return range(place, later[0] if later else len(items))


def leaves_of(items, place, names):
    """The processes, in the state after a place, that have one of the leaves."""
    return [p for p in items[place]['processes'] if any(n in names for n, _ in p['leaves'])]


def shifted(kind, number, by):
    """An event at another time, with all that is told until the next one cut out."""
    def change(items):
        place = events(items, kind)[number]
        items[place]['time'] += by
        del items[place + 1:]
        items.append(dict(what='end', time=items[place]['time']))
    return change


def dropped(kind, number):
    def change(items):
        place = events(items, kind)[number]
        span = until_next(items, place)
        del items[span.start:span.stop]
        if items[-1]['what'] != 'end':
            items.append(dict(what='end', time=1000.0))
    return change


def event(kind, time, between=None, bonds=None):
    return dict(what=kind, time=time, between=between or [], bonds=bonds or [])


def inserted(number, new):
    """An event halfway between two."""
    def change(items):
        place, after = events(items)[number], events(items)[number + 1]
        items.insert(after, dict(new, time=(items[place]['time'] + items[after]['time']) / 2))
        for n in range(after - 1, place, -1):
            if items[n]['time'] > items[after]['time']:
                del items[n]
    return change


def appended(new):
    def change(items):
        time = items[-1]['time']
        items[-1:] = [dict(new, time=time)]
    return change


def replaced(kind, number, **members):
    def change(items):
        items[events(items, kind)[number]].update(members)
    return change


def moved(kind, number, name, new):
    """The velocity of a body's process, just after an event, by a function of what it is."""
    def change(items):
        place = events(items, kind)[number] + 1
        for p in leaves_of(items, place, [name]):
            p['velocity'] = new(p['velocity'])
    return change


def off_course(items):
    """A body that is somewhere else, though as fast."""
    state = [i for i in items if i['what'] == 'state'][-1]
    for p in leaves_of(items, items.index(state), ['ball']):
        p['leaves'] = [(n, (at[0] + 0.001, at[1], at[2])) for n, at in p['leaves']]


def not_steered(items):
    """A law of motion that is forgotten once: at the end of the first step."""
    for i in items:
        if i['what'] == 'state' and abs(i['time'] - 0.25) < 1e-9:
            for p in leaves_of(items, items.index(i), ['ball']):
                p['velocity'] = (1.0, 0.0, 0.0)


def swapped(items):
    """Two events that depend on each other, in the other order."""
    first, second = events(items)[:2]
    items[first]['bonds'], items[second]['bonds'] = items[second]['bonds'], items[first]['bonds']


def backwards(items):
    place = events(items)[2]
    items[place]['time'] = items[events(items)[0]]['time'] - 0.5


def renamed(items):
    items[events(items)[0]]['between'] = ['p', 'wall[7]']


def mid_instant(items):
    """The run goes on after an instant of which only the first of two events is told."""
    places = events(items)
    pairs = [(a, b) for a, b in zip(places, places[1:]) if abs(items[a]['time'] - items[b]['time']) < 1e-9
             and items[b]['what'] == 'bounce']
    place = pairs[0][1]
    items[place:] = [dict(what='end', time=items[place]['time'] + 0.001)]


def at_rest_too_soon(items):
    place = events(items)[-1]
    items[place:] = [dict(what='quiescent', time=items[events(items)[-2]]['time'])]


def lost_bond(items):
    place = events(items, 'bind')[0] + 1
    for p in items[place]['processes']:
        p['bonds'] = []


def start_off(items):
    items[0] = copy.deepcopy(items[0])
    for p in leaves_of(items, 0, ['a']):
        p['leaves'] = [(n, (at[0] - 0.01, at[1], at[2])) for n, at in p['leaves']]


def twice(kind):
    """An event that is told again, a little later."""
    def change(items):
        place = events(items, kind)[0]
        again = copy.deepcopy(items[place])
        again['time'] += 1.0
        items[place + 1:] = [again]
    return change


def flip(v):
    return tuple(-a for a in v)


def bond(name, one, two):
    return (name, [tuple(one.split('.')), tuple(two.split('.'))])


W = 'wall[%d]'

# scene, seed, what is wrong, the change, the kind, the first rule
FAULTS = [
    ('billiard', 1, 'a bounce too late', shifted('bounce', 3, 0.01), 'wrong-time', 'Ftoc'),
    ('billiard', 1, 'a bounce too early', shifted('bounce', 4, -0.01), 'wrong-time', 'Ftoc'),
    ('billiard', 1, 'a bounce is missed', dropped('bounce', 2), 'missing-event', 'Collision'),
    ('billiard', 1, 'a bounce in mid-flight', inserted(2, event('bounce', 0, ['q', W % 6])), 'extra-event', 'Bounce'),
    ('billiard', 1, 'a bounce off another wall', replaced('bounce', 1, between=['q', W % 6]), 'wrong-partner',
     'Bounce'),
    ('billiard', 1, 'a bond where nothing binds',
     replaced('bounce', 0, what='bind', bonds=[bond('a', 'p.right', 'q.left')]), 'wrong-kind', 'Bind'),
    ('billiard', 1, 'a body goes on after a bounce', moved('bounce', 0, 'p', flip), 'wrong-velocity', 'Bounce'),
    ('billiard', 1, 'a body that the model has not', renamed, 'SC0804', None),
    ('billiard', 1, 'time runs backwards', backwards, 'time-back', 'Time'),
    ('billiard', 1, 'energy is lost in a bounce', moved('bounce', 5, 'q', lambda v: tuple(0.9 * a for a in v)),
     'wrong-velocity', 'Bounce'),
    ('latch', 1, 'another face binds', replaced('bind', 0, bonds=[bond('dock', 'p.right', 'q.right')]),
     'wrong-features', 'Bind'),
    ('latch', 1, 'another channel binds', replaced('bind', 0, bonds=[bond('lock', 'p.right', 'q.left')]),
     'wrong-channel', 'Bind'),
    ('latch', 1, 'a bounce where bodies bind', replaced('bind', 0, what='bounce', between=['p', 'q']), 'wrong-kind',
     'Bind'),
    ('latch', 1, 'the bond is forgotten', lost_bond, 'wrong-bonds', 'Bind'),
    ('latch', 3, 'a weak split off its instants', shifted('weak', 0, 0.5), 'wrong-time', 'WeakSplit'),
    ('latch', 3, 'a weak split happens twice', twice('weak'), 'extra-event', 'Quiescent'),
    ('latch', 3, 'a push in a split', moved('weak', 0, 'p', lambda v: (-0.5, 0.0, 0.0)), 'wrong-velocity', 'I-11'),
    ('dimer', 1, 'a reaction too early', shifted('strong', 0, -0.5), 'wrong-time', 'StrongSplit'),
    ('dimer', 1, 'a reaction too late', shifted('strong', 0, 0.5), 'wrong-time', 'StrongSplit'),
    ('dimer', 1, 'a reaction is left out', dropped('strong', 0), 'missing-event', 'StrongSplit'),
    ('dimer', 1, 'a release where bonds react', replaced('strong', 0, what='weak'), 'wrong-kind', 'WeakSplit'),
    ('chain', 1, 'momentum is lost in a bond', moved('bind', 1, 'c[1]', lambda v: (0.25, 0.0, 0.0)), 'wrong-velocity',
     'Bind'),
    ('chain', 1, 'momentum is made in a bond', moved('bind', 0, 'c[1]', lambda v: (1.0, 0.0, 0.0)), 'wrong-velocity',
     'Bind'),
    ('relay', 1, 'bonds in an order that is impossible', swapped, 'wrong-order', 'Successors'),
    ('chain', 1, 'an event after all is over', appended(event('bounce', 0, ['c[1]', 'c[4]'])), 'extra-event',
     'Quiescent'),
    ('chain', 1, 'rest is claimed too soon', at_rest_too_soon, 'wrong-ending', 'Quiescent'),
    ('enzyme', 1, 'an instant is told in part', mid_instant, 'missing-event', 'Collision'),
    ('gravity', 1, 'a law is forgotten at the end of a step', not_steered, 'wrong-velocity', 'Steer'),
    ('gravity', 1, 'a body is off its course', off_course, 'wrong-position', 'Time'),
    ('crystals', 1, 'a body starts elsewhere', start_off, 'wrong-position', 'Time'),
    ('crystals', 1, 'a bounce along another normal',
     moved('bounce', 0, 'a', lambda v: (-v[0], v[1], v[2])), 'wrong-velocity', 'Bounce'),
]
