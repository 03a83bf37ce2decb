"""Explorations on a cluster beside scc check, also while owners and nodes are killed."""

import glob
import json
import os
import shutil
import tempfile
import time

import ray

from shapecalculus import _levels, cluster
from support import BONDS, HEXOKINASE, MODELS, at_random, later, plain, scc_bytes, tell

STATES = 3000


def checked(scc, path, folder, *options):
    arguments = ['--no-reduce', 'order,draws', '--json', '--states', str(STATES), '--witness', folder, *options]
    return json.loads(scc_bytes(scc, 'check', path, *arguments)[0])


def differences(report, there, folder):
    wrong = []
    # What is more than a search may end scc check earlier or later.
    early = there['explored']['decided_early'] and not all(is_search(p['formula']) for p in there['properties'])
    for name in ('states', 'transitions', 'complete', *(['depth'] if report.depth is not None else [])):
        if getattr(report, name) != there['explored'][name] and not early:
            wrong.append('%s: %s, and check has %s' % (name, getattr(report, name), there['explored'][name]))
    properties = {p['name']: p for p in there['properties']}
    for v in report.properties:
        said = properties[v.name]
        if (v.kind, v.values) != (said['verdict'], said.get('values')):
            wrong.append('%s: %s, and check says %s' % (v.name, v, said['text']))
        path = os.path.join(folder, v.name + '.json')
        if v.schedule is not None:
            with open(path, encoding='utf-8') as f:
                if json.load(f) != v.schedule:
                    wrong.append('%s: another run' % v.name)
    return wrong


def is_search(formula):
    return formula.startswith(('possibly', 'always', 'not possibly', 'not always'))


def models(scc):
    compared, refused = 0, 0
    for path in sorted(glob.glob(os.path.join(MODELS, '*.sc'))):
        name = os.path.basename(path)
        with tempfile.TemporaryDirectory() as folder:
            options, shortest = dict(owners=2, states=STATES, scc=scc), []
            try:
                report = cluster.check(path, **options)
            except cluster.ClusterFailed as e:
                # Sets of states.
                print('%s: not served: %s' % (name, str(e).splitlines()[0]), flush=True)
                refused += 1
                continue
            if report.depth is None:
                # It has bounds of time. Properties without them are explored in the same order by scc check.
                report, shortest = cluster.check(path, order='time', **options), ['--shortest', 'time']
            wrong = differences(report, checked(scc, path, folder, *shortest), folder)
        compared += 1
        tell(name, wrong)
    tell('%d models compared, %d not served' % (compared, refused), [] if compared >= 75 else ['too few'])


#: Models with probabilities or means.
CHANCES = [
    'anchored', 'association', 'brownian', 'court', 'crosslink', 'crowded', 'dissociation', 'exclusion', 'far', 'nook', 'ratchet',
    'ruin', 'ties']


def chances(scc):
    """Probabilities and means, with one owner or more, in step and without an order."""
    for name in CHANCES:
        path = os.path.join(MODELS, name + '.sc')
        with tempfile.TemporaryDirectory() as folder:
            there = {bounded: checked(scc, path, folder, *(['--shortest', 'time'] if bounded else [])) for bounded in (False, True)}
            for owners in (1, 2, 3):
                report = cluster.check(path, owners=owners, states=STATES, scc=scc)
                wrong = [w for w in differences(report, there[report.depth is None], folder) if 'another run' not in w]
                tell('%s, %d owners: %d numbers' % (name, owners, len(numbers(report))), wrong)
            try:
                free = cluster.check(path, owners=3, states=STATES, order='any', scc=scc)
            except cluster.NotServed:
                continue
            same = numbers(free) == numbers(report) or not free.complete
            tell('%s in any order' % name, [] if same else ['%s' % numbers(free)])


def numbers(report):
    return {v.name: v.values for v in report.properties if v.values is not None}


def killed_by_chance(scc, times):
    """Owners of a model with probabilities are killed, while they explore or gather the graph, and at the end."""
    path = os.path.join(MODELS, 'association.sc')
    for order in ('levels', 'any'):
        begun = []
        options = dict(owners=2, defines={'n': '8'}, order=order, scc=scc)
        expected = cluster.check(path, disturb=lambda e: begun.append(time.time()), **options)
        lasts, recovered = time.time() - begun[0], 0
        for k, rand, at in at_random(5, times, lasts):
            report = cluster.check(path, disturb=lambda e: kill_owner(e, rand, at), **options)
            recovered += report.recovered
            same = numbers(report) == numbers(expected) and len(numbers(report)) > 0
            same = same and [v.kind for v in report.properties] == [v.kind for v in expected.properties]
            tell('numbers, order %s: killed after %.2f of %.2f s, recovered %d' % (order, at, lasts, report.recovered),
                 [] if same else ['%s, and not %s' % (plain(report), plain(expected))])
        tell('%d recoveries' % recovered, [] if recovered >= times // 2 else ['too few to tell anything'])


def killed(scc, seed, kill, times, owners, before=lambda: None):
    """The same check again and again, while somebody kills at random instants. Its states come up again in later levels,
    so that an owner that has forgotten any is noticed."""
    options = dict(owners=owners, defines={'n': '5'}, states=30000, scc=scc)
    begun = []
    expected = cluster.check(HEXOKINASE, disturb=lambda e: begun.append(time.time()), **options)
    lasts = time.time() - begun[0]
    recovered = 0
    for k, rand, at in at_random(seed, times, lasts):
        before()
        with tempfile.TemporaryDirectory() as folder:
            report = cluster.check(HEXOKINASE, checkpoint=folder, disturb=lambda e: kill(e, rand, at), **options)
        recovered += report.recovered
        tell('check %d: killed after %.2f of %.2f s, recovered %d' % (k, at, lasts, report.recovered),
             [] if plain(report) == plain(expected) else ['%s, and not %s' % (plain(report), plain(expected))])
    tell('%d recoveries' % recovered, [] if recovered >= times // 2 else ['too few to tell anything'])


def kill_owner(exploration, rand, at):
    owner = rand.randrange(2)
    later(at, lambda: ray.kill(exploration.owners[owner]))


def resumed(scc):
    """What was kept by a check that was stopped is gone on with; a folder of another check is refused."""
    class Stop(Exception):
        pass

    with tempfile.TemporaryDirectory() as folder:
        # States of levels that were kept come up again, and the run that shows the verdict leads through these.
        path = os.path.join(folder, 'hexokinase.sc')
        with open(HEXOKINASE) as f, open(path, 'w') as copy:
            copy.write(f.read() + 'check second : possibly behaviour(atp[2]) = Adp\n')
        options = dict(owners=2, defines={'n': '5'}, states=150000, scc=scc)
        expected = cluster.check(path, **options)
        kept = os.path.join(folder, 'kept')
        files = os.path.join(kept, '1')

        def stop(p):
            # At least two files of each owner are to be read.
            if len(glob.glob(os.path.join(files, '1-*.shard'))) >= 2 and os.path.exists(os.path.join(files, 'manifest.json')):
                raise Stop
        every, _levels.EVERY = _levels.EVERY, 100
        try:
            cluster.check(path, checkpoint=kept, progress=stop, **options)
            tell('a check is stopped', ['it came to its end'])
        except Stop:
            pass
        finally:
            _levels.EVERY = every
        with open(os.path.join(files, 'manifest.json'), 'rb') as f:
            level = json.loads(f.read().split(b'\n', 1)[1])[1]['level']
        whole = os.path.join(folder, 'whole')
        shutil.copytree(kept, whole)
        levels = []
        report = cluster.check(path, checkpoint=kept, progress=lambda p: levels.append(p.level), **options)
        same = plain(report) == plain(expected) and levels[0] > level
        tell('resumed at level %d' % level, [] if same else ['differs: %s, %s' % (levels, plain(report))])
        for what, other in [('of another size', dict(options, defines={'n': '4'})), ('of other owners', dict(options, owners=3)),
                            ('with another bound', dict(options, states=150001))]:
            refused(what, path, whole, other)
        chain = sorted(int(name[2:-6]) for name in os.listdir(os.path.join(whole, '1')) if name.startswith('1-'))
        damaged(path, whole, options, ['1/1-%d.shard' % chain[0], '1/1-%d.shard' % level, '1/manifest.json'])


def refused(what, path, folder, options):
    try:
        cluster.check(path, checkpoint=folder, **options)
        tell('a checkpoint ' + what, ['it is taken'])
    except cluster.ClusterFailed as e:
        said = str(e).replace(folder, '')
        tell('a checkpoint %s is refused: %s' % (what, said), [] if e.code == 3 else ['code %d' % e.code])


def damaged(path, folder, options, files):
    """Each damage by itself, and mended again."""
    def flipped(data):
        at = len(data) * 2 // 3
        return data[:at] + bytes([data[at] ^ 4]) + data[at + 1:]
    changes = [
        ('with a flipped bit', flipped), ('cut off', lambda data: data[:len(data) // 2]), ('emptied', lambda data: b''),
        ('of another version', lambda data: data.replace(b'scc-cluster 4', b'scc-cluster 3', 1)),
        ('with something else', lambda data: b'nonsense'), ('without it', None)]
    for file in files:
        place = os.path.join(folder, file)
        with open(place, 'rb') as f:
            data = f.read()
        for what, change in changes:
            if change is not None:
                with open(place, 'wb') as f:
                    f.write(change(data))
            elif file.endswith('.shard'):
                os.remove(place)
            else:
                continue
            refused('%s: %s' % (file, what), path, folder, options)
            with open(place, 'wb') as f:
                f.write(data)


def speed(scc):
    """The chain of 20 and hexokinase of 5, beside one process of scc; the start of Ray is not a part of it."""
    for path, n in (BONDS, '20'), (HEXOKINASE, '5'):
        begin = time.time()
        scc_bytes(scc, 'check', path, '-D', 'n=' + n, '--no-reduce', 'order,draws', '--states', '100000000', '--jobs', '1')
        alone = time.time() - begin
        for owners in (1, 2):
            begun = []
            report = cluster.check(path, owners=owners, defines={'n': n}, scc=scc, disturb=lambda e: begun.append(time.time()))
            lasts = time.time() - begun[0]
            print('%s of %s, %d states: scc check %.1f s, %d owners %.1f s' % (
                os.path.basename(path), n, report.states, alone, owners, lasts), flush=True)
