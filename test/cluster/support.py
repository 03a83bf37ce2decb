"""What all tests on a cluster have in common."""

import json
import os
import random
import signal
import subprocess
import sys
import threading
import time

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.join(HERE, '..', '..')
MODELS = os.path.join(ROOT, 'specs', 'models')
BONDS = os.path.join(ROOT, 'test', 'bench', 'checker', 'bonds.sc')
HEXOKINASE = os.path.join(ROOT, 'test', 'bench', 'checker', 'hexokinase.sc')
passed = failed = 0


def tell(name, wrong):
    """One that passed if nothing is wrong."""
    global passed, failed
    passed, failed = passed + (not wrong), failed + bool(wrong)
    print('%s: %s' % (name, 'same' if not wrong else 'FAILED: ' + '; '.join(wrong)), flush=True)


def model(name):
    return os.path.join(MODELS, name)


def scc_bytes(scc, *arguments):
    """What scc writes, and its exit code."""
    done = subprocess.run([scc, *arguments], stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    return done.stdout, done.returncode


def command(scc, *arguments, **options):
    """Exit code, standard output, and the last line on standard error of scc-cluster."""
    done = subprocess.run(in_words(scc, *arguments), stdout=subprocess.PIPE, stderr=subprocess.PIPE, **options)
    said = done.stderr.decode(errors='replace').strip().splitlines()
    return done.returncode, done.stdout, said[-1] if said else ''


def in_words(scc, what, *arguments):
    return [os.path.join(os.path.dirname(sys.executable), 'scc-cluster'), what, *arguments, '--scc', scc]


def plain(report):
    return dict(report.__dict__, recovered=None, seconds=None)


def children(pid):
    """Of a process, with theirs."""
    of = {}
    for entry in os.listdir('/proc'):
        if entry.isdigit():
            try:
                with open('/proc/%s/stat' % entry) as f:
                    of.setdefault(int(f.read().rsplit(')', 1)[1].split()[1]), []).append(int(entry))
            except OSError:
                pass
    found, left = [], [pid]
    while left:
        more = of.get(left.pop(), [])
        found += more
        left += more
    return found


def title(pid):
    try:
        with open('/proc/%d/cmdline' % pid, 'rb') as f:
            return f.read().replace(b'\0', b' ').decode(errors='replace').strip()
    except OSError:
        return ''


def there(pids):
    """Those that have not ended."""
    def lives(pid):
        try:
            with open('/proc/%d/stat' % pid) as f:
                return f.read().rsplit(')', 1)[1].split()[0] != 'Z'
        except OSError:
            return False
    return [p for p in pids if lives(p)]


def killed(pid):
    """Whether there was still a process to be killed: what is chosen may end by itself meanwhile."""
    try:
        os.kill(pid, signal.SIGKILL)
        return True
    except ProcessLookupError:
        return False


def awaited(condition, seconds):
    """Whether it comes true in time."""
    end = time.time() + seconds
    while time.time() < end:
        if condition():
            return True
        time.sleep(0.05)
    return False


def at_random(seed, times, lasts):
    """Numbers, and instants of something that lasts so long."""
    rand = random.Random(seed)
    for k in range(times):
        yield k, rand, rand.uniform(0.05, 0.95) * lasts


def later(seconds, what):
    timer = threading.Timer(seconds, what)
    timer.daemon = True
    timer.start()


def report_of(output):
    return dict(json.loads(output), recovered=None)
