#!/usr/bin/env python3
"""Wrong implementations, to see that the suite notices.

    mutants.py NAME -- COMMAND ...      a proxy: COMMAND, with the answers that the mutant changes
    mutants.py --list

A mutant is a function of (method, params, result) that changes the result of a right implementation, or leaves it as
it is by returning None. Controls change what must not matter, and must not be noticed.
"""

from fractions import Fraction as F
import json
import subprocess
import sys

MUTANTS, CONTROLS = {}, {}


def copied(answer):
    return json.loads(json.dumps(answer))


def mutant(*methods, control=False):
    def add(f):
        def changed(method, params, result):
            if method not in methods:
                return None
            result = copied(result)
            return result if f(params, result) else None
        (CONTROLS if control else MUTANTS)[f.__name__] = changed
        return f
    return add


def out(q):
    return '%d/%d' % (q.numerator, q.denominator)


def shift(holder, key, by):
    """A number in any of its forms."""
    value = holder[key]
    if isinstance(value, dict):
        q = F(value['exact']) + by
        holder[key] = {'exact': out(q), 'float': float(q)}
    else:
        holder[key] = out(F(value) + by)
    return True


TINY = F(1, 10 ** 9)


# Casts


@mutant('first_time_of_contact')
def time_late_by_a_billionth(params, r):
    return r['time'] and shift(r, 'time', TINY)


@mutant('first_time_of_contact')
def time_early_by_a_billionth(params, r):
    return r['time'] and shift(r, 'time', -TINY)


@mutant('first_time_of_contact')
def the_float_beside_is_another(params, r):
    if not r['time']:
        return False
    r['time']['float'] += 1.0
    return True


@mutant('first_time_of_contact')
def time_in_floats_of_32_bits(params, r):
    import struct
    if not r['time']:
        return False
    near = F(struct.unpack('f', struct.pack('f', r['time']['float']))[0])
    return near != F(r['time']['exact']) and shift(r, 'time', near - F(r['time']['exact']))


@mutant('first_time_of_contact')
def grazes_are_hits(params, r):
    if r['outcome'] != 'never' or 'span' in params:
        return False
    r.update(outcome='at', time={'exact': '1/1', 'float': 1.0})
    return True


@mutant('first_time_of_contact')
def collisions_at_0_are_missed(params, r):
    if r['outcome'] != 'at' or F(r['time']['exact']) != 0:
        return False
    r.update(outcome='never', time=None)
    return True


@mutant('first_time_of_contact')
def inside_is_a_collision_at_0(params, r):
    if r['outcome'] != 'inside':
        return False
    r.update(outcome='at', time={'exact': '0/1', 'float': 0.0})
    return True


@mutant('first_time_of_contact')
def grid_too_coarse(params, r):
    if 'grid' not in r:
        return False
    r['grid'] -= 1
    return True


@mutant('first_time_of_contact')
def rounded_up_on_the_grid(params, r):
    return 'grid' in r and r['time'] and shift(r, 'time', F(1, 2 ** r['grid']))


@mutant('first_time_of_contact')
def spins_are_ignored(params, r):
    """As if a body that turns could not be hit before its centre comes."""
    if r['outcome'] != 'at' or not {'spin_a', 'spin_b'} & set(params):
        return False
    r.update(outcome='never', time=None)
    return True


# Contact


@mutant('contact')
def touching_is_apart(params, r):
    if r['relation'] != 'touching':
        return False
    r['relation'] = 'apart'
    return True


@mutant('contact')
def touching_is_interpenetrating(params, r):
    if r['relation'] != 'touching':
        return False
    r['relation'] = 'interpenetrating'
    return True


@mutant('contact')
def hardly_apart_is_touching(params, r):
    if r['relation'] != 'apart':
        return False
    r['relation'] = 'touching'
    return True


@mutant('contact')
def a_pair_is_missing(params, r):
    return r['pairs'] and [r['pairs'].pop()]


@mutant('contact')
def a_pair_twice(params, r):
    return r['pairs'] and not r['pairs'].append(r['pairs'][0])


@mutant('contact')
def dimension_off_by_one(params, r):
    if not r['pairs']:
        return False
    r['pairs'][0]['dimension'] = (r['pairs'][0]['dimension'] + 1) % 3
    return True


@mutant('contact')
def a_corner_is_missing(params, r):
    return r['region'] and len(r['region']) > 2 and [r['region'].pop()]


@mutant('contact')
def a_corner_is_off(params, r):
    return r['region'] and shift(r['region'][0], 2, TINY)


@mutant('contact')
def the_highest_is_another(params, r):
    others = [p for p in r['pairs'] or [] if p != r['highest']]
    if not others:
        return False
    r['highest'] = others[0]
    return True


@mutant('contact')
def normals_point_the_other_way(params, r):
    if not r['normals']:
        return False
    r['normals'] = [[out(-F(a)) for a in n] for n in r['normals']]
    return True


@mutant('contact')
def a_normal_too_many(params, r):
    return r['normals'] and len(r['normals']) > 1 and not r['normals'].append(
        [out(F(a) + F(b)) for a, b in zip(r['normals'][0], r['normals'][1])])


@mutant('contact')
def sliding_is_approaching(params, r):
    if r.get('approaching') is not False:
        return False
    r['approaching'] = True
    return True


@mutant('contact')
def the_gap_is_off(params, r):
    return r.get('gap') and shift(r['gap'], 0, TINY)


@mutant('contact')
def near_is_apart(params, r):
    if r['relation'] != 'near':
        return False
    r['relation'] = 'apart'
    return True


# Responses


@mutant('response')
def velocity_off_by_a_billionth(params, r):
    return shift(r['second']['velocity'], 0, TINY)


@mutant('response')
def no_bounce_off_walls(params, r):
    if r['outcome'] != 'bounced' or not (params['first'].get('fixed') or params['second'].get('fixed')):
        return False
    for k in ('first', 'second'):
        r[k]['velocity'] = [out(F(str(a))) for a in params[k].get('velocity', (0, 0, 0))]
    return True


@mutant('response')
def persistent_is_bounced(params, r):
    if r['outcome'] != 'persistent':
        return False
    r['outcome'] = 'bounced'
    return True


@mutant('response')
def inelastic(params, r):
    """The mean of before and after."""
    for k in ('first', 'second'):
        before = params[k].get('velocity', (0, 0, 0))
        r[k]['velocity'] = [out((F(a) + F(str(b))) / 2) for a, b in zip(r[k]['velocity'], before)]
    return r['outcome'] == 'bounced'


@mutant('response')
def no_torque(params, r):
    if 'spin' not in r['second'] or r['outcome'] != 'bounced':
        return False
    r['second']['spin'] = [out(F(str(a))) for a in params['second'].get('spin', (0, 0, 0))]
    return True


# Shapes


@mutant('shape.mass')
def volume_off(params, r):
    return shift(r, 'volume', TINY)


@mutant('shape.mass')
def centroid_off(params, r):
    return shift(r['centroid'], 1, TINY)


@mutant('shape.mass')
def inertia_not_symmetric(params, r):
    return shift(r['inertia'][0], 1, TINY)


@mutant('shape.mass')
def inertia_about_the_reference_point(params, r):
    if not any(F(a) for a in r['centroid']):
        return False
    c, m = [F(a) for a in r['centroid']], F(r['mass'])
    for i in range(3):
        r['inertia_of_mass'][i][i] = out(F(r['inertia_of_mass'][i][i]) + m * sum(a * a for j, a in enumerate(c) if j != i))
    return True


@mutant('shape.check')
def accepts_what_the_paper_accepts(params, r):
    if r['accepted'] == r['definition_4_3']['holds']:
        return False
    r['accepted'] = r['definition_4_3']['holds']
    return True


@mutant('shape.check')
def condition_7_with_ordered_edges(params, r):
    r['definition_4_3']['conditions'][6]['holds'] = r['definition_4_3']['euler_ordered'] == 2
    return True


@mutant('shape.check')
def a_wrong_code_for_a_fault(params, r):
    if not r['faults']:
        return False
    r['faults'] = [{**f, 'kind': 'wrong', 'code': 'SC0301'} for f in r['faults']]
    return True


# Models


@mutant('successors')
def an_outcome_is_missing(params, r):
    return len(r['transitions']) > 1 and [r['transitions'].pop()]


@mutant('successors')
def an_outcome_too_many(params, r):
    return r['transitions'] and not r['transitions'].append(r['transitions'][0])


@mutant('successors')
def time_passes_though_something_is_urgent(params, r):
    if not r['transitions'] or any(t['label']['kind'] in ('time', 'weak') for t in r['transitions']):
        return False
    r['transitions'].append({'choice': len(r['transitions']), 'rules': ['Time'], 'state': None, 'label': {
        'kind': 'time', 'text': 'time 1', 'duration': '1/1'}})
    return True


@mutant('successors')
def rules_have_other_names(params, r):
    for t in r['transitions']:
        t['rules'] = ['Magic']
    return r['transitions']


@mutant('successors')
def a_duration_is_off(params, r):
    times = [t['label'] for t in r['transitions'] if t['label']['kind'] == 'time']
    return times and shift(times[0], 'duration', TINY)


def all_draws(r):
    return [t['label'] for t in r['transitions'] if t['label']['kind'] == 'draw']


@mutant('successors')
def chances_are_equal(params, r):
    draws = all_draws(r)
    for label in draws:
        label['chance'] = '1/%d' % len(draws)
    return draws


@mutant('successors')
def chances_are_weights(params, r):
    draws = all_draws(r)
    for label in draws:
        label['chance'] = '%d/1' % F(label['chance']).numerator
    return draws


def all_lots(r, decision):
    return [t['label'] for t in r['transitions'] if t['label'].get('decision') == decision]


@mutant('successors')
def lots_are_equal(params, r):
    lots = all_lots(r, 'release') + all_lots(r, 'keep')
    for label in lots:
        label['chance'] = '1/%d' % len(lots)
    return lots


@mutant('successors')
def chances_of_lots_are_changed_about(params, r):
    """What is kept has the chance of what is released."""
    released, kept = all_lots(r, 'release'), all_lots(r, 'keep')
    if len(released) != 1 or len(kept) != 1:
        return False
    released[0]['chance'], kept[0]['chance'] = kept[0]['chance'], released[0]['chance']
    return True


@mutant('successors')
def lots_never_keep(params, r):
    kept = all_lots(r, 'keep')
    r['transitions'] = [t for t in r['transitions'] if t['label'] not in kept]
    return kept


@mutant('successors')
def the_first_is_first(params, r):
    first = all_lots(r, 'first')
    r['transitions'] = [t for t in r['transitions'] if t['label'] not in first[1:]]
    for label in first:
        label['chance'] = '1/1'
    return first


@mutant('successors')
def free_choices_beside_lots(params, r):
    """While lots are pending it may be released freely, too."""
    for t in r['transitions']:
        if t['label'].get('decision') == 'release':
            label = {k: v for k, v in t['label'].items() if k in ('name', 'ends')}
            r['transitions'].append({**t, 'label': {**label, 'kind': 'weak'}, 'rules': ['WeakSplit']})
            return True
    return False


@mutant('successors')
def time_does_not_stop_for_lots(params, r):
    """The network's split instants are not waited for."""
    state = r.get('state') or {'processes': []}
    ahead = any(F(p['lots']['since']) != 0 for p in state['processes'] if 'lots' in p)
    times = [t['label'] for t in r['transitions'] if t['label']['kind'] == 'time']
    return ahead and times and shift(times[0], 'duration', F(1))


@mutant('successors')
def split_instants_start_anew(params, r):
    told = [p['lots'] for p in (r.get('state') or {'processes': []})['processes'] if 'lots' in p]
    late = [lots for lots in told if F(lots['since']) != 0]
    for lots in late:
        lots['since'] = '0/1'
    return late


@mutant('successors')
def nobody_knows_by_what_it_is_released(params, r):
    told = [b for p in (r.get('state') or {'processes': []})['processes'] for b in p.get('lots', {}).get('pending', [])]
    drawn = [bond for bond in told if bond['by']]
    for bond in drawn:
        bond['by'] = []
    return drawn


@mutant('successors')
def what_is_drawn_is_the_change(params, r):
    here = {leaf['name']: p['velocity'] for p in (r.get('state') or {'processes': []})['processes'] for leaf in p['leaves']}
    draws = [label for label in all_draws(r) if label['process'] in here]
    for label in draws:
        label['velocity'] = [out(F(a) - F(b)) for a, b in zip(label['velocity'], here[label['process']])]
    return draws


@mutant('successors')
def bonds_end_elsewhere(params, r):
    labels = [t['label'] for t in r['transitions'] if t['label']['kind'] == 'bind']
    if not labels:
        return False
    labels[0]['ends'] = [labels[0]['ends'][0], labels[0]['ends'][0]]
    return True


@mutant('successors')
def quiescent_is_stuck(params, r):
    if r['ending'] != 'quiescent':
        return False
    r['ending'] = 'stuck'
    return True


@mutant('successors')
def a_position_after_is_off(params, r):
    states = [t['state'] for t in r['transitions'] if t.get('state')]
    return states and shift(states[0]['processes'][0]['leaves'][0]['position'], 0, TINY)


@mutant('successors')
def a_velocity_after_is_off(params, r):
    states = [t['state'] for t in r['transitions'] if t.get('state')]
    return states and shift(states[0]['processes'][-1]['velocity'], 1, TINY)


@mutant('successors')
def split_clocks_never_run(params, r):
    clocks = [p for t in r['transitions'] if t.get('state') for p in t['state']['processes'] if p['clock'] is not None]
    changed = [p for p in clocks if F(p['clock']) != 0]
    for p in changed:
        p['clock'] = '0/1'
    return changed


@mutant('successors')
def turned_the_other_way(params, r):
    leaves = [l for p in (r['state'] or {'processes': []})['processes'] for l in p['leaves'] if 'turned' in l]
    for l in leaves:
        l['turned'] = [l['turned'][0]] + [out(-F(a)).split('/')[0] for a in l['turned'][1:]]
    return leaves


@mutant('successors')
def bonds_are_lost(params, r):
    states = [t['state'] for t in r['transitions'] if t.get('state')] + [r['state'] or {'processes': []}]
    return any([p['bonds'].pop() for s in states for p in s['processes'] if p['bonds']])


@mutant('evaluate')
def verdicts_are_flipped(params, r):
    if r.get('verdict') not in ('holds', 'violated'):
        return False
    r['verdict'] = 'violated' if r['verdict'] == 'holds' else 'holds'
    return True


@mutant('evaluate')
def undecided_holds(params, r):
    if r.get('verdict') != 'undecided':
        return False
    r['verdict'] = 'holds'
    return True


@mutant('evaluate')
def a_bound_is_a_proof(params, r):
    if r.get('verdict') != 'holds-up-to-bound':
        return False
    r['verdict'] = 'holds'
    return True


@mutant('evaluate')
def what_has_no_value_is_false(params, r):
    if r['kind'] != 'state' or r['value'] is not None:
        return False
    r['value'] = False
    return True


@mutant('evaluate')
def events_hold_everywhere(params, r):
    if r['kind'] != 'state' or 'event' not in params['formula'] or r['value']:
        return False
    r['value'] = True
    return True


@mutant('evaluate')
def numbers_are_off(params, r):
    return r['kind'] == 'number' and shift(r, 'value', TINY)


@mutant('model.load')
def nothing_is_rigid(params, r):
    if not r.get('rigid'):
        return False
    r['rigid'] = False
    return True


@mutant('model.load')
def warnings_are_swallowed(params, r):
    return any([r['warnings'].pop() for _ in list(r.get('warnings', []))])


def swapped_codes(answer):
    """Of errors: another diagnostic."""
    for d in answer.get('error', {}).get('data', {}).get('diagnostics', []):
        d['code'] = {'SC0201': 'SC0202'}.get(d['code'], 'SC0201')
    return answer


def wrong_places(answer):
    for d in answer.get('error', {}).get('data', {}).get('diagnostics', []):
        if d.get('place'):
            d['place']['start']['line'] = d['place']['start'].get('line', 0) + 1
    return answer


def refusals_are_passed_over(answer):
    if answer.get('error', {}).get('code') in (-32002, -32003):
        return {k: v for k, v in answer.items() if k != 'error'} | {'result': {'model': 'm999', 'shape': 's999'}}
    return answer


def errors_of_another_code(answer):
    if 'error' in answer:
        answer['error']['code'] -= 1
    return answer


OF_ERRORS = {f.__name__: f for f in (swapped_codes, wrong_places, refusals_are_passed_over, errors_of_another_code)}


# What must not matter


@mutant('successors', control=True)
def outcomes_in_another_order(params, r):
    r['transitions'].reverse()
    return len(r['transitions']) > 1


@mutant('contact', control=True)
def corners_and_pairs_in_another_order(params, r):
    for k in ('region', 'pairs', 'normals'):
        if r[k]:
            r[k].reverse()
    return bool(r['pairs'])


# Sets of parameters


def sets(r):
    return [p['where'] for p in r['properties'] if 'where' in p]


@mutant('model.check')
def borders_belong_to_sets(params, r):
    strict = [c for w in sets(r) for piece in w['pieces'] for c in piece if c['relation'] == '<']
    for c in strict:
        c['relation'] = '<='
    return strict


@mutant('model.check')
def sets_without_volume_are_empty(params, r):
    flat = [w for w in sets(r) if w['pieces'] and w['measure'] == '0/1']
    for w in flat:
        w['pieces'] = []
    return flat


@mutant('model.check')
def borders_do_not_count_in_verdicts(params, r):
    changed = [p for p in r['properties'] if p['verdict'] == 'violated' and 'where' in p
               and p['where']['probability'] == '1/1']
    for p in changed:
        p['verdict'] = 'holds'
    return changed


@mutant('model.check', control=True)
def pieces_in_another_order(params, r):
    for w in sets(r):
        w['pieces'].reverse()
        for piece in w['pieces']:
            piece.reverse()
    return sets(r)


@mutant('first_time_of_contact', control=True)
def numbers_in_another_form(params, r):
    if not r['time']:
        return False
    r['time'] = r['time']['exact']
    return True


@mutant('shape.mass', 'evaluate', 'model.load', 'response', 'shape.check', control=True)
def more_members(params, r):
    r['more'] = 'of no interest'
    return True


@mutant('successors', control=True)
def ends_the_other_way_round(params, r):
    labels = [t['label'] for t in r['transitions'] if 'ends' in t['label']]
    for label in labels:
        label['ends'].reverse()
    return labels


def names():
    return sorted(MUTANTS) + sorted(OF_ERRORS), sorted(CONTROLS)


def change(name, method, params, answer):
    """The answer of a mutant; the same answer where it changes nothing."""
    if name in OF_ERRORS:
        return OF_ERRORS[name](copied(answer))
    if 'result' not in answer:
        return answer
    result = {**MUTANTS, **CONTROLS}[name](method, params, answer['result'])
    return answer if result is None else {**answer, 'result': result}


def main():
    if sys.argv[1:] == ['--list']:
        print('\n'.join(sum(names(), [])))
        return
    name, command = sys.argv[1], sys.argv[sys.argv.index('--') + 1:]
    child = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
    for line in sys.stdin:
        child.stdin.write(line)
        child.stdin.flush()
        request, answer = json.loads(line), json.loads(child.stdout.readline())
        print(json.dumps(change(name, request['method'], request.get('params', {}), answer)), flush=True)
    child.stdin.close()
    child.wait()


if __name__ == '__main__':
    main()
