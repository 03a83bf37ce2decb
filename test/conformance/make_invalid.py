"""Cases of inputs that are refused or warned of: specs/conformance/invalid, as far as the protocol can ask them."""

import os
import re

from cases import HAND, Suite, files_of, result

PLACE = re.compile(r'^(\S+):(\d+):(\d+): (error|warning)\[(SC\d{4})\]', re.M)
BARE = re.compile(r'^(?:\S+: |command line: )?(error|warning)\[(SC\d{4})\]', re.M)
EXIT = re.compile(r'^exit (\d+)$', re.M)
# Read by a command, or found by exploring: no request loads them.
ONLY_COMMANDS = ('SC0602', 'SC0603', 'SC0604', 'SC0702', 'SC0703', 'SC0704', 'SC0705', 'SC0706', 'SC0801', 'SC0802', 'SC0920', 'SC0921',
                 'SC0922', 'SC0923', 'SC0924')


def read(folder, file):
    with open(os.path.join(folder, file), 'rb') as f:
        return f.read()


def pattern(file, out):
    """What is said, in order: codes, and places in the model itself."""
    found = []
    for line in out.split('\n'):
        placed, bare = PLACE.match(line), BARE.match(line)
        if placed:
            at = {'line': int(placed.group(2)), 'column': int(placed.group(3))}
            entry = {'code': placed.group(5), 'severity': placed.group(4)}
            if placed.group(1) == file:
                entry['place'] = {'start': at}
            found.append(entry)
        elif bare:
            found.append({'code': bare.group(2), 'severity': bare.group(1)})
    return found


def suite(folder):
    """The cases, which codes they are of, and the inputs of commands."""
    folder = os.path.join(folder, 'invalid')
    s = Suite('invalid/cases.json', 'Models that are refused, or loaded with a warning: codes and places.',
              'read by hand: the .out file of that name')
    codes, commands = {}, []
    for file in sorted(f for f in os.listdir(folder) if f.endswith(('.sc', '.xml', '.osc'))):
        name, code = os.path.splitext(file)[0], file[:6]
        out = read(folder, name + '.out').decode(errors='replace')
        arguments = read(folder, name + '.args').decode().strip() if os.path.exists(
            os.path.join(folder, name + '.args')) else 'check {}'
        entry = codes.setdefault(code, {'cases': [], 'commands': []})
        commands.append({'code': code, 'input': 'invalid/' + file, 'arguments': arguments,
                         'exit': int(EXIT.search(out).group(1)), 'says': 'invalid/%s.out' % name})
        entry['commands'].append('invalid/' + file)
        if file.endswith('.osc'):  # a notation that is told by the name of a file, and a request has none
            continue
        try:
            model = read(folder, file).decode()
        except UnicodeDecodeError:
            continue
        params = {'text': model, 'files': files_of(folder, model)}
        if not params['files']:
            del params['files']
        if arguments == 'check -D m=3 {}':
            params['parameters'] = {'m': 3}
        elif arguments != 'check {}':
            continue
        if code in ONLY_COMMANDS:
            continue
        said = pattern(file, out)
        errors = [d for d in said if d['severity'] == 'error']
        if errors:
            expect = {'error': {'code': -32003, 'data': {'diagnostics': {'some': errors}}}}
        else:
            expect = result(warnings={'some': said})
        s.add(name, [], 'model.load', params, expect)
        entry['cases'].append('invalid/cases/' + name)
    more(s, codes, commands)
    return s, codes, commands


def more(s, codes, commands):
    """Codes that have no file of their own."""
    deep = 'check c : always ' + '(' * 1001 + 'true' + ')' * 1001 + '\n'
    s.add('SC0111-deep', [], 'model.load', {'text': deep}, {'error': {'code': -32003, 'data': {'diagnostics': {
        'some': [{'code': 'SC0111', 'severity': 'error'}]}}}}, HAND)
    codes['SC0111'] = {'cases': ['invalid/cases/SC0111-deep'], 'commands': []}

