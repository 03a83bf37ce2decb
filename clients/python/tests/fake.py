"""A service that speaks the protocol badly: ``python fake.py WAY``. It answers 'never' to whatever else it is asked."""

import json
import os
import sys

DESCRIPTION = {
    "service": "scc-oracle", "protocol": 1, "version": "0", "semantics": "0", "methods": [], "limits": {"batch": 50000}
}
NEVER = {"outcome": "never", "time": None}


def answer(request, way):
    number = request["id"]
    if way == "no-description":
        return {"jsonrpc": "2.0", "id": number, "result": {"hello": "world"}}
    if way == "error-of-another-kind":
        return {"jsonrpc": "2.0", "id": number, "error": "no"}
    if request["method"] == "service.describe":
        return {"jsonrpc": "2.0", "id": number, "result": dict(DESCRIPTION, protocol=2 if way == "newer" else 1)}
    if way == "every-third-refused" and number % 3 == 2:
        return {"jsonrpc": "2.0", "id": number, "error": {"code": -32001, "message": "no", "data": {"handle": "s9"}}}
    if way == "strange-code":
        return {"jsonrpc": "2.0", "id": number, "error": {"code": -32099, "message": "what", "data": {"a": 1}}}
    return {"jsonrpc": "2.0", "id": number + (way == "wrong-ids"), "result": [] if way == "no-meeting" else NEVER}


def main(way):
    for line in sys.stdin:
        if way == "echo":
            print(line, end="", flush=True)
            continue
        message = json.loads(line)
        if isinstance(message, dict):
            reply = answer(message, way)
            if way == "garbage" and message["method"] != "service.describe":
                print("segmentation fault", flush=True)
                continue
        elif way == "line-refused":
            reply = {"jsonrpc": "2.0", "id": None, "error": {"code": -32000, "message": "long",
                                                             "data": {"limit": "batch", "most": 1}}}
        else:
            reply = [answer(request, way) for request in message]
            if way == "one-too-few":
                reply.pop()
            if way == "turned-round":
                reply.reverse()
        print(json.dumps(reply), flush=True)


try:
    main(sys.argv[1])
except BrokenPipeError:
    os._exit(0)
