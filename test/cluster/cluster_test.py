"""Checks, simulations and sweeps on a cluster of Ray, beside those of scc: see `run`."""

import os
import signal
import sys
import time

import ray
from ray.cluster_utils import Cluster

from shapecalculus import cluster

import explorations
import losses
import spreading
import standing
import support
import troubles


def patiently(start):
    """Ray gives nodes half a minute to begin, which a busy machine may not do."""
    for _ in range(5):
        try:
            return start()
        except Exception as e:
            if 'timed out during startup' not in str(e):
                raise
    return start()


def with_nodes(scc, times):
    """Several nodes on this machine, of which one is killed."""
    several = patiently(lambda: Cluster(initialize_head=True, head_node_args={'num_cpus': 1, '_system_config': {
        'health_check_initial_delay_ms': 0, 'health_check_period_ms': 1000, 'health_check_failure_threshold': 5}}))

    def filled():
        while len(several.worker_nodes) < 2:
            patiently(lambda: several.add_node(num_cpus=1))

    def kill_node(rand, at, hits):
        def kill():
            # All of it at once, as when a machine loses its power. What has ended meanwhile is dead as well.
            if not several.worker_nodes:
                return
            node = rand.choice(sorted(several.worker_nodes, key=str))
            raylet = node.all_processes['raylet'][0].process.pid
            pids = [raylet, *support.children(raylet)]
            owners = sum('ray::Owner' in support.title(pid) for pid in pids)
            for pid in pids:
                support.killed(pid)
            several.remove_node(node, allow_graceful=False)
            hits.append('node')
            print('killed: a node with %d owners' % owners, flush=True)
        support.later(at, kill)
    try:
        filled()
        ray.init(address=several.address, log_to_driver=False, logging_level='error')
        explorations.killed(scc, 2, lambda e, rand, at: kill_node(rand, at, []), times, 4, filled)
        spreading.killed(scc, 4, lambda s, rand, at, hits: kill_node(rand, at, hits), max(2, times // 4), filled)
    finally:
        ray.shutdown()
        several.shutdown()


def main():
    scc = os.path.abspath(sys.argv[1])
    times = 4 if '--quick' in sys.argv else 20
    os.environ['RAY_IGNORE_UNHANDLED_ERRORS'] = '1'
    # A shell that starts this beside other work lets it ignore Ctrl-C, and so would all that is started here.
    signal.signal(signal.SIGINT, signal.default_int_handler)

    def here(test, *arguments):
        """With a cluster of this process."""
        cluster.connect(None, 120)
        try:
            test(scc, *arguments)
        finally:
            ray.shutdown()

    def alone(scc):
        explorations.resumed(scc)
        explorations.killed(scc, 1, explorations.kill_owner, times, 2)
        explorations.killed_by_chance(scc, max(3, times // 4))
        spreading.resumed(scc)
        spreading.killed(scc, 3, spreading.kill_task, max(3, times // 4))
        explorations.speed(scc)
    parts = {
        'commands': lambda: (troubles.commands(scc), spreading.commands(scc)),
        'addresses': lambda: troubles.addresses(scc),
        'checkpoints': lambda: troubles.checkpoints(scc),
        'interrupted': lambda: (troubles.interrupted_soon(scc), troubles.interrupted(scc)),
        'losses': lambda: losses.losses(scc, max(1, times // 10)),
        'standing': lambda: standing.cluster_stands(scc),
        'models': lambda: here(explorations.models),
        'chances': lambda: here(explorations.chances),
        'here': lambda: here(alone),
        'nodes': lambda: with_nodes(scc, times),
    }
    chosen = [a for a in sys.argv[2:] if a in parts] or list(parts)
    for name in chosen:
        begin = time.time()
        parts[name]()
        print('%s: %.0f s' % (name, time.time() - begin), flush=True)
    print('%d passed, %d failed' % (support.passed, support.failed))
    sys.exit(1 if support.failed else 0)


main()
