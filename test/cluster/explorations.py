"""Explorations on a cluster beside scc check, also while owners and nodes are killed."""

import glob
import json
import os
import tempfile
import time

import ray

from shapecalculus import cluster
from support import BONDS, HEXOKINASE, MODELS, at_random, later, plain, scc_bytes, tell

STATES = 3000


def checked(scc, path, folder):
    arguments = ['--no-reduce', 'order,draws', '--json', '--states', str(STATES), '--witness', folder]
    return json.loads(scc_bytes(scc, 'check', path, *arguments)[0])


def differences(report, there, folder):
    wrong = []
    undecided = [v.name for v in report.properties if v.reasons == ['it is more than a search']]
    # What is more than a search may end scc check earlier or later.
    if undecided and report.complete != there['explored']['complete']:
        return None
    for name in ('states', 'transitions', 'depth', 'complete'):
        if getattr(report, name) != there['explored'][name]:
            wrong.append('%s: %s, and check has %s' % (name, getattr(report, name), there['explored'][name]))
    verdicts = {p['name']: p['verdict'] for p in there['properties']}
    kinds = {name: v if isinstance(v, str) else v['kind'] for name, v in verdicts.items()}
    for v in report.properties:
        if v.name in undecided:
            continue
        if kinds[v.name] != v.kind:
            wrong.append('%s: %s, and check says %s' % (v.name, v.kind, kinds[v.name]))
        path = os.path.join(folder, v.name + '.json')
        if v.schedule is not None:
            with open(path, encoding='utf-8') as f:
                if json.load(f) != v.schedule:
                    wrong.append('%s: another run' % v.name)
    return wrong


def models(scc):
    compared, refused = 0, 0
    for path in sorted(glob.glob(os.path.join(MODELS, '*.sc'))):
        name = os.path.basename(path)
        with tempfile.TemporaryDirectory() as folder:
            try:
                report = cluster.check(path, owners=2, states=STATES, searches=True, scc=scc)
            except cluster.ClusterFailed as e:
                # A bound of time, or sets of states.
                print('%s: not served: %s' % (name, str(e).splitlines()[0]), flush=True)
                refused += 1
                continue
            wrong = differences(report, checked(scc, path, folder), folder)
        if wrong is None:
            print('%s: not compared: more than searches, which end it earlier or later' % name, flush=True)
            continue
        compared += 1
        tell(name, wrong)
    tell('%d models compared, %d not served' % (compared, refused), [] if compared >= 48 else ['too few'])


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

    # What was found is kept once a second: with levels 3 and 5 at least.
    def stop(p):
        if p.level in (2, 4):
            time.sleep(1.1)
        if p.level == 5:
            raise Stop
    with tempfile.TemporaryDirectory() as folder:
        # States of levels that were kept come up again, and the run that shows the verdict leads through these.
        path = os.path.join(folder, 'hexokinase.sc')
        with open(HEXOKINASE) as f, open(path, 'w') as copy:
            copy.write(f.read() + 'check second : possibly behaviour(atp[2]) = Adp\n')
        options = dict(owners=2, defines={'n': '3'}, scc=scc)
        expected = cluster.check(path, **options)
        kept = os.path.join(folder, 'kept')
        try:
            cluster.check(path, checkpoint=kept, progress=stop, **options)
        except Stop:
            pass
        files = sorted(os.listdir(os.path.join(kept, '1')))
        levels = []
        report = cluster.check(path, checkpoint=kept, progress=lambda p: levels.append(p.level), **options)
        same = plain(report) == plain(expected) and levels[0] == 6 and report.states == 309 and '1-3.shard' in files
        tell('resumed at level %d' % levels[0], [] if same else ['differs: %s, %s' % (files, plain(report))])
        for what, other in [('of another size', dict(options, defines={'n': '4'})), ('of other owners', dict(options, owners=3))]:
            refused(what, path, kept, other)
        damaged(path, kept, options)


def refused(what, path, folder, options):
    try:
        cluster.check(path, checkpoint=folder, **options)
        tell('a checkpoint ' + what, ['it is taken'])
    except cluster.ClusterFailed as e:
        said = str(e).replace(folder, '')
        tell('a checkpoint %s is refused: %s' % (what, said), [] if e.code == 3 else ['code %d' % e.code])


def damaged(path, folder, options):
    """Each damage by itself, and mended again."""
    def flipped(data):
        at = len(data) * 2 // 3
        return data[:at] + bytes([data[at] ^ 4]) + data[at + 1:]
    changes = [
        ('with a flipped bit', flipped), ('cut off', lambda data: data[:len(data) // 2]), ('emptied', lambda data: b''),
        ('of another version', lambda data: data.replace(b'scc-cluster 3', b'scc-cluster 2', 1)),
        ('with something else', lambda data: b'nonsense'), ('without it', None)]
    for file in ('1/1-3.shard', '1/1-5.shard', '1/manifest.json'):
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
    found = {}
    for owners in (1, 2):
        marks = []
        cluster.check(BONDS, owners=owners, defines={'n': '18'}, scc=scc,
                      progress=lambda p: marks.append((time.time(), p.states)))
        (t0, s0), (t1, s1) = marks[0], marks[-1]
        found[owners] = (s1 - s0) / (t1 - t0)
        print('chain of 18, %d owners: %.0f states/s' % (owners, found[owners]), flush=True)
    print('two owners over one: %.2f' % (found[2] / found[1]), flush=True)
