"""What goes wrong, and how it is told: wrong commands, addresses, checkpoints that cannot be kept, Ctrl-C."""

import glob
import os
import signal
import subprocess
import tempfile
import time

from support import BONDS, awaited, children, command, in_words, model, report_of, scc_bytes, tell, there


def commands(scc):
    for what, expected, arguments in [
            ('no model', 3, ['no.sc']),
            ('no property', 3, [BONDS, '--check', 'none']),
            ('a model that is read once', 64, ['-']),
            ('no owners', 64, [BONDS, '--owners', '0']),
            ('no deadline', 64, [BONDS, '--deadline', 'inf']),
            ('a bound of time in any order', 64, [model('window.sc'), '--order', 'any']),
            ('no program', 3, [BONDS, '--scc', '/nowhere/scc'])]:
        code, out, said = command(scc, 'check', *arguments) if what != 'no program' else command('/nowhere/scc', 'check', BONDS)
        tell('%s: %s' % (what, said), [] if code == expected and not out else ['code %d' % code])
    some = ['--observe', 'time', '--every', '1', '--until', '2']
    for what, expected, arguments in [
            ('no runs', 64, ['simulate', model('ruin.sc'), '--runs', '0', *some]),
            ('a plot without a summary', 64, ['simulate', model('ruin.sc'), '--runs', '3', '--plot', 'x.svg', *some]),
            ('a model that is read once', 64, ['simulate', '-', '--runs', '3', *some]),
            ('a full disk', 74, ['simulate', model('brownian.sc'), '--runs', '3', *some, '-o', '/dev/full']),
            ('a folder that is none', 74, ['simulate', model('brownian.sc'), '--runs', '3', *some, '--checkpoint', '/dev/null/x'])]:
        code, out, said = command(scc, *arguments)
        tell('%s: %s' % (what, said), [] if code == expected else ['code %d' % code])


def addresses(scc):
    for what, address in [
            ('nobody', '192.0.2.1:6379'), ('nobody', 'ray://192.0.2.1:10001'), ('nothing', '127.0.0.1:1'),
            ('nothing', 'ray://127.0.0.1:1'), ('no address', 'nonsense://x'), ('no address', ':::')]:
        begin = time.time()
        code, out, said = command(scc, 'check', BONDS, '--address', address, '--deadline', '5')
        lasted = time.time() - begin
        tell('%s: %s' % (what, said), [] if code == 69 and lasted < 30 and not out else ['code %d, %.0f s' % (code, lasted)])


def checkpoints(scc):
    """Where nothing can be kept."""
    def said_so(what, where, *arguments):
        code, out, said = command(scc, 'check', BONDS, '-D', 'n=20', '--owners', '2', '--checkpoint', where, *arguments)
        tell('%s: %s' % (what, said), [] if code == 74 and not out else ['code %d' % code])
        return code
    with tempfile.TemporaryDirectory() as folder:
        below = os.path.join(folder, 'file')
        with open(below, 'w'):
            pass
        said_so('a folder below a file', os.path.join(below, 'x'))
        said_so('an address that nobody knows', 'nonsense://x')
        # Not even root makes directories there.
        said_so('without permission', '/proc/x')
        with_mount(folder, 'size=60k', lambda where: full(scc, said_so, where))
        with_mount(folder, 'ro', lambda where: said_so('read only', where))


def with_mount(folder, options, test):
    where = os.path.join(folder, 'mount')
    os.makedirs(where, exist_ok=True)
    if subprocess.run(['mount', '-t', 'tmpfs', '-o', options, 'tmpfs', where], stderr=subprocess.DEVNULL).returncode:
        print('nothing can be mounted here: %s is not tried' % options, flush=True)
        return
    try:
        test(where)
    finally:
        subprocess.run(['umount', where], check=True)


def full(scc, said_so, where):
    said_so('a full disk', where)
    subprocess.run(['mount', '-o', 'remount,size=100m', where], check=True)
    arguments = ['check', BONDS, '-D', 'n=20', '--owners', '2', '--json']
    code, out, said = command(scc, *arguments, '--checkpoint', where)
    expected = command(scc, *arguments)
    tell('it goes on when there is room', [] if (code, report_of(out)) == (0, report_of(expected[1])) else ['differs: ' + said])


#: Seconds within which Ctrl-C ends a command, whatever it does.
SOON = 2.0


def interrupted_soon(scc):
    """Ctrl-C at several instants: while Ray starts, while owners explore, and while the first one solves equations. Every
    other time the command alone gets the signal, as by kill."""
    explores = ['check', BONDS, '-D', 'n=24', '--owners', '2', '--json']
    solves = ['check', model('association.sc'), '-D', 'n=9', '--owners', '2', '--json']
    runs = ['simulate', model('brownian.sc'), '--runs', '5000', '--observe', 'x(ligand)', '--every', '1', '--until', '40']
    for name, arguments, instants in [('exploring', explores, (0.3, 0.7, 1.5, 3, 5, 8, 12)), ('solving', solves, (9, 12, 15)),
                                      ('simulating', runs, (1, 6, 10))]:
        for k, at in enumerate(instants):
            p = subprocess.Popen(in_words(scc, *arguments), stdout=subprocess.PIPE, stderr=subprocess.PIPE, start_new_session=True)
            awaited(lambda: p.poll() is not None, at)
            of_it, ended = children(p.pid), p.poll() is not None
            begin = time.time()
            if not ended:
                (os.kill if k % 2 else os.killpg)(p.pid, signal.SIGINT)
            said = p.communicate(timeout=60)[1].decode().strip().splitlines()
            lasted = time.time() - begin
            wrong = [] if ended or p.returncode == 4 else ['code %d, %s' % (p.returncode, said)]
            wrong += [] if lasted < SOON else ['it takes %.1f s' % lasted]
            wrong += [] if awaited(lambda: not there(of_it), 20) else ['processes are left']
            how = 'it had ended' if ended else 'it ends within %.1f s' % lasted
            tell('Ctrl-C while %s, after %.1f s: %s' % (name, at, how), wrong)


def interrupted(scc):
    """Ctrl-C: a terminal sends it to all processes of the group."""
    check = ['check', BONDS, '-D', 'n=21', '--owners', '2', '--json']
    runs = ['--runs', '5000', '--observe', 'x(ligand)', '--every', '1', '--until', '40']
    simulate = ['simulate', model('brownian.sc'), *runs]
    expected = {'check': report_of(command(scc, *check)[1]), 'simulate': scc_bytes(scc, *simulate)[0]}
    for arguments, kept, least in [(check, '1/1-*.shard', 1), (simulate, '*.part', 10)]:
        with tempfile.TemporaryDirectory() as folder:
            words = in_words(scc, *arguments, '--checkpoint', folder)
            # A pipe that nobody reads would hold it up.
            p = subprocess.Popen(words, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, start_new_session=True)
            begun = awaited(lambda: len(glob.glob(os.path.join(folder, kept))) >= least, 300)
            of_it = children(p.pid)
            begin = time.time()
            os.killpg(p.pid, signal.SIGINT)
            said = p.communicate(timeout=60)[1].decode().strip().splitlines()
            lasted = time.time() - begin
            wrong = [] if begun and p.returncode == 4 and len(said) == 1 else ['code %d, %s' % (p.returncode, said)]
            wrong += [] if lasted < 20 else ['it takes %.0f s' % lasted]
            wrong += [] if awaited(lambda: not there(of_it), 20) else ['processes are left']
            tell('Ctrl-C: %s' % said[-1:], wrong)
            code, out, said = command(scc, *arguments, '--checkpoint', folder)
            found = report_of(out) if arguments is check and code == 0 else out
            tell('%s goes on after Ctrl-C' % arguments[0], [] if code == 0 and found == expected[arguments[0]] else ['differs: ' + said])
