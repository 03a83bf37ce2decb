#!/usr/bin/env python3
"""Estimates whose runs are made by other processes (`scc estimate --elsewhere` and `--make`): the bytes of `scc estimate`,
in however many parts the runs are made. And what is no run, or is missing.

    elsewhere_test.py SCC MODEL RARE

Both are models; that of rare events is for --levels.
"""

import json
import subprocess
import sys
import tempfile

passed = failed = 0


def tell(name, right):
    global passed, failed
    passed, failed = passed + right, failed + (not right)
    if not right:
        print('FAILED: ' + name)


def run(*command):
    return subprocess.run(command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE)


def made(scc, arguments, asked, parts):
    """The lines of the runs that are asked for."""
    wanted = asked['wanted']
    first, count = wanted['from'], wanted['to'] - wanted['from']
    for k in range(parts):
        bounds = first + k * count // parts, first + (k + 1) * count // parts
        done = run(scc, 'estimate', *arguments, '--make', '%d:%d-%d' % (wanted['turn'], *bounds))
        head, *lines = done.stdout.splitlines(keepends=True)
        tell('a part of the runs', done.returncode == 0 and json.loads(head)['of'] == asked['of'] and len(lines) == bounds[1] - bounds[0])
        yield from lines


def elsewhere(scc, arguments, answer):
    """What it writes, its exit code, and what it says; [answer] gives the lines for what is asked."""
    p = subprocess.Popen([scc, 'estimate', *arguments, '--elsewhere'], stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    text = b''
    for line in p.stdout:
        if not line.startswith(b'{"wanted":'):
            text = line + p.stdout.read()
            break
        for run in answer(json.loads(line)):
            p.stdin.write(run)
        p.stdin.flush()
        if answer is nothing:
            p.stdin.close()
    if not p.stdin.closed:
        p.stdin.close()
    said = p.stderr.read()
    return text, p.wait(), said


def nothing(asked):
    return []


def main():
    scc, path, rare = sys.argv[1:4]
    levels = [rare, '--property', 'P = ? [ eventually x(walker) >= 3 ]', '--levels', 'x(walker) >= 1..2', '--runs', '5']
    for parts, arguments in [(1, [path, '--runs', '20']), (3, [path, '--width', '1/4', '--json']), (2, levels)]:
        alone = run(scc, 'estimate', *arguments)
        found = elsewhere(scc, arguments, lambda asked: made(scc, arguments, asked, parts))
        tell(' '.join(arguments), found == (alone.stdout, alone.returncode, alone.stderr))
    with tempfile.TemporaryDirectory() as folder:
        kept = [path, '--runs', '12', '--store', folder]
        whole = elsewhere(scc, kept, lambda asked: made(scc, kept[:-2], asked, 2))
        tell('what is kept is not asked for again', elsewhere(scc, kept, lambda asked: 1 / 0) == whole)
    arguments = [path, '--runs', '20']
    for what, answer in [('nobody makes it', nothing), ('no run', lambda asked: [b'nonsense\n']), ('no marshalled run', lambda asked: [b'00' * 40 + b'\n'])]:
        text, code, said = elsewhere(scc, arguments, answer)
        tell('%s: %d, %s' % (what, code, said), code == 4 and b' 0 is lost' in said and bool(text))
    for what, options in [('no turn', ['--make', '9:0-1']), ('backwards', ['--make', '1:3-2']), ('no range', ['--make', 'x']),
                          ('both', ['--make', '1:0-1', '--elsewhere'])]:
        tell(what, run(scc, 'estimate', path, *options).returncode == 64)
    print('%d passed, %d failed' % (passed, failed))
    sys.exit(1 if failed else 0)


main()
