"""Simulations, sweeps and estimates on a cluster beside those of scc, also while tasks are killed."""

import json
import os
import tempfile
import time

import ray

import shapecalculus
from shapecalculus import cluster
from support import at_random, children, command, later, model, scc_bytes, tell, title
from support import killed as killed_now

WALKS = ['--observe', 'gone(walker)', '--observe', 'x(walker)', '--every', '1', '--until', '60', '--seed=-3']
BONDED = ['--observe', 'x(ligand)', '--observe', 'bound(ligand, pocket)', '--every', '1', '--until', '12']
GRID = ['-D', 'atp_arrives=1,2,3', '-D', 'glucose_arrives=1:4:1/2']


def asked():
    """Commands, of which all are held against scc."""
    yield ['simulate', model('brownian.sc'), *BONDED, '--runs', '150', '--seed', '5']
    yield ['simulate', model('brownian.sc'), *BONDED, '--runs', '90', '--summary', '--quantiles', '0,1/3,1', '--format', 'jsonl']
    yield ['simulate', model('ruin.sc'), *WALKS, '--runs', '70', '--steps', '3', '--decimals', '3', '--format', 'jsonl']
    yield ['sweep', model('hexokinase.sc'), *GRID]
    yield ['sweep', model('gas.sc'), '-D', 'n=1..3', '--states', '20']
    yield ['estimate', model('ruin.sc'), '--width', '1/10', '--seed', '7']
    yield ['estimate', model('brownian.sc'), '--runs', '40', '--json']
    yield ['estimate', model('association.sc'), '--check', 'by_three', '--check', 'mean_at_3', '--width', '1/5']
    yield ['estimate', model('ruin.sc'), '--property', 'P = ? [ eventually x(walker) >= 3 ]', '--levels', 'x(walker) >= 1..2', '--runs', '9']
    yield ['estimate', model('ruin.sc'), '--check', 'nobody']
    yield ['estimate', model('ruin.sc'), '--runs', '0']
    yield ['estimate', 'nothing.sc', '--json']
    yield ['sweep', model('ruin.sc'), '-D', 'nobody=1']
    yield ['sweep', 'nothing.sc', '-D', 'n=1']
    yield ['simulate', model('ruin.sc'), '--runs', '3', '--observe', 'x(nobody)', '--every', '1', '--until', '2']
    yield ['simulate', model('ruin.sc'), '--runs', '3', '--observe', 'x(walker)', '--every', '0', '--until', '2']


def commands(scc):
    for arguments in asked():
        expected, code = scc_bytes(scc, *arguments)
        found_code, found, said = command(scc, *arguments)
        wrong = [] if found == expected else ['another text']
        wrong += [] if found_code == code else ['code %d, and not %d: %s' % (found_code, code, said)]
        tell('scc-cluster %s, code %d' % (' '.join([arguments[0], os.path.basename(arguments[1]), *arguments[2:]]), code), wrong)


def long_simulation(scc):
    """What takes some seconds, and what scc says of it."""
    path, options = model('brownian.sc'), dict(runs=2000, observe=['x(ligand)'], every=1, until=40)
    arguments = ['--runs', '2000', '--observe', 'x(ligand)', '--every', '1', '--until', '40']
    expected = scc_bytes(scc, 'simulate', path, *arguments)[0].decode()
    return expected, lambda **more: cluster.simulate(path, scc=scc, **options, **more)


def long_sweep(scc):
    path, grid = model('hexokinase.sc'), {'atp_arrives': list(range(1, 9)), 'glucose_arrives': list(range(1, 9))}
    expected = shapecalculus.sweep(path, grid, scc=scc)
    return expected, lambda **more: cluster.sweep(path, grid, scc=scc, **more)


def long_estimation(scc):
    path, options = model('brownian.sc'), ['--property', 'P = ? [ eventually bound(ligand, pocket) within 30 ]', '--width', '1/20']
    expected = json.loads(scc_bytes(scc, 'estimate', path, *options, '--json')[0])
    return expected, lambda **more: cluster.estimate(path, options=options, scc=scc, **more)


def killed(scc, seed, kill, times, before=lambda: None):
    works = [('simulation', long_simulation(scc)), ('sweep', long_sweep(scc)), ('estimate', long_estimation(scc))]
    for what, (expected, work) in works:
        begun, again = [], 0
        wrong = [] if work(disturb=lambda s: begun.append(time.time())) == expected else ['differs']
        lasts = time.time() - begun[0]
        tell('%s of %.1f s' % (what, lasts), wrong)
        for k, rand, at in at_random(seed, times, lasts):
            hits = []
            before()
            found = work(disturb=lambda s: kill(s, rand, at, hits))
            again += len(hits)
            tell('%s %d: killed after %.2f of %.2f s: %s' % (what, k, at, lasts, ', '.join(hits)),
                 [] if found == expected else ['differs'])
        tell('%d of %d kills of the %s hit' % (again, times, what), [] if again >= times // 2 else ['too few'])


def kill_task(spread, rand, at, hits):
    """A process of Ray that works at a part, or the scc that it waits for."""
    node = ray._private.worker._global_node
    raylet = node.all_processes['raylet'][0].process.pid

    def kill():
        workers = [p for p in children(raylet) if title(p).startswith(('ray::do_part', 'ray::do_runs'))]
        programs = [p for w in workers for p in children(w) if any(word in title(p) for word in (' --part ', ' --make '))]
        targets = programs if rand.random() < 0.5 and programs else workers
        if targets:
            target = rand.choice(sorted(targets))
            if killed_now(target):
                hits.append('scc' if target in programs else 'worker')
    later(at, kill)


def resumed(scc):
    """Stopped in the middle, and gone on with; what was done is not done again."""
    class Stop(Exception):
        pass

    def stop(p):
        if p.done > p.all // 3:
            raise Stop
    for what, (expected, work) in [('simulation', long_simulation(scc)), ('sweep', long_sweep(scc))]:
        with tempfile.TemporaryDirectory() as folder:
            try:
                work(checkpoint=folder, progress=stop)
            except Stop:
                pass
            kept = len([f for f in os.listdir(folder) if f.endswith('.part')])
            begun = []
            found = work(checkpoint=folder, progress=lambda p: begun.append(p.done / p.all))
            wrong = [] if found == expected else ['differs']
            wrong += [] if kept > 5 and begun[0] > 0.3 else ['it begins anew']
            tell('%s goes on with %d parts' % (what, kept), wrong)
            other_work(scc, what, folder)
            damaged(what, folder, work)


def other_work(scc, what, folder):
    code, out, said = command(scc, 'sweep', model('hexokinase.sc'), '-D', 'atp_arrives=1', '--checkpoint', folder)
    tell('the checkpoint of another %s: %s' % (what, said.replace(folder, '')), [] if code == 3 and not out else ['code %d' % code])


def damaged(what, folder, work):
    for file in ('7.part', 'parts.json'):
        path = os.path.join(folder, file)
        with open(path, 'rb') as f:
            data = f.read()
        for change in (data[:-3], data[:-20] + bytes([data[-20] ^ 1]) + data[-19:]):
            with open(path, 'wb') as f:
                f.write(change)
            try:
                work(checkpoint=folder)
                tell('a damaged checkpoint', ['it is taken'])
            except cluster.ClusterFailed as e:
                tell('%s: %s' % (what, str(e).replace(folder, '')), [] if e.code == 3 else ['code %d' % e.code])
        with open(path, 'wb') as f:
            f.write(data)
