#!/usr/bin/env python3
"""What goes wrong among owners (`scc successors --owner K/N`): others that are none, are lost, or say what no owner says;
files that are damaged. Each owner ends in time, with its exit code and with words.

    owners_trouble_test.py SCC MODEL RUIN    # RUIN: specs/models/ruin.sc, with probabilities
"""

import hashlib
import hmac
import json
import os
import signal
import socket
import subprocess
import sys
import tempfile
import threading

from owners_test import Owners

scc, model, ruin = sys.argv[1:]
passed = failed = 0
HELLO = 12 + 4 + 96


def tell(name, wrong):
    global passed, failed
    passed, failed = passed + (not wrong), failed + bool(wrong)
    if wrong:
        print('%s: %s' % (name, wrong))


class One:
    """One owner, with what it writes."""

    def __init__(self, number, count, size=12, of=None):
        words = [scc, 'successors', *(of or [model, '-D', 'n=%d' % size]), '--owner', '%d/%d' % (number, count)]
        self.process = subprocess.Popen(words, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        self.port = json.loads(self.process.stdout.readline())['owner']['port']

    def begin(self, ports, **asked):
        asked = dict({'peers': ['127.0.0.1:%d' % port for port in ports], 'secret': 's', 'run': '1', 'order': 'levels',
                      'deadline': 1500}, **asked)
        self.say(json.dumps(asked))

    def say(self, line):
        self.process.stdin.write(line.encode() + b'\n')
        self.process.stdin.flush()

    def end(self, code, words, within=5):
        """What is wrong with its end."""
        try:
            self.process.wait(within)
        except subprocess.TimeoutExpired:
            self.process.kill()
            return 'it has not ended after %d s' % within
        said = self.process.stderr.read().decode()
        for pipe in (self.process.stdin, self.process.stdout, self.process.stderr):
            pipe.close()
        return '' if self.process.returncode == code and words in said else 'code %d: %s' % (self.process.returncode, said)


def listening():
    s = socket.socket()
    s.bind(('127.0.0.1', 0))
    s.listen()
    s.settimeout(10)
    return s, s.getsockname()[1]


def receive(s, size):
    data = b''
    while len(data) < size:
        part = s.recv(size - len(data))
        if not part:
            return data
        data += part
    return data


def drain(s):
    """Reads until the other side has ended."""
    while s.recv(1 << 16):
        pass
    s.close()


def greet(s, secret=b's', change=lambda hello: hello):
    """As the first owner, to the second one that has called."""
    theirs = receive(s, HELLO)
    mine = change(theirs[:12] + b'\0\0\2\0' + theirs[16:80] + os.urandom(32))
    s.sendall(mine)
    s.sendall(hmac.new(secret, b'proof' + mine + theirs, hashlib.sha256).digest())
    return receive(s, 32) == hmac.new(secret, b'proof' + theirs + mine, hashlib.sha256).digest()


def called(name, code, words, what, of=None, **asked):
    """The second owner calls a program that does this."""
    s, port = listening()

    def work():
        try:
            peer, _ = s.accept()
            what(peer)
            drain(peer)
        except OSError:
            pass
    threading.Thread(target=work, daemon=True).start()
    owner = One(2, 2, of=of)
    owner.begin([port, owner.port], **asked)
    tell(name, owner.end(code, words))
    s.close()


def frame(kind, body=b'', size=None):
    return (len(body) if size is None else size).to_bytes(4, 'little') + kind + body


def greeted(then):
    def what(s):
        tell('the greeting', '' if greet(s) else 'the owner does not know the secret')
        s.sendall(then)
    return what


def others():
    called('garbage', 3, 'SC0924', lambda s: s.sendall(b'x' * 500))
    called('silence', 4, 'not all owners have come within 1.5 seconds: owner 1', lambda s: None)
    called('an end', 4, 'owner 1 has ended the connection', lambda s: s.shutdown(socket.SHUT_RDWR))
    called('another secret', 3, 'SC0924]: owner 1 has another secret', lambda s: greet(s, b't'))
    called('another program', 3, 'is another version of scc', lambda s: greet(s, change=lambda h: h[:20] + b'?' + h[21:]))
    called('another model', 3, 'explores something else', lambda s: greet(s, change=lambda h: h[:60] + b'?' + h[61:]))
    called('another protocol', 3, 'no owner of this version', lambda s: greet(s, change=lambda h: b'scc owner 2\n' + h[12:]))
    called('another owner', 3, 'which is not expected here', lambda s: greet(s, change=lambda h: h[:12] + b'\1' + h[13:]))
    called('a message that is too long', 3, 'SC0924', greeted(frame(b'R', size=1 << 30)))
    called('a message of no kind', 3, 'SC0924', greeted(frame(b'?')))
    called('what are no states', 3, 'SC0924', greeted(frame(b'R', b'\xff' * 40)))
    called('an empty summary', 3, 'SC0924', greeted(frame(b'P') * 2))
    called('half a message', 4, 'owner 1 is lost', lambda s: (greet(s), s.sendall(b'\5\0'), s.shutdown(socket.SHUT_RDWR)))
    chances = dict(of=[ruin], evaluate=True)
    for what, kind in (('no transitions', b'A'), ('no question', b'V'), ('no answer', b'W'), ('nodes for another owner', b'N')):
        called(what, 3, 'SC0924', greeted(frame(kind, b'\x7f' * 9)), **chances)
    called('no token', 3, 'SC0924', greeted(frame(b'K')), order='any')
    called('a goal that is not there', 3, 'SC0924', greeted(frame(b'M', b'\x7f')), order='any')
    s, port = listening()
    s.close()
    owner = One(2, 2)
    owner.begin([port, owner.port])
    tell('nobody', owner.end(4, 'owner 1 at 127.0.0.1:%d cannot be reached' % port))


def strangers():
    """Who calls an owner and is none costs it nothing."""
    owners = [One(1, 2), One(2, 2)]
    ports = [o.port for o in owners]
    owners[0].begin(ports)
    calls = [socket.create_connection(('127.0.0.1', ports[0])) for _ in range(3)]
    calls[1].sendall(b'GET / HTTP/1.1\r\n' * 20)
    owners[1].begin(ports)
    line = b''
    for line in owners[0].process.stdout:
        if b'found' in line:
            break
    tell('strangers', '' if b'"states":4096,' in line.replace(b' ', b'') else line)
    for o in owners:
        o.process.stdin.close()
        tell('the end', o.end(0, ''))
    owners = [One(1, 2), One(2, 2)]
    ports = [o.port for o in owners]
    owners[0].begin(ports)
    owners[1].begin(ports, secret='t')
    tell('a wrong secret calls', owners[1].end(3, 'SC0924'))
    tell('it is turned away', owners[0].end(4, '1 that called were turned away, the last since'))
    for other in ({'run': '2'}, {'order': 'any'}, {'states': 5}, {'evaluate': True}):
        owners = [One(1, 2), One(2, 2)]
        ports = [o.port for o in owners]
        owners[0].begin(ports)
        owners[1].begin(ports, **other)
        name = 'another %s' % list(other)[0]
        tell(name, owners[1].end(3, 'or another `run'))
        tell('%s is turned away' % name, owners[0].end(4, 'or another `run'))


def parents():
    for line, words in [('nonsense', 'SC0924'), ('{}', 'SC0924'), ('{"peers":["x"],"secret":"s","run":"1","order":"levels"}', 'host:port'),
                        ('{"peers":["x:0"],"secret":"s","run":"1","order":"levels"}', 'from 1 to 65535'),
                        ('{"peers":["x:65536"],"secret":"s","run":"1","order":"levels"}', 'from 1 to 65535'),
                        ('{"peers":["x:-1"],"secret":"s","run":"1","order":"levels"}', 'from 1 to 65535'),
                        ('{"peers":["x:0x10"],"secret":"s","run":"1","order":"levels"}', 'from 1 to 65535'),
                        ('{"peers":["x:"],"secret":"s","run":"1","order":"levels"}', 'from 1 to 65535'),
                        ('{"peers":["x:1"],"secret":"s","run":"1","order":"levels","states":0}', 'from 1 on'),
                        ('{"peers":["x:1","y:2"],"secret":"s","run":"1","order":"levels"}', '2 peers, and 1 owners'),
                        ('{"peers":["x:1"],"secret":"s","run":"1","order":"levels","every":1}', 'need a `folder')]:
        owner = One(1, 1)
        owner.say(line)
        tell('a parent that says %s' % line, owner.end(3, words))
    owner = One(1, 1)
    owner.process.stdin.close()
    tell('a parent that ends', owner.end(0, ''))
    for words in (['--owner', '0/2'], ['--owner', '3/2'], ['--owner', 'x'], ['--owner', '1/1', '--listen', 'nowhere.invalid']):
        done = subprocess.run([scc, 'successors', model, *words], stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        tell(' '.join(words), '' if done.returncode == 64 and not done.stdout else 'code %d' % done.returncode)


def losses():
    """One of two is lost, or asked to end, while they work; or its input ends."""
    for order in ('levels', 'any'):
        owners = [One(k, 2, 19) for k in (1, 2)]
        for o in owners:
            o.begin([o.port for o in owners], order=order, deadline=20000)
        owners[0].process.stdout.readline()  # they have begun
        owners[1].process.stdin.close()
        tell('%s: the input ends' % order, owners[1].end(4, 'the process that has started this owner has ended', 10))
        tell('%s: the other' % order, owners[0].end(4, 'owner 2 is lost', 10))
    for number, code, words in [(signal.SIGKILL, -9, ''), (signal.SIGTERM, 4, ''), (signal.SIGINT, 4, '')]:
        for order in ('levels', 'any'):
            owners = [One(k, 2, 19) for k in (1, 2)]
            for o in owners:
                o.begin([o.port for o in owners], order=order, deadline=20000)
            owners[0].process.stdout.readline()  # they have begun
            owners[1].process.send_signal(number)
            tell('%s, %s: the one' % (number.name, order), owners[1].end(code, words, 10))
            tell('%s, %s: the other' % (number.name, order), owners[0].end(4, 'owner 2 is lost', 10))


def files():
    """What is kept is gone on with, and nothing else is."""
    with tempfile.TemporaryDirectory() as folder:
        asked = dict(folder=folder, every=0, states=1 << 40)
        owners = Owners(scc, model, 1, 2, ['-D', 'n=12'])
        expected = owners.explore(**asked)
        codes = owners.close()
        tell('keeping', '' if codes == [0, 0] and len(owners.kept) >= 4 else '%s, %s' % (codes, owners.kept))
        levels = sorted({k['kept']['level'] for k in owners.kept})
        for level in levels:
            chain = [[os.path.join(folder, '%d-%d.levels' % (k, one)) for one in levels if one <= level] for k in range(2)]
            owners = Owners(scc, model, 1, 2, ['-D', 'n=12'])
            found = owners.explore(restore=chain, states=1 << 40)
            owners.close()
            same = [found[k] == expected[k] for k in ('found', 'runs', 'doubts', 'stopped')]
            tell('from level %d' % level, '' if all(same) else '%s, and not %s' % (found, expected))
        damaged(folder, [os.path.join(folder, '0-%d.levels' % level) for level in levels])
        owner = One(1, 1)
        owner.begin([owner.port], folder=os.path.join(folder, 'none'), every=0)
        tell('no folder', owner.end(74, 'none'))


def damaged(folder, chain):
    with open(chain[0], 'rb') as f:
        data = f.read()
    bad = os.path.join(folder, 'bad')
    for name, change in [('cut off', data[:-3]), ('empty', b''), ('something else', b'nonsense'), ('twice', data + data[12:])]:
        with open(bad, 'wb') as f:
            f.write(change)
        refused(name, [bad])
    refused('without the first', chain[1:])
    refused('not there', [os.path.join(folder, 'nothing')])


def refused(name, chain):
    s, port = listening()

    def work():
        peer, _ = s.accept()
        greet(peer)
        drain(peer)
    threading.Thread(target=work, daemon=True).start()
    owner = One(2, 2)
    owner.begin([port, owner.port], restore=chain)
    tell('a file %s' % name, owner.end(3, 'SC0924'))
    s.close()


def main():
    for part in (others, strangers, parents, losses, files):
        part()
    print('%d passed, %d failed' % (passed, failed))
    sys.exit(1 if failed else 0)


main()
