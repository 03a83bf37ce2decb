"""A cluster that stands, as `ray start` makes it: by its address, as a client of it, and what its metrics tell."""

import os
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import time
import urllib.request

from support import BONDS, awaited, children, command, in_words, model, report_of, scc_bytes, tell, title


def free_ports(count):
    """Above those that Ray gives to its workers."""
    found, port = [], 21000 + os.getpid() % 5000
    while len(found) < count:
        port += 1
        with socket.socket() as s:
            try:
                s.bind(('127.0.0.1', port))
                found.append(port)
            except OSError:
                pass
    return found


def answers(port):
    with socket.socket() as s:
        s.settimeout(1)
        return s.connect_ex(('127.0.0.1', port)) == 0


def metrics(port):
    try:
        with urllib.request.urlopen('http://127.0.0.1:%d/metrics' % port, timeout=5) as f:
            return f.read().decode()
    except OSError:
        return ''


def value(text, name):
    found = [line for line in text.splitlines() if line.startswith('ray_%s{' % name)]
    return [float(line.rsplit(' ', 1)[1]) for line in found]


def cluster_stands(scc):
    port, client, exported = free_ports(3)
    # Short, as sockets have names of at most 107 bytes.
    folder = tempfile.mkdtemp(prefix='ray', dir='/tmp')
    words = [os.path.join(os.path.dirname(sys.executable), 'ray'), 'start', '--head', '--block', '--num-cpus', '2',
             '--include-dashboard=false', '--temp-dir', folder, '--port', str(port), '--ray-client-server-port', str(client),
             '--metrics-export-port', str(exported)]
    log = open(os.path.join(folder, 'log'), 'w')

    def start():
        return subprocess.Popen(words, stdout=log, stderr=log, start_new_session=True)
    head = start()
    try:
        # A busy machine may not begin within the half of a minute that Ray gives it.
        for _ in range(3):
            if awaited(lambda: head.poll() is not None or answers(client) and answers(port), 90) and head.poll() is None:
                break
            if head.poll() is not None:
                head = start()
        else:
            with open(log.name) as f:
                tell('ray start', [f.read()[-500:]])
            return
        time.sleep(2)
        used(scc, ['127.0.0.1:%d' % port, 'ray://127.0.0.1:%d' % client], exported)
        lost(scc, head, 'ray://127.0.0.1:%d' % client)
    finally:
        if head.poll() is None:
            head.send_signal(signal.SIGTERM)
            head.wait(60)
        log.close()
        shutil.rmtree(folder, ignore_errors=True)


def used(scc, addresses, exported):
    check = ['check', BONDS, '--owners', '2', '--json']
    runs = ['--runs', '100', '--observe', 'x(ligand)', '--every', '1', '--until', '12']
    simulate = ['simulate', model('brownian.sc'), *runs]
    simulated = scc_bytes(scc, *simulate)[0]
    for size, address in zip(('10', '11'), addresses):
        expected = report_of(command(scc, *check, '-D', 'n=' + size)[1])
        code, out, said = command(scc, *check, '-D', 'n=' + size, '--address', address)
        tell('check at %s' % address, [] if code == 0 and report_of(out) == expected else ['differs: ' + said])
        states = float(expected['explored']['states'])
        told = awaited(lambda: states in value(metrics(exported), 'scc_states'), 30)
        tell('its metrics tell of %.0f states' % states, [] if told else ['%s' % value(metrics(exported), 'scc_states')])
        code, out, said = command(scc, *simulate, '--address', address)
        tell('simulate at %s' % address, [] if code == 0 and out == simulated else ['differs: ' + said])
    told = awaited(lambda: 100.0 in value(metrics(exported), 'scc_done'), 30)
    tell('its metrics tell of 100 runs', [] if told else ['%s' % value(metrics(exported), 'scc_done')])


def lost(scc, head, address):
    """The head ends while a check is under way: that ends too, and says so."""
    words = in_words(scc, 'check', BONDS, '-D', 'n=30', '--address', address)
    p = subprocess.Popen(words, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    awaited(lambda: p.poll() is not None or any('ray::Owner' in title(k) for k in children(head.pid)), 120)
    time.sleep(3)
    head.terminate()
    begin = time.time()
    said = (p.communicate()[1].decode(errors='replace').strip().splitlines() or [''])[-1]
    lasted = time.time() - begin
    told = p.returncode == 4 and said.startswith('scc-cluster:') and lasted < 120
    tell('a lost head: %s' % said, [] if told else ['code %d after %.0f s' % (p.returncode, lasted)])
