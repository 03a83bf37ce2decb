"""Checks on a cluster of Ray beside scc check: see `run`."""

import glob
import json
import os
import random
import subprocess
import sys
import tempfile
import threading
import time

import ray
from ray.cluster_utils import Cluster

from shapecalculus import cluster

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.join(HERE, '..', '..')
BONDS = os.path.join(ROOT, 'test', 'bench', 'checker', 'bonds.sc')
STATES = 3000
passed = failed = 0


def tell(name, wrong):
    global passed, failed
    passed, failed = passed + (not wrong), failed + bool(wrong)
    print('%s: %s' % (name, 'same' if not wrong else '; '.join(wrong)), flush=True)


def checked(scc, path, folder, arguments=()):
    command = [scc, 'check', path, '--no-reduce', 'order', '--json', '--states', str(STATES), '--witness', folder]
    return json.loads(subprocess.run(command + list(arguments), stdout=subprocess.PIPE).stdout)


def differences(report, there, folder):
    wrong = []
    if report.complete != there['explored']['complete'] and any(v.reasons == ['it is more than a search'] for v in report.properties):
        return None
    for name in ('states', 'transitions', 'depth', 'complete'):
        if getattr(report, name) != there['explored'][name]:
            wrong.append('%s: %s, and check has %s' % (name, getattr(report, name), there['explored'][name]))
    kinds = {p['name']: p['verdict'] if isinstance(p['verdict'], str) else p['verdict']['kind'] for p in there['properties']}
    for v in report.properties:
        if v.reasons == ['it is more than a search']:
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
    compared = []
    for path in sorted(glob.glob(os.path.join(ROOT, 'specs', 'models', '*.sc'))):
        with tempfile.TemporaryDirectory() as folder:
            there = checked(scc, path, folder)
            name = os.path.basename(path)
            try:
                report = cluster.check(path, owners=2, states=STATES, searches=True, scc=scc)
            except cluster.ClusterFailed as e:
                print('%s: not served: %s' % (name, str(e).splitlines()[0]), flush=True)
                continue
            wrong = differences(report, there, folder)
            if wrong is None:
                print('%s: not compared: more than searches, which end it earlier or later' % name, flush=True)
                continue
            compared.append(name)
            tell(name, wrong)
    tell('%d models compared' % len(compared), [] if len(compared) >= 40 else ['too few'])


def plain(report):
    return dict(report.__dict__, recovered=None)


def killed(scc, seed, kill, times, owners=2):
    """The same check again and again, while somebody kills at random instants."""
    rand = random.Random(seed)
    options = dict(owners=owners, defines={'n': '14'}, scc=scc)
    begun = []
    expected = cluster.check(BONDS, disturb=lambda e: begun.append(time.time()), **options)
    lasts = time.time() - begun[0]
    recovered = 0
    for k in range(times):
        with tempfile.TemporaryDirectory() as folder:
            at = rand.uniform(0.1, 0.9) * lasts
            report = cluster.check(BONDS, checkpoint=folder, disturb=lambda e: kill(e, rand, at), **options)
        recovered += report.recovered
        tell('killed %d, after %.2f of %.2f s, recovered %d' % (k, at, lasts, report.recovered),
             [] if plain(report) == plain(expected) else ['%s, and not %s' % (plain(report), plain(expected))])
    tell('%d recoveries' % recovered, [] if recovered >= times // 2 else ['too few to tell anything'])


def kill_owner(exploration, rand, at):
    owner = rand.randrange(2)
    threading.Timer(at, lambda: ray.kill(exploration.owners[owner])).start()


def resumed(scc):
    """What was kept by a check that was stopped is gone on with; a folder of another check is refused."""
    class Stop(Exception):
        pass

    def stop(p):
        if p.level == 5:
            raise Stop
    expected = cluster.check(BONDS, owners=2, defines={'n': '10'}, scc=scc)
    with tempfile.TemporaryDirectory() as folder:
        try:
            cluster.check(BONDS, owners=2, defines={'n': '10'}, scc=scc, checkpoint=folder, progress=stop)
        except Stop:
            pass
        levels = []
        report = cluster.check(BONDS, owners=2, defines={'n': '10'}, scc=scc, checkpoint=folder,
                               progress=lambda p: levels.append(p.level))
        tell('resumed at level %d' % levels[0], [] if plain(report) == plain(expected) and levels[0] == 6 else ['differs'])
        for what, other in [('of another size', dict(owners=2, defines={'n': '9'})), ('of other owners', dict(owners=3, defines={'n': '10'}))]:
            try:
                cluster.check(BONDS, scc=scc, checkpoint=folder, **other)
                tell(what, ['it is taken'])
            except cluster.ClusterFailed as e:
                tell('%s is refused: %s' % (what, e), [] if e.code == 3 else ['code %d' % e.code])


def command(scc, *arguments):
    done = subprocess.run([sys.executable, '-m', 'shapecalculus.cluster_command', 'check', *arguments, '--scc', scc],
                          stdout=subprocess.PIPE, stderr=subprocess.PIPE, universal_newlines=True)
    return done.returncode, done.stderr.strip().splitlines()[-1:]


def commands(scc):
    begin = time.time()
    code, said = command(scc, BONDS, '--address', '192.0.2.1:6379', '--deadline', '5')
    tell('no answer: %s' % said, [] if code == 69 and time.time() - begin < 30 else ['code %d' % code])
    code, said = command(scc, BONDS, '--address', '127.0.0.1:1', '--deadline', '5')
    tell('nobody there: %s' % said, [] if code == 69 else ['code %d' % code])
    for what, expected, arguments in [
            ('no model', 3, ['no.sc']), ('no property', 3, [BONDS, '--check', 'none']), ('no owners', 64, [BONDS, '--owners', '0']),
            ('more than a search', 64, [os.path.join(ROOT, 'specs', 'models', 'chain.sc')])]:
        code, said = command(scc, *arguments)
        tell('%s: %s' % (what, said), [] if code == expected else ['code %d' % code])


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


def nodes(scc, times):
    """Several nodes on this machine, of which one is killed."""
    def kill_node(exploration, rand, at):
        def kill():
            if len(several.worker_nodes) > 1:
                several.remove_node(rand.choice(sorted(several.worker_nodes, key=str)), allow_graceful=False)
        threading.Timer(at, kill).start()
    several = Cluster(initialize_head=True, head_node_args={'num_cpus': 1, '_system_config': {
        'health_check_initial_delay_ms': 0, 'health_check_period_ms': 1000, 'health_check_failure_threshold': 5}})
    try:
        for _ in range(3):
            several.add_node(num_cpus=1)
        ray.init(address=several.address, log_to_driver=False, logging_level='error')

        def with_nodes(exploration, rand, at):
            while len(several.worker_nodes) < 3:
                several.add_node(num_cpus=1)
            kill_node(exploration, rand, at)
        killed(scc, 2, with_nodes, times, owners=6)
    finally:
        ray.shutdown()
        several.shutdown()


def main():
    scc = os.path.abspath(sys.argv[1])
    times = 4 if '--quick' in sys.argv else 20
    commands(scc)
    ray.init(include_dashboard=False, log_to_driver=False, logging_level='error')
    models(scc)
    resumed(scc)
    killed(scc, 1, kill_owner, times)
    speed(scc)
    ray.shutdown()
    nodes(scc, max(2, times // 4))
    print('%d passed, %d failed' % (passed, failed))
    sys.exit(1 if failed else 0)


main()
