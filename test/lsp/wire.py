"""A language server as a process, byte by byte: what the clients of others do not let through."""

import json
import os
import select
import subprocess
import time


class Server:
    """`scc lsp`, with the messages that it has sent."""

    def __init__(self, scc, folder=None):
        self.process = subprocess.Popen([scc, "lsp"], stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.PIPE, cwd=folder)
        self.bytes = b""
        self.messages = []
        self.serial = 0

    def raw(self, data):
        self.process.stdin.write(data)
        self.process.stdin.flush()

    def send(self, message):
        data = json.dumps(message).encode()
        self.raw(b"Content-Length: %d\r\n\r\n" % len(data) + data)

    def notify(self, method, params):
        self.send({"jsonrpc": "2.0", "method": method, "params": params})

    def request(self, method, params):
        self.serial += 1
        self.send({"jsonrpc": "2.0", "id": self.serial, "method": method, "params": params})
        return self.serial

    def _read(self, seconds):
        ready, _, _ = select.select([self.process.stdout], [], [], max(0, seconds))
        if not ready:
            return False
        data = os.read(self.process.stdout.fileno(), 1 << 20)
        self.bytes += data
        return bool(data)

    def next(self, seconds=60):
        """The next message of the server, or None."""
        end = time.monotonic() + seconds
        while True:
            head, mark, rest = self.bytes.partition(b"\r\n\r\n")
            if mark:
                length = int(head.split(b":")[1])
                if len(rest) >= length:
                    self.bytes = rest[length:]
                    return json.loads(rest[:length])
            if not self._read(end - time.monotonic()):
                return None

    def answer(self, serial, seconds=60):
        """The answer to a request; other messages are kept."""
        while True:
            message = self.next(seconds)
            assert message is not None, "no answer"
            if message.get("id") == serial and "method" not in message:
                return message
            self.messages.append(message)

    def ask(self, method, params):
        return self.answer(self.request(method, params))

    def diagnostics(self, uri, version, seconds=60):
        """The diagnostics of a version of a document, as the server publishes them."""
        while True:
            message = self.messages.pop(0) if self.messages else self.next(seconds)
            assert message is not None, "no diagnostics"
            params = message.get("params") or {}
            if message.get("method") == "textDocument/publishDiagnostics" and params["uri"] == uri and params.get("version", version) >= version:
                return params["diagnostics"]

    def initialize(self, capabilities=None, **more):
        params = {"processId": None, "rootUri": None, "capabilities": capabilities or {}, **more}
        answer = self.ask("initialize", params)
        self.notify("initialized", {})
        return answer["result"]

    def open(self, uri, text, version=1):
        item = {"uri": uri, "languageId": "scc", "version": version, "text": text}
        self.notify("textDocument/didOpen", {"textDocument": item})

    def change(self, uri, version, changes):
        self.notify("textDocument/didChange", {"textDocument": {"uri": uri, "version": version}, "contentChanges": changes})

    def end(self):
        """Ends as the protocol wants; the exit code."""
        self.ask("shutdown", None)
        self.notify("exit", None)
        return self.wait()

    def wait(self, seconds=60):
        try:
            self.process.stdin.close()
        except BrokenPipeError:
            pass
        code = self.process.wait(seconds)
        self.process.stdout.close()
        self.process.stderr.close()
        return code
