"""A program within the guard whose worker does what it is told: ``python guarded.py WAY [CODE]``."""

import importlib.util
import os
import signal
import subprocess
import sys
import time

# Without the rest of the package, as this is started very often.
SOURCE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "src", "shapecalculus", "_guard.py")
spec = importlib.util.spec_from_file_location("_guard", SOURCE)
_guard = sys.modules["_guard"] = importlib.util.module_from_spec(spec)
spec.loader.exec_module(_guard)

REPORT = b"report\n"
SLEEP = [sys.executable, "-c", "import time; time.sleep(600)"]


def native_notices():
    """What a library writes, in all the ways that it has."""
    print("notice", flush=True)
    sys.stdout.write("no end of a line")
    os.write(1, b"notice\n")
    os.write(2, b"notice\n")
    sys.stderr.write("notice\n")
    program = "import os; os.write(1, b'notice'); os.write(2, b'notice')"
    subprocess.run([sys.executable, "-c", program], check=False)


def deaf():
    """Hears no signal, as a call of a library that does not come back."""
    signal.pthread_sigmask(signal.SIG_BLOCK, signal.valid_signals())
    child = subprocess.Popen(SLEEP)
    print("pids %d %d" % (os.getpid(), child.pid), flush=True)
    time.sleep(600)


def raises(e):
    raise e


WAYS = {
    "verdict": lambda: None,
    "notices": native_notices,
    "exit": lambda code: os._exit(code),
    "sys-exit": lambda code: sys.exit(code),
    "signal": lambda number: os.kill(os.getpid(), number),
    "failed": lambda code: raises(_guard.Failed("no", code)),
    "fault": lambda: [][0],
    "memory": lambda: raises(MemoryError()),
    "thread": lambda: raises(RuntimeError("can't start new thread")),
    "errno": lambda number: raises(OSError(number, os.strerror(number))),
    "interrupt": lambda: raises(KeyboardInterrupt()),
    "base": lambda: raises(GeneratorExit()),
    "closes": lambda: os.closerange(0, 64),
    "deaf": deaf,
    "after-report": lambda code: os._exit(code),
    "many": lambda: None,
    "slow-ending": lambda: None,
}


def main(way, *numbers):
    def work(out):
        if way == "after-report":
            out(REPORT)
        WAYS[way](*([] if way in ("verdict", "slow-ending") else map(int, numbers)))
        out(REPORT)
        for _ in range(4 if way == "many" else 0):
            out(b"x" * 99_999 + b"\n")  # more than a pipe holds
        return int(numbers[0]) if way in ("verdict", "slow-ending") else 0

    def ending():
        if way == "slow-ending":
            deaf()
        if way != "verdict":
            os._exit(1)  # nothing after a verdict changes it

    _guard.PATIENCE = _guard.SOON = 0.3
    return _guard.run(_guard.Program("guarded", work, ending, "the work is lost", "; go on"))


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
