"""The pipes, against small services that behave badly."""

import sys
import unittest

from shapecalculus import ServiceError
from shapecalculus._service import Service

ECHO = """
import sys
for line in sys.stdin.buffer:
    sys.stdout.buffer.write(line)
    sys.stdout.buffer.flush()
"""

# Answers each line a hundredfold, before it reads the next one.
WORDY = """
import sys
for line in sys.stdin.buffer:
    sys.stdout.buffer.write(line[:-1] * 100 + b"\\n")
    sys.stdout.buffer.flush()
"""

PIECEMEAL = """
import os, time
for byte in b"one\\ntwo\\nthr":
    os.write(1, bytes([byte]))
    time.sleep(0.001)
time.sleep(0.05)
os.write(1, b"ee\\nfour\\n")
"""


def service(program, timeout=600.0):
    return Service([sys.executable, "-c", program], timeout)


class Pipes(unittest.TestCase):
    def test_lines_come_back_in_order(self):
        s = service(ECHO)
        for i in range(100):
            s.send(b"%d\n" % i)
        self.assertEqual([s.receive() for _ in range(100)], [b"%d" % i for i in range(100)])
        self.assertEqual(s.close(), 0)

    def test_both_pipes_full(self):
        s = service(WORDY)
        line = b"x" * 30_000
        for _ in range(40):
            s.send(line + b"\n")
        for _ in range(40):
            self.assertEqual(s.receive(), line * 100)
        self.assertEqual(s.close(), 0)

    def test_one_line_larger_than_any_pipe(self):
        s = service(ECHO)
        line = bytes(range(32, 127)) * 100_000
        s.send(line + b"\n")
        self.assertEqual(s.receive(), line)
        s.close()

    def test_lines_in_pieces(self):
        s = service(PIECEMEAL)
        self.assertEqual([s.receive() for _ in range(4)], [b"one", b"two", b"three", b"four"])
        with self.assertRaises(ServiceError):
            s.receive()

    def test_close_twice(self):
        s = service(ECHO)
        self.assertEqual((s.close(), s.close()), (0, 0))
        with self.assertRaises(ServiceError):
            s.send(b"late\n")
        with self.assertRaises(ServiceError):
            s.receive()


class Failures(unittest.TestCase):
    def test_no_such_program(self):
        with self.assertRaises(ServiceError):
            Service(["/there/is/no/such/program"])

    def test_it_ends(self):
        s = service("import sys; sys.stdin.readline(); sys.exit(3)")
        s.send(b"hello\n")
        with self.assertRaisesRegex(ServiceError, r"ended.*exit code 3"):
            s.receive()

    def test_it_does_not_read_any_more(self):
        s = service("import os, time; os.close(0); os.write(1, b'closed\\n'); time.sleep(20)")
        self.assertEqual(s.receive(), b"closed")
        with self.assertRaisesRegex(ServiceError, "no longer reads"):
            s.send(b"x\n")

    def test_it_is_too_slow(self):
        s = service("import time; time.sleep(20)", timeout=0.1)
        s.send(b"x\n")
        with self.assertRaisesRegex(ServiceError, r"no answer within 0\.1 s"):
            s.receive()


class Timeouts(unittest.TestCase):
    def test_for_ever(self):
        for long in (float("inf"), 1e300, 10**12):
            s = service(ECHO, timeout=long)
            s.send(b"x\n")
            self.assertEqual(s.receive(), b"x")
            s.close()

    def test_what_is_none(self):
        for wrong in (float("nan"), -1):
            self.assertRaisesRegex(ValueError, "timeout is a number of seconds", service, ECHO, timeout=wrong)


if __name__ == "__main__":
    unittest.main()
