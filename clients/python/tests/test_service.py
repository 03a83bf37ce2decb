"""The pipes, against small services that behave badly."""

import gc
import os
import signal
import sys
import tempfile
import time
import unittest

from shapecalculus import Oracle, ServiceError
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


    def test_what_cannot_be_run(self):
        with tempfile.TemporaryDirectory() as folder:
            text, empty = os.path.join(folder, "text"), os.path.join(folder, "empty")
            for path, mode in ((text, 0o644), (empty, 0o755)):
                with open(path, "w", encoding="utf-8"):
                    os.chmod(path, mode)
            for name in (folder, text, empty, "a\0b", os.path.join(text, "below")):
                with self.subTest(name), self.assertRaisesRegex(ServiceError, "cannot start"):
                    Service([name])

    def test_half_a_line(self):
        for end, said in [("sys.exit(0)", "exit code 0"), ("os.kill(os.getpid(), 9)", "signal 9")]:
            s = service("import os, sys; os.write(1, b'{'); " + end)
            with self.assertRaisesRegex(ServiceError, r"has ended \(%s\)" % said):
                s.receive()
            with self.assertRaises(ServiceError):
                s.receive()

    def test_it_closes_its_output_and_lives(self):
        s = service("import os, time; os.write(1, b'half'); os.close(1); time.sleep(600)")
        with self.assertRaisesRegex(ServiceError, "has ended$"):
            s.receive()
        self.assertIsNotNone(s._process.poll())


class Interruptions(unittest.TestCase):
    """Ctrl-C, which a service brings about at a known place."""

    STOP = "os.kill(os.getppid(), signal.SIGINT); time.sleep(600)"

    def setUp(self):
        # A shell that starts the tests beside other work lets them ignore it.
        before = signal.signal(signal.SIGINT, signal.default_int_handler)
        self.addCleanup(signal.signal, signal.SIGINT, before)

    def test_while_an_answer_is_awaited(self):
        start = time.monotonic()
        with self.assertRaises(KeyboardInterrupt):
            Oracle([sys.executable, "-c", "import os, signal, sys, time; sys.stdin.readline(); " + self.STOP])
        self.assertLess(time.monotonic() - start, 4)  # nobody waits for its answer

    def test_while_it_is_closed(self):
        s = service("import os, signal, sys, time; sys.stdin.read(); " + self.STOP)
        with self.assertRaises(KeyboardInterrupt):
            s.close()
        self.assertEqual(s._process.returncode, -signal.SIGKILL)


class Processes(unittest.TestCase):
    def test_after_a_fork(self):
        s = service(ECHO)
        s.send(b"one\n")
        child = os.fork()
        if child == 0:
            code = 1
            try:
                for call in (lambda: s.send(b"two\n"), s.receive):
                    with self.assertRaisesRegex(ServiceError, "belongs to the process that started it"):
                        call()
                self.assertIsNone(s.close())
                code = 0
            finally:
                os._exit(code)
        self.assertEqual(os.waitpid(child, 0)[1], 0)
        self.assertEqual(s.receive(), b"one")
        s.send(b"three\n")
        self.assertEqual(s.receive(), b"three")
        self.assertEqual(s.close(), 0)

    def test_dropped(self):
        for program in (ECHO, "import time; time.sleep(600)"):
            s = service(program)
            process, pipes = s._process, (s._stdin, s._stdout)
            del s
            gc.collect()
            self.assertIsNotNone(process.returncode)
            self.assertTrue(all(pipe.closed for pipe in pipes))

    def test_dropped_after_a_fork(self):
        s = service(ECHO)
        child = os.fork()
        if child == 0:
            del s
            gc.collect()
            os._exit(0)
        os.waitpid(child, 0)
        s.send(b"x\n")
        self.assertEqual(s.receive(), b"x")
        self.assertEqual(s.close(), 0)


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
