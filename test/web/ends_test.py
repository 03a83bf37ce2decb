"""Where the page shows the end of a run, against what the verdict says of it: the time, the start and the facts.

Facts are read anew here, as texts of atoms about the places, motions, behaviours and bonds of the page; those of a form
that is not read are counted, and are few.
"""

import json
import re
import subprocess
from fractions import Fraction

NUMBER = r'-?\d+(?:/\d+)?'
NAME = r'[A-Za-z_]\w*(?:\[[^]]*\])*'
COMPARED = {
    '=': lambda a, b: a == b, '<': lambda a, b: a < b, '<=': lambda a, b: a <= b,
    '>': lambda a, b: a > b, '>=': lambda a, b: a >= b,
}


def vector(texts):
    return [Fraction(x) for x in texts]


def minus(a, b):
    return [x - y for x, y in zip(a, b)]


def centroid(solid):
    """Of a polyhedron: cones over the triangles of its faces."""
    points = [vector(v) for v in solid['vertices']]
    whole, sums = Fraction(0), [Fraction(0)] * 3
    for face in solid['faces']:
        first, *others = [points[c] for c in face['corners']]
        for one, two in zip(others, others[1:]):
            (a, b, c), (d, e, f), (g, h, i) = first, one, two
            volume = a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g)
            whole += volume
            sums = [s + volume * (x + y + z) / 4 for s, x, y, z in zip(sums, first, one, two)]
    return [s / whole for s in sums]


class State:
    def __init__(self, told, solids):
        self.solids = solids
        self.time = Fraction(told['time'])
        self.processes = told['processes']
        self.last = told['last']
        self.of = {leaf['name']: (process, leaf) for process in told['processes'] for leaf in process['leaves']}

    def point(self, name):
        """The centroid of a body of one part; None of others, whose parts count by their masses."""
        leaf = self.of[name][1]
        if len(leaf['parts']) > 1:
            return None
        part, matrix = leaf['parts'][0], vector(leaf['matrix'])
        middle = [x + y for x, y in zip(vector(part['offset']), centroid(self.solids[part['solid']]))]
        turned = [sum(matrix[3 * k + j] * middle[j] for j in range(3)) for k in range(3)]
        return [x + y for x, y in zip(vector(leaf['position']), turned)]

    def velocity(self, name):
        """None of a process that turns, of which each body has its own."""
        process = self.of[name][0]
        return None if process['turns'] else vector(process['velocity'])


def value(state, text):
    """The number that a text names, or None if it is of a form that is not read."""
    if re.fullmatch(NUMBER, text):
        return Fraction(text)
    if text == 'time':
        return state.time
    if text == 'processes':
        return len(state.processes)
    found = re.fullmatch(rf'(v?)([xyz])\(({NAME})\)', text)
    if found and found[3] in state.of:
        all_three = state.velocity(found[3]) if found[1] else state.point(found[3])
        return all_three and all_three['xyz'.index(found[2])]
    found = re.fullmatch(r'bonds\((\w*)\)', text)
    if found:
        return sum(bond['name'] == found[1] or found[1] == '' for p in state.processes for bond in p['bonds'])
    found = re.fullmatch(rf'size\(({NAME})\)', text)
    if found and found[1] in state.of:
        return sum(len(leaf['parts']) for leaf in state.of[found[1]][0]['leaves'])
    found = re.fullmatch(rf'distance2\(({NAME}), ({NAME})\)', text)
    if found and {found[1], found[2]} <= set(state.of):
        one, two = state.point(found[1]), state.point(found[2])
        return one and two and sum(d * d for d in minus(one, two))
    found = re.fullmatch(rf'speed2\(({NAME})\)', text)
    if found and found[1] in state.of:
        velocity = state.velocity(found[1])
        return velocity and sum(v * v for v in velocity)
    return None


def truth(state, text):
    """Whether a claim is so in a state, or None if it is of a form that is not read."""
    if text.startswith('not '):
        inner = truth(state, text[4:])
        return None if inner is None else not inner
    if text == 'true':
        return True
    found = re.fullmatch(rf'behaviour\(({NAME})\) = (\w+)', text)
    if found and found[1] in state.of:
        behaviour = state.of[found[1]][1]['behaviour']
        return found[2] in (behaviour['text'], behaviour['origin'])
    found = re.fullmatch(rf'bound\(({NAME}), ({NAME})\)', text)
    if found:
        return any({found[1], found[2]} == set(bond['bodies']) for p in state.processes for bond in p['bonds'])
    found = re.fullmatch(rf'gone\(({NAME})\)', text)
    if found:
        return found[1] not in state.of
    found = re.fullmatch(r'event (\w+)(?:\(.*\))?', text)
    if found:
        # Of one kind, there may be an event of other bodies.
        return state.last == found[1] and ('(' not in text or None)
    found = re.fullmatch(r'(.+?) (<=|>=|<|>|=) (.+)', text)
    if found:
        left, right = value(state, found[1]), value(state, found[3])
        return None if left is None or right is None else COMPARED[found[2]](left, right)
    return None


def fact(state, text):
    """Whether a fact, such as 'x(p) >= 9 fails: x(p) = 6', is one; None if it is of a form that is not read."""
    found = re.fullmatch(r'(.+?) (holds|fails)(?:: (.+))?', text)
    if not found:
        return None
    claim, also = truth(state, found[1]), truth(state, found[3]) if found[3] else True
    if claim is None or also is None:
        return None
    return claim == (found[2] == 'holds') and also


def ended(run, state):
    """What is wrong with the time at the end of a run."""
    for line in run['ending'][:1]:
        said = re.search(rf'for example at time ({NUMBER})$', line) or re.search(
            rf'(?:ends at|, until) time ({NUMBER})$', line)
        if said and Fraction(said[1]) != state.time:
            yield f'it ends at {state.time}: {line}'


def started(run):
    """What is wrong with the start of a run."""
    said = dict(re.findall(rf'(\w+) = ({NUMBER})', run['check']['text'].partition(' for ')[2]))
    values = {name: Fraction(text) for name, text in run.get('values', {}).items()}
    for name, text in said.items():
        if name in values and values[name] != Fraction(text):
            yield f'it starts with {name} = {values[name]}: {run["check"]["text"]}'


def ends(root, data):
    """What is wrong with the ends of the runs in data of scc view, in words; how many facts were read, and of how many."""
    document = json.loads(data.read_text())
    answer = subprocess.run(['node', str(root / 'test/web/ends.js'), str(root / 'web'), str(data)],
                            capture_output=True, text=True)
    if answer.returncode != 0:
        return [answer.stderr], 0, 0
    wrong, read, all_facts = [], 0, 0
    for told in json.loads(answer.stdout):
        run, state = document['runs'][told['run']], State(told, document['solids'])
        found = [*ended(run, state), *started(run)]
        for text in run['facts']:
            all_facts += 1
            holds = fact(state, text)
            read += holds is not None
            if holds is False:
                found.append(f'this is not so at its end: {text}')
        wrong += [f'run {run["name"]}: {fault}' for fault in found]
    return wrong, read, all_facts
