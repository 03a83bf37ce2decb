"""Interrupts a command when it is at work, however busy the machine is.

    interrupt.py SECONDS COMMAND...

SIGINT comes when the command has its own answer to it (before, it would end the process), and it and its workers have
taken so many seconds of the processor. The exit code is that of the command.
"""

import os
import signal
import subprocess
import sys
import time


def answers(pid):
    """Whether a process has a handler for SIGINT."""
    with open("/proc/%d/status" % pid) as status:
        caught = next(line for line in status if line.startswith("SigCgt:"))
    return bool(int(caught.split()[1], 16) & 1 << (signal.SIGINT - 1))


def stat(pid):
    """The parent of a process, and the seconds of the processor that it has taken; of one that is gone, none."""
    try:
        with open("/proc/%s/stat" % pid) as file:
            fields = file.read().rsplit(")", 1)[1].split()
    except OSError:
        return None, 0
    return int(fields[1]), (int(fields[11]) + int(fields[12])) / 100


def worked(pid):
    """Seconds of the processor, of a process and its children."""
    stats = [(other, *stat(other)) for other in os.listdir("/proc") if other.isdigit()]
    return sum(seconds for other, parent, seconds in stats if pid in (int(other), parent))


def wait(process, seconds):
    """Until it answers and has worked so long; or has ended."""
    while process.poll() is None and not (answers(process.pid) and worked(process.pid) >= seconds):
        time.sleep(0.02)


def main():
    process = subprocess.Popen(sys.argv[2:])
    wait(process, float(sys.argv[1]))
    process.send_signal(signal.SIGINT)
    sys.exit(process.wait())


if __name__ == "__main__":
    main()
