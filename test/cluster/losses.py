"""What is lost while a command runs: Ray's own processes, the worker of the command, those that do its work, the
streams that it has; and signals meanwhile. There is the right answer or none, and nothing is left."""

import os
import random
import signal
import subprocess
import tempfile
import time

import support
from support import BONDS, awaited, children, command, in_words, model, report_of, scc_bytes, tell, there, title

CHECK = ['check', BONDS, '-D', 'n=20', '--owners', '2', '--json']
RUNS = ['--runs', '1500', '--observe', 'x(ligand)', '--every', '1', '--until', '40']
SIMULATE = ['simulate', model('brownian.sc'), *RUNS]
SWEEP = ['sweep', model('hexokinase.sc'), '-D', 'atp_arrives=1..12', '-D', 'glucose_arrives=1..12']
#: By the title of a process. The work is done by owners and tasks, and by their scc.
TARGETS = {
    'raylet': lambda words: words[0].endswith('/raylet'),
    'gcs': lambda words: words[0].endswith('/gcs_server'),
    'worker': lambda words: any(w.endswith('/scc-cluster') for w in words[:3]),
    'owner or task': lambda words: words[0].startswith(('ray::Owner', 'ray::do_part')),
    'scc': lambda words: 'successors' in words or '--part' in words,
}


class Expected:
    """What a command writes and its exit code, when nothing is lost."""

    def __init__(self, scc):
        self.scc, self.known = scc, {}

    def of(self, arguments):
        name = arguments[0]
        if name not in self.known:
            if name == 'check':
                code, out, _ = command(self.scc, *arguments)
                self.known[name] = report_of(out), code
            else:
                self.known[name] = scc_bytes(self.scc, *arguments)
        return self.known[name]

    def wrong(self, arguments, code, out, begun=True):
        """Of a command that has begun to work, or that may have been hit while Ray started."""
        text, finished = self.of(arguments)
        if code in (0, 1, 2):
            same = code == finished and (report_of(out) if arguments[0] == 'check' else out) == text
            return [] if same else ['code %d, with another report' % code]
        prefix = out == b'' if arguments[0] == 'check' else text.startswith(out)
        return ([] if code == 4 or code == 69 and not begun else ['code %d' % code]) + ([] if prefix else ['it writes what scc does not'])


def started(scc, arguments, at_work):
    """A command, whose work has begun if that is wanted. What it writes is in a file: a pipe would hold it up."""
    out = tempfile.TemporaryFile()
    p = subprocess.Popen(in_words(scc, *arguments), stdout=out, stderr=subprocess.PIPE, start_new_session=True)
    if at_work:
        begun = ('ray::Owner', 'ray::do_part')
        awaited(lambda: p.poll() is not None or any(title(k).startswith(begun) for k in children(p.pid)), 120)
    return p, out


def victim_of(p, target, rand):
    """None if the command ends before there is any."""
    while p.poll() is None:
        found = [k for k in children(p.pid) if TARGETS[target]((title(k) or '-').split())]
        if found:
            return rand.choice(sorted(found))
        time.sleep(0.02)
    return None


def ended(p, written, all_of_it, within):
    """What it has written, the last that it says, and what is wrong with its end."""
    try:
        said = p.communicate(timeout=within)[1]
    except subprocess.TimeoutExpired:
        os.killpg(p.pid, signal.SIGKILL)
        for pid in there(all_of_it):
            support.killed(pid)
        return b'', '', ['it has not ended within %.0f s' % within]
    written.seek(0)
    out = written.read()
    written.close()
    left = [] if awaited(lambda: not there(all_of_it), 20) else ['processes are left']
    return out, (said.decode(errors='replace').strip().splitlines() or [''])[-1][:100], left


def killed(scc, expected, times):
    rand = random.Random(5)
    for k in range(times):
        for target in TARGETS:
            for arguments in (CHECK, SIMULATE, SWEEP):
                at_work = rand.random() < 0.8
                p, written = started(scc, arguments, at_work)
                at = rand.uniform(0, 5)
                time.sleep(at)
                victim, all_of_it = victim_of(p, target, rand), children(p.pid)
                hit = victim is not None and support.killed(victim)
                out, said, wrong = ended(p, written, all_of_it, 240)
                wrong = wrong or expected.wrong(arguments, p.returncode, out, at_work)
                when = '%.1f s after %s' % (at, 'its work began' if at_work else 'its start')
                what = '%s %d: %s killed %s' % (arguments[0], k, target if hit else 'nothing', when)
                tell('%s, code %s: %s' % (what, p.returncode, said), wrong)


def signalled(scc, expected, times):
    """Heard soon, at any moment; also when Ray waits for what is lost."""
    rand = random.Random(6)
    for k in range(times):
        for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
            for arguments in (CHECK, SIMULATE, SWEEP):
                p, written = started(scc, arguments, True)
                lost = rand.random() < 0.5 and victim_of(p, rand.choice(['raylet', 'gcs']), rand)
                all_of_it = children(p.pid)
                if lost and support.killed(lost):
                    time.sleep(rand.uniform(0, 10))
                over = p.poll() is not None
                p.send_signal(number)
                out, said, wrong = ended(p, written, all_of_it, 60)
                wrong = wrong or expected.wrong(arguments, p.returncode, out)
                what = '%s: %s%s' % (arguments[0], signal.Signals(number).name, ' after a loss' if lost else '')
                tell('%s, code %s%s: %s' % (what, p.returncode, ' before it' if over else '', said), wrong)


def streams(scc):
    """Whatever becomes of them: the exit code of what could be written, or why it could not."""
    few = ['--runs', '3', '--observe', 'time', '--every', '1', '--until', '2']
    codes = []
    with tempfile.TemporaryDirectory() as folder:
        violated = os.path.join(folder, 'violated.sc')
        with open(BONDS) as f, open(violated, 'w') as copy:
            copy.write(f.read() + 'check few : always bonds(link) < 2\n')
        checks = [['check', path, '-D', 'n=6'] for path in (BONDS, violated, 'no.sc')]
        for arguments in (*checks, ['simulate', model('brownian.sc'), *few]):
            codes += all_streams(scc, arguments)
    tell('exit codes %s' % codes, [] if codes == [0, 1, 3, 0] else ['others'])


def all_streams(scc, arguments):
    """The exit code with all of them."""
    for out in ('', '>&-', '>/dev/full'):
        for err in ('', '2>&-', '2>/dev/full'):
            words = ['sh', '-c', '"$@" %s %s' % (out, err), 'sh', *in_words(scc, *arguments)]
            done = subprocess.run(words, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
            found = done.returncode, done.stdout
            if not out and not err:
                code, text = found
            good = (code, text) if not out or not text else (74, b'')
            name = ' '.join([arguments[0], os.path.basename(arguments[1]), out, err])
            tell('%s: code %d' % (name, done.returncode), [] if found == good else ['%r' % (found,)])
    return [code]


def losses(scc, times):
    expected = Expected(scc)
    killed(scc, expected, times)
    signalled(scc, expected, times)
    streams(scc)
