"""What scc serve answers, and to whom: asked as programs ask, without a browser.

    serve_test.py SCC FOLDER    the program; a folder for its files

The last line is 'N passed, N failed'."""
import hashlib
import http.client
import json
import os
import re
import shutil
import signal
import socket
import subprocess
import sys
import threading
import time

MODEL = 'specs/models/hexokinase.sc'
passed, failed = 0, 0


def check(what, holds, *seen):
    """Counts a check."""
    global passed, failed
    if holds:
        passed += 1
    else:
        failed += 1
        print('FAILED:', what, *seen)


def same(what, found, wanted):
    check(what, found == wanted, f'found {found!r}, not {wanted!r}')


#: Seconds after which nothing is awaited any more: no judgment of how fast anything is.
HANG = 600


def awaited(holds):
    since = time.monotonic()
    while not holds() and time.monotonic() - since < HANG:
        time.sleep(0.02)


class Served:
    """scc serve, and requests to it."""

    def __init__(self, scc, *arguments):
        self.process = subprocess.Popen([scc, 'serve', *arguments], stdout=subprocess.PIPE,
                                        stderr=subprocess.PIPE, text=True)
        line = self.process.stdout.readline()
        found = re.search(r'http://127\.0\.0\.1:([0-9]+)(/[0-9a-f]{32}/)$', line.strip())
        if not found:
            raise SystemExit(f'no address in {line!r}: {self.process.stderr.read()}')
        self.port, self.root = int(found[1]), found[2]

    def ask(self, method, path, body=None, headers=None, root=None):
        """The status, the headers and the bytes of an answer."""
        connection = http.client.HTTPConnection('127.0.0.1', self.port, timeout=HANG)
        headers = {'content-type': 'application/json', **(headers or {})}
        connection.request(method, (self.root if root is None else root) + path, body, headers)
        answer = connection.getresponse()
        content = answer.read()
        connection.close()
        return answer.status, dict(answer.getheaders()), content

    def post(self, path, body):
        status, _, content = self.ask('POST', path, json.dumps(body))
        return status, json.loads(content)

    def rpc(self, to, method, **params):
        """The result, or the error, of a question to a process."""
        status, answer = self.post(to, {'jsonrpc': '2.0', 'id': 1, 'method': method, 'params': params})
        return answer.get('result', answer.get('error')) if status == 200 else status

    def open(self, text, what='none', **more):
        """The name of a new document, and its status once it is made."""
        status, answer = self.post('open', {'text': text, 'check': what, **more})
        if status != 200:
            return None, answer
        name = answer['document']
        while True:
            _, told = self.post(f'view/{name}/status', {})
            if told['state'] != 'working':
                return name, told

    def end(self):
        """Ends it as Ctrl-C does: its exit code."""
        self.process.send_signal(signal.SIGINT)
        try:
            return self.process.wait(HANG)
        except subprocess.TimeoutExpired:
            self.process.kill()
            return 'it went on'


def who_may_ask(served):
    wrong = '/' + '0' * 32 + '/'
    for what, wanted, method, path, headers, root in [
            ('the address', 200, 'GET', '', {}, None),
            ('another name of this machine', 200, 'GET', '', {'host': f'localhost:{served.port}'}, None),
            ('its own origin', 200, 'GET', '', {'origin': f'http://127.0.0.1:{served.port}'}, None),
            ('no secret', 403, 'GET', '', {}, '/'),
            ('a wrong secret', 403, 'GET', '', {}, wrong),
            ('a part of the secret', 403, 'GET', '', {}, served.root[:-2] + '/'),
            ('a longer secret', 403, 'GET', '', {}, served.root[:-1] + 'a/'),
            ('a wrong secret that asks', 403, 'POST', 'open', {}, wrong),
            ('another host', 403, 'GET', '', {'host': f'evil.example:{served.port}'}, None),
            ('another port', 403, 'GET', '', {'host': f'127.0.0.1:{served.port + 1}'}, None),
            ('a foreign origin', 403, 'POST', 'open', {'origin': 'http://evil.example'}, None),
            ('a foreign port', 403, 'POST', 'open', {'origin': f'http://127.0.0.1:{served.port + 1}'}, None),
            ('no origin to tell', 403, 'POST', 'open', {'origin': 'null'}, None),
            ('a form of a page', 415, 'POST', 'open', {'content-type': 'text/plain'}, None),
            ('another method', 405, 'PUT', 'open', {}, None),
            ('no such page', 404, 'GET', 'other', {}, None),
            ('no such request', 404, 'POST', 'other', {}, None),
            ('a way out of the folder', 404, 'GET', '../../etc/passwd', {}, None),
            ('a document that is not there', 410, 'GET', 'view/d99/', {}, None)]:
        body = '{}' if method != 'GET' else None
        status, told, content = served.ask(method, path, body, headers, root)
        same(f'status for {what}', status, wanted)
        if wanted >= 400:
            check(f'a sentence for {what}', len(json.loads(content)['error']) > 10, content)
        same(f'nothing is kept of {what}', told.get('cache-control'), 'no-store')
    _, told, page = served.ask('GET', '')
    same('others cannot frame it', told['content-security-policy'], "frame-ancestors 'self'")
    policy = re.search(rb'Content-Security-Policy" content="([^"]*)"', page)[1]
    check('the page lets in what has its hash alone', policy.startswith(b"default-src 'none'") and b'unsafe' not in policy)


def bad_requests(served):
    for body in ['', '[]', 'null', '{', '[' * 100_000, '{"text": 5}', '{"text": ""}\x00', '{"text": "", "check": 3}',
                 '{"text": "", "check": {"only": 3}}', '{"text": "", "seconds": -1}', b'\xff\xfe']:
        status, told, content = served.ask('POST', 'open', body)
        same(f'status for {body[:30]!r}', status, 400)
    status, answer = served.post('ask', {'jsonrpc': '2.0', 'id': 1, 'method': 'none'})
    same('an unknown method', answer['error']['code'], -32601)
    status, _, answer = served.ask('POST', 'ask', '\n{"jsonrpc": "2.0",\r\n"id": 7, "method": "service.describe"}\n')
    same('a question on several lines', json.loads(answer)['id'], 7)
    status, _, answer = served.ask('POST', 'ask', 'document')
    same('what is no JSON', json.loads(answer)['error']['code'], -32700)


def large_requests(served):
    megabyte = b' ' * 1_000_000

    def parts():
        for _ in range(100):
            yield megabyte

    same('100 MB at once', served.ask('POST', 'open', megabyte * 100)[0], 413)
    same('100 MB in parts', served.ask('POST', 'open', parts())[0], 413)
    with open(f'/proc/{served.process.pid}/status', encoding='utf-8') as status:
        peak = int(re.search(r'VmHWM:\s+(\d+) kB', status.read())[1])
    check('they are not kept', peak < 400_000, peak)
    same('it goes on after them', served.ask('GET', '')[0], 200)


def half_heads(served):
    """As many heads without an end as there may be connections: others wait no longer for them than for a body."""
    half = f'GET {served.root} HTTP/1.1\r\nHost: 127.0.0.1:{served.port}\r\n'.encode()
    begun = time.monotonic()
    many = [socket.create_connection(('127.0.0.1', served.port), HANG) for _ in range(200)]
    for k, one in enumerate(many):
        one.sendall([b'', half, half + b'X: '][k % 3])
    same('others are heard after them', served.ask('GET', '')[0], 200)
    # A connection may last 120 seconds.
    check('before they could have been answered', time.monotonic() - begun < 90, time.monotonic() - begun)
    same('they have no answer', {one.recv(1) for one in many}, {b''})
    for one in many:
        one.close()


def silent_ones(served):
    """More connections than there may be, which say nothing: the oldest ones give their places to those who speak."""
    def is_open(one):
        one.setblocking(False)
        try:
            return one.recv(1) != b''
        except ConnectionResetError:
            return False
        except BlockingIOError:
            return True

    begun = time.monotonic()
    half = f'GET {served.root} HTTP/1.1\r\nHost: 127.0.0.1:{served.port}\r\n'.encode()
    many = [socket.create_connection(('127.0.0.1', served.port), HANG) for _ in range(250)]
    for one in many[:20:2]:
        one.sendall(half)
    same('others are heard beside them', [served.ask('GET', '')[0] for _ in range(30)], 30 * [200])
    # After ten seconds, all of them are dropped.
    found = [is_open(one) for one in many]
    late = time.monotonic() - begun > 9
    check('the oldest ones are dropped', not any(found[:51]), found)
    check('the newest ones are not', late or all(found[100:]), found)
    for one in many:
        one.close()


def bodies_that_do_not_come(served):
    """Who is not admitted is answered at once, whatever was promised; who is, after the seconds for a body."""
    def sent(path, *headers):
        s = socket.create_connection(('127.0.0.1', served.port), HANG)
        s.sendall('\r\n'.join([f'POST {path} HTTP/1.1', f'Host: 127.0.0.1:{served.port}', *headers, '', '']).encode())
        return s

    def status(s):
        with s:
            return int(s.makefile('rb').readline().split()[1])

    json = 'Content-Type: application/json'
    for what, wanted, path, *headers in [
            ('no secret', 403, '/x', 'Content-Length: 50000'), ('a length below 0', 400, served.root, 'Content-Length: -5'),
            ('no secret, in parts', 403, '/x', 'Transfer-Encoding: chunked'),
            ('a length in words', 400, served.root, 'Content-Length: many'),
            ('a body that does not come', 408, served.root + 'ask', json, 'Content-Length: 50000')]:
        same(f'status for {what}', status(sent(path, *headers)), wanted)
    many = [sent('/x', 'Content-Length: 50000') for _ in range(300)]
    begun = time.monotonic()
    same('others are heard beside them', served.ask('GET', '')[0], 200)
    check('at once', time.monotonic() - begun < 8, time.monotonic() - begun)
    same('they have their answers', {status(s) for s in many}, {403})


def repeated_headers(served):
    """Of headers that can have one value, two are refused, also where they are alike."""
    def status(method, *headers):
        with socket.create_connection(('127.0.0.1', served.port), HANG) as s:
            s.sendall('\r\n'.join([f'{method} {served.root} HTTP/1.1', *headers, '', '']).encode())
            return int(s.makefile('rb').readline().split()[1])

    host, own = f'Host: 127.0.0.1:{served.port}', f'Origin: http://127.0.0.1:{served.port}'
    same('one host', status('GET', host), 200)
    for what, *headers in [
            ('the same host twice', host, host), ('another host first', 'Host: evil.example', host),
            ('another host last', host, 'hOST: evil.example'), ('two origins', host, own, 'Origin: http://evil.example'),
            ('two kinds', host, 'Content-Type: application/json', 'Content-Type: text/plain')]:
        same(f'status for {what}', status('GET', *headers), 400)
    same('two lengths', status('POST', host, 'Content-Length: 0', 'Content-Length: 0'), 400)


def strange_heads(served):
    """Heads that come in pieces, that never end, and two requests at once: the second one is not heard."""
    head = f'GET {served.root} HTTP/1.1\r\nHost: 127.0.0.1:{served.port}\r\n'.encode()

    def told(*pieces):
        with socket.create_connection(('127.0.0.1', served.port), HANG) as s:
            said = b''
            try:
                for piece in pieces:
                    s.sendall(piece)
                while part := s.recv(65536):
                    said += part
            except ConnectionError:
                pass
            return said

    page = served.ask('GET', '')[2]
    check('a head byte by byte', told(*(bytes([b]) for b in head + b'\r\n')).endswith(page), 'not the page')
    check('lines that end without a return', told(head.replace(b'\r', b'') + b'\n').endswith(page), 'not the page')
    check('a long field', told(head + b'X: ' + b'x' * 30_000 + b'\r\n\r\n').endswith(page), 'not the page')
    same('two requests: one answer', told(head + b'\r\n' + head + b'\r\n').count(b'HTTP/1.1 '), 1)
    same('a field without an end', len(told(head + b'X: ' + b'x' * 1_000_000)), 0)
    same('fields without an end', len(told(head + b'X: y\r\n' * 100_000)), 0)
    parts = head.replace(b'GET', b'POST') + b'Transfer-Encoding: chunked\r\n\r\n'
    told(parts + b'1' * 300_000_000)
    with open(f'/proc/{served.process.pid}/status', encoding='utf-8') as status:
        peak = int(re.search(r'VmHWM:\s+(\d+) kB', status.read())[1])
    check('the size of a part without an end is not kept', peak < 400_000, peak)
    same('no request', len(told(b'\x16\x03\x01' * 100 + b'\n')), 0)
    same('it goes on after them', served.ask('GET', '')[0], 200)


def many_requests(served, text):
    """A thousand at once, and half of those who asked go away before they have an answer."""
    name, _ = served.open(text)
    statuses = []

    def one(k):
        line = {'jsonrpc': '2.0', 'id': k, 'method': 'successors', 'params': {'model': 'm1', 'path': []}}
        if k % 2 == 0:
            since = time.monotonic()
            status, answer = served.post(f'view/{name}/ask', line)
            while status == 503 and time.monotonic() - since < HANG:  # others are asked
                time.sleep(0.1)
                status, answer = served.post(f'view/{name}/ask', line)
            statuses.append((status, answer.get('id') == k))
        else:
            body = json.dumps(line)
            with socket.create_connection(('127.0.0.1', served.port), HANG) as s:
                s.sendall(f'POST {served.root}view/{name}/ask HTTP/1.1\r\nHost: 127.0.0.1:{served.port}\r\n'
                          f'Content-Type: application/json\r\nContent-Length: {len(body)}\r\n\r\n{body}'.encode())

    threads = [threading.Thread(target=one, args=(k,)) for k in range(1000)]
    for t in threads:
        t.start()
    for t in threads:
        t.join()
    same('1000 at once: each has its own answer', set(statuses), {(200, True)})
    same('how many', len(statuses), 500)
    same('it goes on after them', served.ask('GET', '')[0], 200)


def documents(served, text):
    name, told = served.open(text, 'all')
    same('a model that is checked', told['state'], 'ready')
    same('its verdicts', {v['name']: v['verdict'] for v in told['verdicts']}.get('reaction'), 'holds')
    status, _, page = served.ask('GET', f'view/{name}/')
    check('its page', status == 200 and b'name="scc-live"' in page and b"connect-src 'self'" in page)
    data = json.loads(re.search(rb'id="data">(.*?)</script>', page, re.S)[1])
    same('its data', data['format'], 'scc-view')
    have = {name: len(data[name]) for name in ['solids', 'behaviours', 'processes', 'labels', 'states']}
    result = served.rpc(f'view/{name}/ask', 'document.walk', state=0, choices=[0, 0, 99], have=have)
    same('a way as far as it is possible', result['choices'], [0, 0])
    looked = dict(result['more']['looked'])
    same('what was looked at', len(looked), 3)
    check('where it leads', all(c['to'] is not None for e in looked.values() for c in e['next']))
    again = served.rpc(f'view/{name}/ask', 'document.walk', state=0, choices=[0, 0, 99], have=have)
    same('the same question has the same answer', again, result)
    for what, params in [('a state that is not there', {'state': 10**9, 'have': have}),
                         ('a state that is none', {'state': 'x', 'have': have}),
                         ('nothing had', {'state': 0})]:
        same(what, served.rpc(f'view/{name}/ask', 'document.expand', **params)['code'], -32602)
    possible = served.rpc(f'view/{name}/ask', 'successors', model='m1', path=[])
    check('its model', len(possible['transitions']) > 0, possible)

    _, told = served.open(text, {'only': 'reaction'})
    same('one check alone', [v['name'] for v in told['verdicts']], ['reaction'])
    _, told = served.open(text, {'only': 'nothing'})
    same('a check that is not there', (told['state'], told['diagnostics'][0]['code']), ('refused', 'SC0201'))
    _, told = served.open(text + '\ncheck odd : always oddity\n')
    same('a text with a fault', told['state'], 'refused')
    check('its place', 'line' in json.dumps(told['diagnostics'][0]), told['diagnostics'][0])

    same('closing', served.post(f'view/{name}/close', {})[0], 200)
    same('what is closed', served.ask('GET', f'view/{name}/')[0], 410)
    same('asking what is closed', served.rpc(f'view/{name}/ask', 'successors', model='m1', path=[]), 410)
    first, _ = served.open(text)
    for _ in range(12):
        served.open(text)
    same('only so many are kept', served.ask('GET', f'view/{first}/')[0], 410)


def large_runs(served):
    """Of a run of many bodies, states are told by what changes: what else is possible is found all the same."""
    with open('specs/models/gas.sc', encoding='utf-8') as file:
        gas = file.read().replace('param n = 2', 'param n = 5').split('check energy')[0]
    name, _ = served.open(gas)
    _, _, page = served.ask('GET', f'view/{name}/')
    data = json.loads(re.search(rb'id="data">(.*?)</script>', page, re.S)[1])
    run = data['runs'][0]
    check('a run of many bodies', len(data['leaves']) == 125 and len(run['steps']) > 30, len(run['steps']))
    have = {what: len(data[what]) for what in ['solids', 'behaviours', 'processes', 'labels', 'states']}
    labels, state = data['labels'], run['start']
    for step in run['steps'][:12]:
        more = served.rpc(f'view/{name}/ask', 'document.expand', state=state, have=have)['more']
        labels += more['labels'][len(labels) - have['labels']:]
        possible = dict(more['looked'])[state]['next']
        same(f'what the run takes in state {state}', labels[possible[step['choice']]['label']]['text'],
             labels[step['label']]['text'])
        state = step['to']


ENDLESS = '''// A cube that gets faster for ever.
shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    back  [a,d,c,b]  front  [e,f,g,h]  left [a,e,h,d]
           right [b,c,g,f]  bottom [a,b,f,e]  top  [d,h,g,c]
}
process p = Cube mass 1 velocity (1,0,0) at translate (0,0,0) [nil]
process q = Cube mass 1 velocity (-1,0,0) at translate (0,9,0) [nil]
timestep 1
motion p = (vx + 1/4, vy, vz)
check there : always x(p) < 1e100
'''


def long_work(served, endless):
    """A check that does not end: it tells how far it is, and ends with what it has."""
    _, answer = served.post('open', {'text': endless, 'check': 'all'})
    name, progress, since = answer['document'], None, time.monotonic()
    while 'states' not in (progress or '') and time.monotonic() - since < HANG:
        _, told = served.post(f'view/{name}/status', {})
        if told['state'] != 'working':
            break
        progress = told['progress']
    check('it tells how far it is', progress is not None and 'states' in progress, told)
    same('its page is not there yet', served.ask('GET', f'view/{name}/')[0], 410)
    same('stopping', served.post(f'view/{name}/stop', {})[0], 200)
    since = time.monotonic()
    while told['state'] == 'working' and time.monotonic() - since < HANG:
        _, told = served.post(f'view/{name}/status', {})
    same('what was stopped', (told['state'], told.get('interrupted')), ('ready', True))
    same('it holds as far as it came', [v['verdict'] for v in told['verdicts']], ['holds-up-to-bound'])
    same('and a page', served.ask('GET', f'view/{name}/')[0], 200)
    for what, pauses in [('at once', [0]), ('while it begins', [0.02]), ('twice', [1, 0])]:
        _, answer = served.post('open', {'text': endless, 'check': 'all'})
        name = answer['document']
        for pause in pauses:
            time.sleep(pause)
            served.post(f'view/{name}/stop', {})
        told, since = {'state': 'working'}, time.monotonic()
        while told['state'] == 'working' and time.monotonic() - since < HANG:
            _, told = served.post(f'view/{name}/status', {})
        same(f'what was stopped {what}', (told['state'], told.get('interrupted')), ('ready', True))
    _, told = served.open(endless, 'all', seconds=1)
    same('one that is bounded in time', told['state'], 'ready')


def saving(scc, folder):
    path = os.path.join(folder, 'saved.sc')
    shutil.copy(MODEL, path)
    served = Served(scc, path)
    with open(path, encoding='utf-8') as file:
        text = file.read()
    _, _, page = served.ask('GET', '')
    data = json.loads(re.search(rb'id="data">(.*?)</script>', page, re.S)[1])
    same('the text of the file', data['text'], text)
    same('its digest', data['saved'], 'md5:' + hashlib.md5(text.encode()).hexdigest())
    new = text + '\n// one more line: é\n'
    status, answer = served.post('save', {'text': new, 'saved': data['saved']})
    same('saving', status, 200)
    with open(path, encoding='utf-8') as file:
        same('what is in the file then', file.read(), new)
    same('over what is not there any more', served.post('save', {'text': text, 'saved': data['saved']})[0], 409)
    with open(path, 'a', encoding='utf-8') as file:
        file.write('// by somebody else\n')
    status, other = served.post('save', {'text': text, 'saved': answer['saved']})
    same('somebody else has written', (status, other['text']), (409, new + '// by somebody else\n'))
    same('nothing is lost', open(path, encoding='utf-8').read(), other['text'])
    same('writing over it', served.post('save', {'text': text, 'saved': other['saved']})[0], 200)
    os.remove(path)
    same('a file that has gone', served.post('save', {'text': text, 'saved': other['saved']})[0], 409)
    same('a new one', served.post('save', {'text': text, 'saved': None})[0], 200)
    os.remove(path)
    os.mkdir(path)
    status, answer = served.post('save', {'text': text, 'saved': None})
    check('a file that cannot be written', status == 400 and len(answer['error']) > 10, status, answer)
    same('the end', served.end(), 0)
    with open(os.path.join(folder, 'latin.sc'), 'wb') as file:
        file.write(b'// caf\xe9\n')
    served = Served(scc, os.path.join(folder, 'latin.sc'))
    data = json.loads(re.search(rb'id="data">(.*?)</script>', served.ask('GET', '')[2], re.S)[1])
    same('what is no text is not shown as one', (data['text'], data['unreadable']), ('', 'it is not UTF-8 text'))
    same('and not written over', served.post('save', {'text': 'x', 'saved': None})[0], 400)
    same('its end', served.end(), 0)
    served = Served(scc)
    data = json.loads(re.search(rb'id="data">(.*?)</script>', served.ask('GET', '')[2], re.S)[1])
    _, told = served.open(data['text'], 'all')
    same('what one begins with holds', [v['verdict'] for v in told['verdicts']], ['holds'])
    same('without a file', served.post('save', {'text': text, 'saved': None})[0], 400)
    same('its end', served.end(), 0)


def definitions(scc):
    """What -D says holds for documents, and the desk is told of it as model.load takes it."""
    text = 'param n = 1\nparam r in [0, 4]\n' + ENDLESS.replace('vx + 1/4', 'vx + n/4')
    served = Served(scc, '-D', 'n=3', '-D', 'r=[1,2)')
    data = json.loads(re.search(rb'id="data">(.*?)</script>', served.ask('GET', '')[2], re.S)[1])
    same('parameters', data['parameters'], {'n': '3/1', 'r': {'low': {'value': '1/1', 'included': True},
                                                              'high': {'value': '2/1', 'included': False}}})
    loaded = served.rpc('ask', 'model.load', text=text, parameters=data['parameters'], start='simple')
    same('they are taken', loaded['parameters']['n'], '3/1')
    name, _ = served.open(text)
    page = json.loads(re.search(rb'id="data">(.*?)</script>', served.ask('GET', f'view/{name}/')[2], re.S)[1])
    same('those of a document', page['parameters'], loaded['parameters'])
    same('the end', served.end(), 0)


def ends(scc, text):
    served = Served(scc, MODEL)
    taken = subprocess.run([scc, 'serve', '--port', str(served.port)], capture_output=True, text=True, timeout=HANG)
    same('a port in use', taken.returncode, 74)
    check('its message', f'cannot listen on port {served.port}: Address already in use' in taken.stderr, taken.stderr)
    name, _ = served.open(text)
    children = subprocess.run(['pgrep', '-P', str(served.process.pid)], capture_output=True, text=True).stdout.split()
    check('a process for the document', len(children) >= 1, children)
    os.kill(int(children[0]), signal.SIGKILL)
    awaited(lambda: served.rpc(f'view/{name}/ask', 'successors', model='m1', path=[]) == 410)
    same('a document whose process was killed', served.rpc(f'view/{name}/ask', 'successors', model='m1', path=[]), 410)
    name, told = served.open(text)
    same('another one', told['state'], 'ready')
    children = subprocess.run(['pgrep', '-P', str(served.process.pid)], capture_output=True, text=True).stdout.split()
    same('the end by Ctrl-C', served.end(), 0)
    awaited(lambda: not any(os.path.exists(f'/proc/{c}') for c in children))
    left = [c for c in children if os.path.exists(f'/proc/{c}')]
    same('no process is left', left, [])


def main(scc, folder):
    shutil.rmtree(folder, ignore_errors=True)
    os.makedirs(folder)
    with open(MODEL, encoding='utf-8') as file:
        text = file.read()
    served = Served(scc, MODEL)
    who_may_ask(served)
    bad_requests(served)
    documents(served, text)
    large_runs(served)
    long_work(served, ENDLESS)
    many_requests(served, text)
    large_requests(served)
    strange_heads(served)
    half_heads(served)
    silent_ones(served)
    bodies_that_do_not_come(served)
    repeated_headers(served)
    same('the end', served.end(), 0)
    saving(scc, folder)
    definitions(scc)
    ends(scc, text)
    print(f'{passed} passed, {failed} failed')
    return 1 if failed else 0


if __name__ == '__main__':
    sys.exit(main(sys.argv[1], sys.argv[2]))
