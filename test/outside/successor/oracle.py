"""Asks ``scc oracle`` (specs/oracle.md), one request at a time."""

from __future__ import annotations

import json
import subprocess
from typing import Any, List


class Refusal(Exception):
    """An error that the oracle answers."""

    def __init__(self, error: dict) -> None:
        super().__init__(json.dumps(error)[:500])
        self.error = error


class Oracle:
    def __init__(self, command: List[str]) -> None:
        self.process = subprocess.Popen(
            command,
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            text=True,
            bufsize=1,
            start_new_session=True,  # signals are for who asks
        )
        self.asked = 0

    def ask(self, method: str, **params: Any) -> Any:
        self.asked += 1
        request = {"jsonrpc": "2.0", "id": self.asked, "method": method, "params": params}
        assert self.process.stdin is not None and self.process.stdout is not None
        self.process.stdin.write(json.dumps(request) + "\n")
        self.process.stdin.flush()
        answer = json.loads(self.process.stdout.readline())
        if "error" in answer:
            raise Refusal(answer["error"])
        return answer["result"]

    def close(self) -> None:
        assert self.process.stdin is not None
        self.process.stdin.close()
        self.process.wait()
