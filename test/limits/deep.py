#!/usr/bin/env python3
"""Runs of many steps and models of many parts, on a small stack: whatever scc does is not deeper for them.

    test/limits/deep.py SCC [--depth D] [--parts N] [--stack KIB] [--whole] [--only TEXT] [--times]

Runs every command on runs of D steps, and on models with N processes, checks, definitions, vertices, levels of nesting,
under a stack of so many KiB (OCaml 5 has its own, of the same size). Each case ends with a documented exit code that is
expected of it, and none with 70. Prints a line for each that does not, and counts; with --times a line for each, and its
seconds. With --whole every large model goes through all commands that read one. By hand:
--depth 1000000 --parts 100000 --stack 1024 --whole.
"""

import argparse
import json
import os
import resource
import subprocess
import sys
import tempfile
import time

CUBE = 'shape C = box(1,1,1)\n'


def steered(d):
    """A run that never comes back, one state a step."""
    return f'''timestep 1
{CUBE}process p = C mass 1 velocity (1,0,0) [nil]
motion p = (vx, vy + dt, 0)
check never : always x(p) < {d}
check ever : possibly x(p) > {d - 1}
check waits : A[ x(p) < {d} U time >= {d} ]
check later : E[ x(p) >= 0 U (x(p) > {d - 2} and EF y(p) > {d * d // 2}) ]
check leads : x(p) = 1 leads_to x(p) > {d - 1}
check all : AG (x(p) < {d + 5} and AF x(p) > {d - 1})
'''


def lots(d):
    """A walk between two ends, whose states are as far apart as it is long."""
    return f'''timestep 1 steady
{CUBE}process p = box(1/4,1/4,1/4) mass 1 [nil]
fixed hi = box(1/4,1/4,1/4) absorb at translate ({d} + 1/4,0,0)
motion p = choose {{ (1,0,0) weight 1, (0,0,0) weight 1 }}
check sure : P >= 1 [ eventually gone(p) ]
check most : P >= 1/2 [ eventually x(p) > {d // 2} ]
check some : P = ? [ eventually event absorb(p, hi) ]
check mean : E = ? [ time U gone(p) ]
check again : AG EF gone(p)
'''


def beating(d):
    """Time passes by delays alone."""
    return f'''timestep 1
{CUBE}behaviour K on C = eps(1). K
process p = C mass 1 velocity (1,0,0) [K]
check never : always x(p) < {d}
check ever : possibly x(p) > {d - 1}
'''


def ranged(d):
    return f'''param u in [1, 2]
timestep 1
{CUBE}behaviour K on C = eps(u). K
process p = C mass 1 velocity (1,0,0) [K]
check never : always x(p) < {d}
check ever : possibly x(p) > {d - 1}
'''


def many(n, declared, asked=''):
    return f'timestep 1\n{CUBE}' + ''.join(declared(i) for i in range(n)) + asked


def process(i, behaviour='nil', velocity='(0,0,0)'):
    return f'process p{i} = C mass 1 velocity {velocity} at translate ({3 * i},0,0) [{behaviour}]\n'


NOTHING = 'process p = C mass 1 velocity (1,0,0) [nil]\n'
ON_ITS_OWN = CUBE + NOTHING


class Cases:
    """The cases of a depth and of a number of parts: name, command line, exit codes, what is read."""

    def __init__(self, folder, depth, parts, whole):
        self.folder, self.d, self.n, self.whole, self.list = folder, depth, parts, whole, []

    def file(self, name, text):
        path = os.path.join(self.folder, name)
        if not os.path.exists(path):
            with open(path, 'w') as out:
                out.write(text)
        return path

    def out(self, name):
        return os.path.join(self.folder, name)

    def add(self, name, *arguments, codes=(0, 1), stdin=None):
        self.list.append((name, [str(a) for a in arguments], codes, stdin))

    def runs(self):
        d, beyond = self.d, ['--states', 2 * self.d, '--depth', 2 * self.d]
        model = self.file('steered.sc', steered(d))
        checks = ['check', 'check --json', 'check --shortest time', 'check --hash-compact', 'check --coverage',
                  'check --stats', f'check --sarif {self.out("x.sarif")}', f'check --store {self.out("store")}',
                  f'check --store {self.out("store")}', 'check --full']
        together = f'check --full --coverage --stats --sarif {self.out("x.sarif")} --witness {self.out("runs")}'
        for check in (checks if self.whole else []) + [together]:
            self.add(check.replace(self.folder, ''), *check.split(), model, *beyond, codes=(0, 1, 2))
        endless = self.file('endless.sc', steered(d).split('check')[0] + 'check far : possibly x(p) > 1000000000\n')
        for check in ['check', f'check --store {self.out("endless")}', f'check --store {self.out("endless")}']:
            self.add('endless ' + check.replace(self.folder, ''), *check.split(), endless, '--states', d, codes=(2,))
        trace, csv = self.out('run.jsonl'), self.out('run.csv')
        self.add('trace', 'trace', model, '--steps', d, '-o', trace)
        self.add('trace --human', 'trace', model, '--steps', d, '--human', '-o', '/dev/null')
        self.add('trace --itf', 'trace', model, '--steps', d, '--itf', '-o', '/dev/null')
        self.add('trace --schedule', 'trace', model, '--schedule', trace, '-o', '/dev/null')
        self.add('trace of a witness', 'trace', model, '--schedule', self.out('runs/never.json'), '-o', '/dev/null')
        self.add('explain', 'explain', self.out('runs/never.json'))
        self.add('explain --json', 'explain', '--json', self.out('runs/later.json'))
        self.add('explain a trace', 'explain', trace, model, '--check', 'never')
        self.add('diff', 'diff', trace, trace)
        self.add('conform', 'conform', model, trace, '--states', 10 * d)
        self.add('conform --json', 'conform', '--json', model, trace, '--states', 10 * d, '--run', self.out('same.json'))
        self.add('export csv', 'export', model, '--steps', d, '--format', 'csv', '--observe', 'x(p)', '-o', csv)
        theirs = self.file('theirs.csv', 'time,event,bodies,x,y,z\n' + ''.join(
            f'{i},state,p,{i},{i * (i - 1) // 2},0\n' for i in range(d)))
        self.add('conform csv', 'conform', model, theirs, '--states', 10 * d, codes=(0, 1, 2))
        self.add('diff csv', 'diff', trace, theirs, codes=(0, 1))
        for ending in ['glb', 'x3d', 'simularium', 'pvd']:
            # A file for each instant: a few of them.
            few = ['--time', d // 2, '--every', max(1, d // 50)] if ending == 'pvd' else ['--steps', d]
            self.add(f'export {ending}', 'export', model, *few, '-o', self.out(f'run.{ending}'))
        self.add('export obj', 'export', model, '--steps', d, '--at', d // 2, '-o', self.out('run.obj'))
        for ending in ['dot', 'aut', 'drn', 'json', 'tra']:
            how = ['--format', 'json'] if ending == 'json' else []
            self.add(f'explore {ending}', 'explore', model, '-o', self.out(f'space.{ending}'), *how, '--states', d,
                     codes=(0, 2))
        self.add('explore --all-steps', 'explore', model, '--all-steps', '-o', self.out('steps.json'), '--states', d,
                 codes=(0, 2))
        for relation in ['strong', 'weak', 'branching', 'trace'] if self.whole else ['branching']:
            self.add(f'compare {relation}', 'compare', model, model, '--modulo', relation, '--states', d // 2,
                     codes=(0, 1, 2))
        beat = self.file('beating.sc', beating(d))
        beats = self.file('beats.sc', beating(d).replace('eps(1). K', 'eps(1). eps(1). K'))
        self.add('compare different', 'compare', beat, beats, '--states', d, codes=(0, 1, 2))
        # What tells them apart has 2 000 parts at most.
        k = d if self.whole else 400
        self.add('compare long', 'compare', self.aut('a.aut', k, 'a'), self.aut('b.aut', k, 'b'), codes=(1, 2))
        self.add('compare long traces', 'compare', self.aut('a.aut', k, 'a'), self.aut('b.aut', k, 'b'),
                 '--modulo', 'trace', codes=(1, 2))
        self.add('check beating', 'check', beat, *beyond, codes=(0, 1, 2))
        self.add('check beating unreduced', 'check', beat, *beyond, '--no-reduce', 'all', codes=(0, 1, 2, 64))
        self.add('check --prove', 'check', '--prove', beat, *beyond, codes=(0, 1, 2))
        self.add('simulate', 'simulate', model, '--runs', 2, '--observe', 'x(p)', '--every', max(1, d // 1000),
                 '--until', d, '--steps', 2 * d, '-o', '/dev/null')
        self.add('simulate dense', 'simulate', model, '--runs', 2, '--observe', 'x(p)', '--every', 1,
                 '--until', d, '--steps', 2 * d, '-o', '/dev/null')
        self.add('simulate summary', 'simulate', model, '--runs', 2, '--observe', 'x(p)', '--every', 1, '--until', d,
                 '--steps', 2 * d, '--summary', '--plot', self.out('plot.svg'), '-o', '/dev/null')
        many_runs = ['simulate', self.file('still.sc', CUBE + NOTHING), '--observe', 'x(p)', '--every', 1, '--until', 1,
                     '--format', 'jsonl']
        self.add('simulate runs', *many_runs, '--runs', d, '-o', self.out('runs.jsonl'))
        self.add('simulate --resume', *many_runs, '--runs', d + 5, '--resume', self.out('runs.jsonl'),
                 '-o', self.out('more.jsonl'))
        chance = self.file('chance.sc', lots(d if self.whole else d // 10))
        self.add('estimate', 'estimate', chance, '--check', 'some', '--runs', 2, '--steps', 4 * d, codes=(0, 1, 2))
        self.add('check chances', 'check', chance, '--states', 4 * d, '--seconds', 60, codes=(0, 1, 2, 4))
        self.add('sweep', 'sweep', self.file('swept.sc', 'param k = 1\n' + steered(d)), '-D', 'k=1',
                 '--states', 2 * d, codes=(0, 1, 2))
        self.add('sweep of many points', 'sweep', self.file('points.sc', 'param k = 1\n' + ON_ITS_OWN +
                 'check c : always x(p) < k\n'), '-D', f'k=1..{self.n // 10}', codes=(0, 1, 2))
        for how in [['--data'], []]:
            self.add('view ' + ' '.join(how), 'view', model, *how, '--check', 'never', '-o', self.out('page'), *beyond,
                     codes=(0, 1, 2))
        self.add('view --schedule', 'view', model, '--schedule', self.out('runs/never.json'), '-o', self.out('page'))
        self.add('view --trace', 'view', model, '--trace', trace, '-o', self.out('page'), codes=(0,))
        self.add('view --svg', 'view', model, '--schedule', self.out('runs/never.json'), '--svg', d // 2, '-o',
                 self.out('picture.svg'), codes=(0,))
        # Their time grows with the square of the depth.
        zones = self.file('ranged.sc', ranged(min(d, 20000) if self.whole else 300))
        self.add('check zones', 'check', zones, '--depth', 2 * d, '--seconds', 300, codes=(0, 1, 2, 4))
        self.add('check zones --where', 'check', '--where', zones, '--depth', 2 * d, '--seconds', 300,
                 codes=(0, 1, 2, 4))
        requests = [
            {'jsonrpc': '2.0', 'id': 1, 'method': 'load', 'params': {'text': steered(d)}},
            {'jsonrpc': '2.0', 'id': 2, 'method': 'run', 'params': {'model': 1, 'steps': d}},
        ]
        self.add('oracle', 'oracle', stdin=''.join(json.dumps(r) + '\n' for r in requests))

    def aut(self, name, length, last):
        path = self.out(name)
        if not os.path.exists(path):
            with open(path, 'w') as out:
                out.write(f'des (0,{length},{length + 1})\n')
                for i in range(length):
                    out.write(f'({i},"{last if i == length - 1 else "x"}",{i + 1})\n')
        return path

    def models(self):
        n = self.n
        apart = many(n, process, 'check c : always x(p0) < 5\n')
        large = {
            'processes': apart,
            'family': f'{CUBE}for i in 0..{n - 1} {{ process q[i] = C mass 1 at translate (3*i,0,0) [nil] }}\n'
                      'check c : always count(p in q : x(p) < 0) = 0\n',
            'kinds': many(n, lambda i: f'shape S{i} = box({i + 1},1,1)\n') + NOTHING + 'check c : always x(p) < 5\n',
            'behaviours': many(n, lambda i: f'behaviour B{i} on C = eps(1). B{(i + 1) % n}\n') +
            'process p = C mass 1 [B0]\ncheck c : always x(p) < 5\n',
            'summands': f'{CUBE}behaviour B on C = ' + ' + '.join(f'eps({i + 1}). nil' for i in range(n)) +
            '\nprocess p = C mass 1 [B]\ncheck c : always x(p) < 5\n',
            'prefixes': f'{CUBE}behaviour B on C = ' + 'eps(1). ' * n + 'nil\nprocess p = C mass 1 [B]\n'
                        'check c : always x(p) < 5\n',
            'lets': many(n, lambda i: f'let v{i} = {f"v{i - 1} + 1" if i else 0}\n') + NOTHING +
            f'check c : always x(p) < v{n - 1} or true\n',
            'checks': ON_ITS_OWN + ''.join(f'check c{i} : always x(p) < {i}\n' for i in range(n)),
            'conjuncts': ON_ITS_OWN + 'check c : always (' + ' and '.join(f'x(p) > -{i + 1}' for i in range(n)) + ')\n',
            'disjuncts': ON_ITS_OWN + 'check c : ' + ' or '.join(f'possibly x(p) < -{i + 1}' for i in range(n)) + '\n',
            'terms': ON_ITS_OWN + 'check c : always x(p) < ' + ' + '.join('1' for _ in range(n)) + '\n',
            'parentheses': ON_ITS_OWN + 'check c : always x(p) < ' + '(' * n + '1' + ')' * n + '\n',
            'nots': ON_ITS_OWN + 'check c : always ' + 'not ' * n + 'x(p) < 1\n',
            'operators': ON_ITS_OWN + 'check c : ' + 'AG EF ' * n + 'x(p) < 1\n',
            'conditions': ON_ITS_OWN + 'motion p = (' + 'if x > 1 then 1 else ' * n + '0, 0, 0)\n'
                                       'check c : always x(p) < 5\n',
            'scaled': f'{CUBE}shape S = C' + ' scaled (1,1,1)' * n + '\n' + NOTHING + 'check c : always x(p) < 5\n',
            'comment': '// ' + 'x' * (10 * n) + '\n' + ON_ITS_OWN + 'check c : always x(p) < 5\n',
            'comments': ON_ITS_OWN + '// x\n' * n + 'check c : always x(p) < 5\n',
            'aliases': many(n, lambda i: f'behaviour B{i} on C = ' + (f'B{i + 1}' if i < n - 1 else 'eps(1). nil') + '\n') +
            'process p = C mass 1 [B0]\ncheck c : always x(p) < 5\n',
            'ranges': CUBE + 'for ' + ', '.join(f'i{i} in 1..1' for i in range(n)) + ' { process p[i0] = C mass 1 [nil] }\n'
                      'check c : always x(p[1]) < 5\n',
            'line': ON_ITS_OWN + ' '.join(f'check c{i} : always x(p) < {i}' for i in range(n)) + '\n',
            'digits': ON_ITS_OWN + 'check c : always x(p) < ' + '9' * n + '\n',
            'faults': ON_ITS_OWN + ''.join(f'check c{i} : always x(q{i}) < {i}\n' for i in range(n)),
            'garbage': ')' * n + '\n',
            'transforms': CUBE + 'process p = C mass 1 ' + ' '.join(['at translate (1,0,0)'] * n) + ' [nil]\n',
            'names': CUBE + 'process ' + 'p' * n + ' = C mass 1 [nil]\n',
            'parts': CUBE + 'process p = C mass 1 [nil]' + ''.join(
                f' <a, {{p.x}}>\n C mass 1 at translate ({2 * i + 2},0,0) [nil]' for i in range(n)) + '\n',
            'weights': f'timestep 1\n{CUBE}process p = C mass 1 [nil]\nmotion p = choose {{ ' +
                       ', '.join(f'({i},0,0) weight 1' for i in range(n)) + ' }\ncheck c : always time < 1\n',
        }
        allowed = (0, 1, 2, 3, 4)
        for name, text in large.items():
            path = self.file(name + '.sc', text)
            limits = ['--seconds', 30]
            self.add(f'check {name}', 'check', path, *limits, codes=allowed)
            if not self.whole:
                continue
            self.add(f'check --json {name}', 'check', '--json', path, *limits, codes=allowed)
            self.add(f'fmt {name}', 'fmt', path, codes=(0, 3))
            self.add(f'translate {name}', 'translate', path, '--to', 'xml', '-o', self.out(name + '.xml'), codes=(0, 3))
            self.add(f'trace {name}', 'trace', path, '--steps', 5, '-o', self.out('few.jsonl'), codes=(0, 3))
        body = self.file('processes.sc', apart)
        self.add('view processes', 'view', body, '-o', self.out('page'), codes=(0, 1, 2))
        self.add('export processes', 'export', body, '--steps', 5, '-o', self.out('bodies.glb'))
        self.add('explore processes', 'explore', body, '-o', self.out('bodies.json'), '--format', 'json', codes=(0, 2))
        self.add('simulate processes', 'simulate', body, '--runs', 2, '--observe', 'x(p0)', '--every', 1, '--until', 2,
                 '-o', '/dev/null')
        self.add('compare processes', 'compare', body, body, codes=(0, 1, 2))
        self.add('json deep', 'trace', body, '--schedule', self.file('deep.json', '[' * n + ']' * n), codes=(3,))
        self.add('oracle deep', 'oracle', stdin='[' * n + ']' * n + '\n')
        self.add('xml deep', 'check', self.file('deep.xml', '<a>' * n + '</a>' * n), codes=(3,))
        self.add('shape off', 'shape', self.file('prism.off', prism(min(n, 2000))), codes=(0, 3))
        self.add('shape bad', 'shape', self.file('flat.obj', ''.join(
            f'v {i} 0 0\nv {i} 1 0\nv {i} 0 1\nf {3 * i + 1} {3 * i + 2} {3 * i + 3}\n' for i in range(n))), codes=(3,))
        self.add('decompose', 'decompose', self.file('prism.off', prism(min(n, 200))), '-o', self.out('parts.sc'),
                 codes=(0, 3))


def prism(n):
    """A regular prism of n sides, nearly."""
    import math
    points = [(round(10000 * math.cos(2 * math.pi * i / n)), round(10000 * math.sin(2 * math.pi * i / n)))
              for i in range(n)]
    lines = ['OFF', f'{2 * n} {n + 2} 0'] + [f'{x} {y} {z}' for z in (0, 1) for x, y in points]
    lines.append(f'{n} ' + ' '.join(str(i) for i in reversed(range(n))))
    lines.append(f'{n} ' + ' '.join(str(n + i) for i in range(n)))
    lines += [f'4 {i} {(i + 1) % n} {n + (i + 1) % n} {n + i}' for i in range(n)]
    return '\n'.join(lines) + '\n'


def main():
    options = argparse.ArgumentParser()
    options.add_argument('scc')
    options.add_argument('--depth', type=int, default=10000)
    options.add_argument('--parts', type=int, default=300)
    options.add_argument('--stack', type=int, default=224)
    options.add_argument('--only', default='')
    options.add_argument('--whole', action='store_true')
    options.add_argument('--times', action='store_true')
    options.add_argument('--limit', type=float, default=500)
    given = options.parse_args()
    environment = dict(os.environ, OCAMLRUNPARAM=f'l={given.stack * 128}', TERM='dumb')

    def small():
        resource.setrlimit(resource.RLIMIT_STACK, (given.stack * 1024, given.stack * 1024))

    passed = failed = 0
    with tempfile.TemporaryDirectory() as folder:
        cases = Cases(folder, given.depth, given.parts, given.whole)
        cases.runs()
        cases.models()
        for name, arguments, codes, stdin in cases.list:
            # Later cases read what these write.
            if given.only not in name and name not in ('trace', 'export csv', 'simulate runs') and '--witness' not in name:
                continue
            begun = time.time()
            try:
                done = subprocess.run([given.scc] + arguments, input=(stdin or '').encode(), capture_output=True,
                                      preexec_fn=small, env=environment, timeout=given.limit)
                code, told = done.returncode, done.stderr.decode(errors='replace')
                if name.startswith('oracle') and b'"code":-32603' in done.stdout.replace(b' ', b''):
                    code, told = 70, done.stdout.decode()[-300:]
            except subprocess.TimeoutExpired:
                code, told = 'none', f'not done after {given.limit:g} s'
            seconds = time.time() - begun
            if code in codes:
                passed += 1
            else:
                failed += 1
                print(f'{name}: exit code {code}: {told[:300].strip()}', flush=True)
            if given.times:
                print(f'{seconds:7.2f} s  {code}  {name}', flush=True)
    print(f'{passed} passed, {failed} failed')
    sys.exit(1 if failed else 0)


if __name__ == '__main__':
    main()
