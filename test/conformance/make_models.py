"""Cases of whole models: all transitions of all states of small ones, compared with the naive calculus of
test/references/independent, and verdicts."""

from fractions import Fraction as F
import html
import os
import random
import re
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
INDEPENDENT = os.path.join(HERE, '..', 'references', 'independent')
sys.path.insert(0, INDEPENDENT)

from cases import Suite, files_of, load, num, nums, result, unordered
import compare
import explore
import reading

# This folder has a generate.py of its own.
import importlib.util
spec = importlib.util.spec_from_file_location('random_models', os.path.join(INDEPENDENT, 'generate.py'))
random_models = importlib.util.module_from_spec(spec)
spec.loader.exec_module(random_models)

NAIVE = ('by scc and by the naive calculus of test/references/independent (Python, fractions), which agree on every '
         'transition')
EXPLORED = 'by the naive exploration of test/references/independent, formulas sampled between all their changes; scc agrees'
EXPECTED = 'by hand, as written beside the check in specs/models'


class Refused(Exception):
    pass


def ask(implementation, method, **params):
    answer = implementation.call(method, params)
    if 'error' in answer:
        raise Refused(answer['error'])
    return answer['result']


# What scc says, as a pattern ------------------------------------------------------------


def label_pattern(label):
    kind = label['kind']
    if kind == 'time':
        return {'kind': kind, 'duration': num(label['duration'])}
    if kind in ('bind', 'weak'):
        return {'kind': kind, 'name': label['name'], 'ends': unordered(label['ends'])}
    if kind == 'bounce':
        return {'kind': kind, 'between': unordered(label['between'])}
    if kind == 'absorb':
        return {'kind': kind, 'between': label['between']}
    if kind == 'draw':
        return {'kind': kind, 'process': label['process'], 'velocity': nums(label['velocity']),
                'chance': num(label['chance'])}
    return {'kind': kind, 'bonds': unordered([bond_pattern(b) for b in label['bonds']])}


def bond_pattern(bond):
    return {'name': bond['name'], 'ends': unordered(bond['ends'])}


def state_pattern(state):
    """Behaviours are left out: what they are is seen in what follows, and others print them otherwise."""
    return {'processes': unordered([{
        'velocity': nums(p['velocity']), 'clock': p['clock'] and num(p['clock']),
        'leaves': unordered([{'name': l['name'], 'position': nums(l['position']), 'origin': l['origin']}
                             for l in p['leaves']]),
        'bonds': unordered([bond_pattern(b) for b in p['bonds']]),
        **({'draw': draw_pattern(p['draw'])} if 'draw' in p else {})} for p in state['processes']])}


def draw_pattern(draw):
    """Who waits to draw, or what it has drawn."""
    return nums(draw) if isinstance(draw, list) else draw


# All transitions of all states ----------------------------------------------------------

RULE = {'time': ['Time'], 'bind': ['Bind', 'Collision'], 'close': ['Close'], 'bounce': ['Bounce', 'Collision', 'Response'],
        'weak': ['WeakSplit'], 'strong': ['StrongSplit'], 'draw': ['Draw']}


def naive(model, output, state, answer):
    """The transitions that scc tells, as (label, state, entry), after comparing them with the naive ones."""
    found = []
    for t in answer['transitions']:
        label = output.label(t['label'], state)
        duration = label[1] if label[0] == 'time' else F(0)
        found.append((label, output.state(t['state'], str(state.time + duration)), t))
    jumping = model.calculus.successors(state, jump=True)
    plain = model.calculus.successors(state)
    mine = {(label, after) for label, after, _ in found}
    if mine not in (plain, jumping) or len(found) != len(mine):
        raise reading.Difference('the transitions of a state differ')
    return found


def walk(suite, implementation, name, model, states):
    """A case for each reachable state, up to so many; whether these are all."""
    text = model.text()
    handle = ask(implementation, 'model.load', text=text)['model']
    output = reading.Output(model.bodies)
    start = model.initial()
    todo, seen = [([], [], start)], {start._replace(time=F(0))}
    reference = suite.give(name, load(text))
    made = 0
    while todo and made < states:
        path, along, state = todo.pop(0)
        answer = ask(implementation, 'successors', model=handle, path=path, states='all')
        if any(len(x) > 40 for x in re.findall(r'[0-9]+', str(answer))):
            break
        found = naive(model, output, state, answer)
        kinds = {l[0] for l, _, _ in found}
        rules = ['Successors'] + sorted({r for k in kinds for r in RULE[k]}) + (['Quiescent'] if not found else [])
        if model.calculus.steered:
            rules.append('Steer')
        suite.add('%s, state %d' % (name, made), rules, 'successors', {'model': reference, 'states': 'all'}, result(
            time=num(answer['time']) if isinstance(answer['time'], str) else num(answer['time']['exact']),
            transitions=unordered([{'label': label_pattern(t['label']), 'state': state_pattern(t['state'])}
                                   for _, _, t in found]), ending=answer['ending']), along=along)
        made += 1
        for label, after, t in found:
            known = after._replace(time=F(0))
            # A label that two transitions share leads nowhere in particular.
            if known not in seen and sum(l == label for l, _, _ in found) == 1:
                seen.add(known)
                todo.append((path + [t['choice']], along + [label_pattern(t['label'])], after))
    ask(implementation, 'model.release', model=handle)
    return not todo and made == len(seen)


WANTED = ({'StrongSplit', 'WeakSplit'}, {'Bind'})  # of each third model


def transitions_suite(implementation, count=42, states=12):
    suite = Suite('models/transitions.json', 'Random small models of boxes: every transition of each state, with the '
                  'state after it. A model has a case for each state that it can reach, so that these are all its runs.',
                  NAIVE)
    seed, made = 2000, 0
    while made < count:
        seed += 1
        model = random_models.Model(seed)
        try:
            graph = explore.Graph(model.calculus, model.initial(), states)
        except explore.TooMany:
            continue
        if len(graph.edges) < 4 or any('time' in t for t in model.law_texts):
            continue
        before = len(suite.cases)
        try:
            whole = walk(suite, implementation, 'model %d' % seed, model, states)
        except Refused:
            whole = False
        if not whole:
            del suite.cases[before:]
            continue
        seen = {r for case in suite.cases[before:] for r in case['rules']}
        if made % 3 and not seen & WANTED[made % 3 - 1]:
            del suite.cases[before:]
            continue
        made += 1
    suite.given = {n: g for n, g in suite.given.items() if any(c['params']['model'] == '@' + n for c in suite.cases)}
    return suite


# Verdicts -------------------------------------------------------------------------------

def verdicts_suite(count=45, questions=6):
    suite = Suite('models/verdicts.json', 'Random small models of boxes: verdicts of random properties.', EXPLORED)
    seed, made = 4000, 0
    while made < count:
        seed += 1
        model = random_models.Model(seed)
        if any('time' in t for t in model.law_texts):
            continue
        try:
            graph = explore.Graph(model.calculus, model.initial(), 80)
        except explore.TooMany:
            continue
        if len(graph.edges) < 4:
            continue
        rng = random.Random(seed)
        name = 'model %d' % seed
        reference = suite.give(name, load(model.text()))
        for i in range(questions):
            formula, verdict = compare.question(model, rng, graph)
            rules = ['Verdict', 'Instants', 'Until'] + (['Intervals'] if 'within' in formula else [])
            suite.add('%s, %d' % (name, i), rules, 'evaluate', {'model': reference, 'formula': formula},
                      result(kind='temporal', verdict=verdict))
        made += 1
    return suite


# specs/models ---------------------------------------------------------------------------

CHECK = re.compile(r'^check (\w+)\s*:\s*(.*?)\s*// expect: ([a-z]\w*)\s*$', re.M)
VERDICTS = {'bounded': 'holds-up-to-bound'}
# Over ranges, or all instants of splits: no model that is loaded.
OVER = re.compile(r'^(param \w+ in [\[(]|split_step any)', re.M)


def rules_of_models(rulebook):
    """The rules that name a model in a `Model:` line."""
    found, rule, laws = {}, None, False
    for line in rulebook.split('\n'):
        heading = re.match(r'### (\S+)', line)
        if heading:
            rule = heading.group(1)
        elif line.startswith('## '):
            laws = line.endswith('. Laws')  # which follow of the rules
        if laws:
            continue
        model = re.match(r'- Model: specs/models/(\S+)\.sc', line)
        if model:
            found.setdefault(model.group(1), []).append(rule)
    return found


CHOOSES = re.compile(r'^motion .*\b(choose|diffuse)\b', re.M)
TURNS = re.compile(r'^dynamics\b|\bspin \(', re.M)


def examples_suite(specs, file, about, chosen):
    """A file has less models than an implementation keeps at a time."""
    suite = Suite(file, about, EXPECTED)
    with open(os.path.join(specs, 'rulebook.md'), encoding='utf-8') as f:
        rules = rules_of_models(f.read())
    folder = os.path.join(specs, 'models')
    for file in sorted(os.listdir(folder)):
        name = file[:-3]
        if not file.endswith('.sc'):
            continue
        with open(os.path.join(folder, file), encoding='utf-8') as f:
            text = f.read()
        if not chosen(text):
            continue
        checks = [c for c in CHECK.findall(text)]
        bare = CHECK.sub('', text)  # formulas are asked one by one
        if not checks:
            continue
        files = files_of(folder, bare)
        if OVER.search(bare):
            suite.add(name, sorted(set(rules.get(name, []) + ['Verdict'])), 'model.check', {'text': text}, result(
                properties=[{'name': check, 'verdict': VERDICTS.get(v, v)} for check, _, v in checks]))
            continue
        reference = suite.give(name, load(bare, files=files) if files else load(bare))
        for check, formula, verdict in checks:
            suite.add('%s.%s' % (name, check), sorted(set(rules.get(name, []) + ['Verdict'])), 'evaluate',
                      {'model': reference, 'formula': formula},
                      result(kind='temporal', verdict=VERDICTS.get(verdict, verdict)))
    return suite


def paper_suite(specs):
    """What the paper says of its figures."""
    suite = Suite('models/paper.json', 'Outcomes that the paper tells of its examples.', 'from the paper')

    def figure(name, file, rules, along, labels, obtained, ending=None):
        with open(os.path.join(specs, 'models', file), encoding='utf-8') as f:
            reference = suite.give(file[:-3], load(CHECK.sub('', f.read())))
        suite.add(name, rules, 'successors', {'model': reference}, result(
            transitions=unordered([{'label': l} for l in labels]), ending=ending), obtained, along=along)

    def bind(name, one, other):
        return {'kind': 'bind', 'name': name, 'ends': unordered([one, other])}
    time = {'kind': 'time'}
    for file, whole in (('figure7.sc', 'P0.'), ('figure7-offset.sc', 'P0.')):
        figure(file[:-3], file, ['Bind', 'Touching', 'I-3', 'Successors'], [time], [
            bind('a', whole + 's0.[v2,v3]', 's2.f4' if file == 'figure7.sc' else 's2.f3'),
            bind('a', whole + 's1.[v2,v3]', 's2.f4' if file == 'figure7.sc' else 's2.f3')],
            'from the paper, Figure 7: exactly two bindings; by hand, which')
    atp, glucose = (bind('atp', 'enzyme.floorA.top', 'atp.bottom'), bind('glc', 'enzyme.floorB.top', 'glucose.bottom'))
    both = {'kind': 'strong', 'bonds': unordered([{k: b[k] for k in ('name', 'ends')} for b in (atp, glucose)])}
    from_paper = 'from the paper: hexokinase binds ATP and glucose in either order, and then reacts; by hand'
    rules = ['Bind', 'I-8', 'Successors']
    figure('hexokinase: either comes first', 'hexokinase.sc', rules, [time], [atp, glucose], from_paper)
    figure('hexokinase: glucose after ATP', 'hexokinase.sc', rules + ['WeakSplit'], [time, atp],
           [glucose, {'kind': 'weak', 'name': 'atp', 'ends': atp['ends']}], from_paper)
    figure('hexokinase: the reaction', 'hexokinase.sc', ['StrongSplit', 'WeakSplit'], [time, atp, glucose],
           [both, {'kind': 'weak', 'name': 'atp', 'ends': atp['ends']},
            {'kind': 'weak', 'name': 'glc', 'ends': glucose['ends']}], from_paper)
    return suite


XML_CHECK = re.compile(r'<check name="(\w+)">([^<]*)</check> *<!-- ?expect: (\w+) ?-->\n?')


def xml_suite(specs):
    """Models in XML: what is expected is written in comments beside their checks."""
    suite = Suite('models/bioshape.json', 'Models in XML (specs/bioshape-xml.md): verdicts of their checks.', EXPECTED)
    folder = os.path.join(specs, 'models', 'bioshape')
    for file in sorted(os.listdir(folder)):
        with open(os.path.join(folder, file), encoding='utf-8') as f:
            text = f.read()
        checks = XML_CHECK.findall(text)
        if not checks:
            continue
        bare = XML_CHECK.sub('', text)
        files = files_of(folder, bare)
        reference = suite.give(file, load(bare, files=files) if files else load(bare))
        for check, formula, verdict in checks:
            suite.add('%s.%s' % (file, check), ['Verdict'], 'evaluate',
                      {'model': reference, 'formula': html.unescape(formula)},
                      result(kind='temporal', verdict=VERDICTS.get(verdict, verdict)))
    return suite


def all_suites(implementation, specs):
    certain = examples_suite(specs, 'models/examples.json', 'The models of specs/models: verdicts of their checks.',
                             lambda text: not CHOOSES.search(text) and not TURNS.search(text))
    turning = examples_suite(specs, 'models/turning.json', 'Those in which bodies turn.',
                             lambda text: TURNS.search(text) and not CHOOSES.search(text))
    chance = examples_suite(specs, 'models/chance.json', 'Those that leave velocities to chance.', CHOOSES.search)
    return [paper_suite(specs), transitions_suite(implementation), verdicts_suite(), certain, turning, chance,
            xml_suite(specs)]
