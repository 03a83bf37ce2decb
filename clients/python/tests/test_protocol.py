"""What the client makes of a service that does not do what it should, and how it writes what it sends."""

import concurrent.futures
import copy
import json
import os
import pickle
import sys
import unittest
from decimal import Decimal
from fractions import Fraction

from shapecalculus import Batch, LimitExceeded, Meeting, Oracle, OracleError, RequestError, ServiceError, UnknownHandle
from shapecalculus import _source as source
from shapecalculus import errors, numbers, oracle, requests
from shapecalculus.oracle import _batch, _cast_texts, _lines

FAKE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "fake.py")


def fake(way):
    return Oracle([sys.executable, FAKE, way], timeout=600)


def casts(count):
    return [("s1", "s2", (i, 0, 0), (-1, 0, 0)) for i in range(count)]


class Services(unittest.TestCase):
    def test_another_protocol(self):
        with self.assertRaisesRegex(ServiceError, "protocol 2"):
            fake("newer")

    def test_no_oracle_at_all(self):
        with self.assertRaises(ServiceError):
            Oracle([sys.executable, "-c", ""])

    def test_all_is_well(self):
        with fake("well") as oracle:
            self.assertEqual(oracle.first_times_of_contact(casts(3000)).count(Meeting("never")), 3000)
            self.assertEqual(oracle.first_time_of_contact("s1", "s1", (3, 0, 0), (1, 0, 0)).outcome, "never")
            self.assertEqual(oracle.first_times_of_contact([]), [])

    def test_garbage(self):
        with fake("garbage") as oracle:
            with self.assertRaisesRegex(ServiceError, "no JSON"):
                oracle.first_time_of_contact("s1", "s1", (3, 0, 0), (1, 0, 0))
            with self.assertRaises(ServiceError):
                oracle.describe()

    def test_nesting_without_end(self):
        with self.assertRaisesRegex(ServiceError, "no JSON"):
            Oracle([sys.executable, "-c", "print('[' * 10**6)"], timeout=20)

    def test_answers_to_something_else(self):
        with fake("wrong-ids") as oracle:
            with self.assertRaises(ServiceError):
                oracle.first_time_of_contact("s1", "s1", (3, 0, 0), (1, 0, 0))
        for way in ("wrong-ids", "one-too-few", "turned-round"):
            with self.subTest(way), fake(way) as oracle:
                with self.assertRaisesRegex(ServiceError, "one by one"):
                    oracle.first_times_of_contact(casts(1000))

    def test_a_program_that_echoes(self):
        with self.assertRaisesRegex(ServiceError, "does not answer requests as scc oracle does: it sends back"):
            fake("echo")
        with self.assertRaisesRegex(ServiceError, "does not answer requests"):
            Oracle(["cat"], timeout=600)

    def test_answers_that_are_none(self):
        with self.assertRaisesRegex(ServiceError, "answer to service.describe is none: {'hello'"):
            fake("no-description")
        with self.assertRaisesRegex(ServiceError, "does not answer requests"):
            fake("error-of-another-kind")
        for ask in (
            lambda oracle: oracle.first_time_of_contact("s1", "s1", (3, 0, 0), (1, 0, 0)),
            lambda oracle: oracle.first_times_of_contact(casts(2)),
        ):
            with fake("no-meeting") as oracle:
                with self.assertRaisesRegex(ServiceError, "answer to first_time_of_contact is none"):
                    ask(oracle)
                with self.assertRaises(ServiceError):
                    oracle.describe()

    def test_code_of_a_later_version(self):
        with fake("strange-code") as oracle:
            with self.assertRaises(RequestError) as caught:
                oracle.first_time_of_contact("s1", "s1", (3, 0, 0), (1, 0, 0))
        self.assertEqual((caught.exception.code, caught.exception.data), (-32099, {"a": 1}))
        self.assertIsInstance(caught.exception, OracleError)


class Refusals(unittest.TestCase):
    def test_bulk_tells_the_first(self):
        with fake("every-third-refused") as oracle:
            with self.assertRaises(UnknownHandle) as caught:
                oracle.first_times_of_contact(casts(2000))
            self.assertEqual((caught.exception.index, caught.exception.data["handle"]), (2, "s9"))
            self.assertEqual(len(oracle.first_times_of_contact(casts(2))), 2)

    def test_each_future_has_its_own(self):
        with fake("every-third-refused") as oracle:
            with oracle.batch() as batch:
                futures = [batch.first_time_of_contact(*cast) for cast in casts(1000)]
                self.assertFalse(futures[0].done)
                with self.assertRaises(RuntimeError):
                    futures[0].result()
            refused = [i for i, future in enumerate(futures) if future.error() is not None]
            self.assertEqual(refused, list(range(2, 1000, 3)))
            self.assertEqual(futures[0].result(), Meeting("never"))
            with self.assertRaises(UnknownHandle):
                futures[2].result()

    def test_a_line_is_refused(self):
        with fake("line-refused") as oracle:
            with oracle.batch() as batch:
                futures = [batch.first_time_of_contact(*cast) for cast in casts(3)]
            self.assertTrue(all(isinstance(future.error(), LimitExceeded) for future in futures))

    def test_nothing_is_sent_when_the_block_fails(self):
        with fake("well") as oracle:
            with self.assertRaises(ZeroDivisionError):
                with oracle.batch() as batch:
                    future = batch.first_time_of_contact("s1", "s1", (3, 0, 0), (1, 0, 0))
                    raise ZeroDivisionError
            self.assertFalse(future.done)

    def test_a_mistake_amid_a_bulk_call(self):
        def wrong():
            yield from casts(1700)
            yield ("s1", "s2", (1, 2), (3, 4, 5))

        with fake("well") as oracle:
            with self.assertRaises(ValueError):
                oracle.first_times_of_contact(wrong())
            self.assertEqual(len(oracle.first_times_of_contact(casts(600))), 600)
            oracle.describe()

    def test_an_interruption_after_a_mistake(self):
        """Answers that nobody has taken would be those to the next requests."""

        def wrong():
            yield from casts(600)
            raise ValueError

        def interrupted():
            raise KeyboardInterrupt

        with fake("well") as oracle:
            receive, oracle._service.receive = oracle._service.receive, interrupted
            with self.assertRaises(KeyboardInterrupt):
                oracle.first_times_of_contact(wrong())
            oracle._service.receive = receive
            with self.assertRaisesRegex(ServiceError, "closed"):
                oracle.first_times_of_contact(casts(2))


class Pickles(unittest.TestCase):
    def test_every_exception(self):
        for code in [*errors._CLASSES, -32099]:
            error = errors.from_json({"code": code, "message": "no", "data": {"at": ["a", 1]}}, 7)
            error.note = "mine"
            for protocol in range(pickle.HIGHEST_PROTOCOL + 1):
                again = pickle.loads(pickle.dumps(error, protocol))
                self.assertIs(type(again), type(error))
                self.assertEqual(
                    (str(again), again.code, again.message, again.data, again.index, again.note),
                    (str(error), code, "no", {"at": ["a", 1]}, 7, "mine"),
                )
            self.assertEqual(str(copy.copy(error)), str(error))
        again = pickle.loads(pickle.dumps(ServiceError("the service has ended")))
        self.assertEqual((type(again), str(again)), (ServiceError, "the service has ended"))

    def test_from_another_process(self):
        with concurrent.futures.ProcessPoolExecutor(1) as pool:
            with self.assertRaises(UnknownHandle) as caught:
                pool.submit(refused).result(60)
            self.assertEqual((caught.exception.index, caught.exception.data["handle"]), (2, "s9"))
            self.assertEqual(pool.submit(len, "abc").result(60), 3)


def refused():
    with fake("every-third-refused") as oracle:
        oracle.first_times_of_contact(casts(5))


class Int64:
    """As an integer of numpy: neither an int nor a numbers.Integral."""

    def __init__(self, value):
        self.value = value

    def __index__(self):
        return self.value


class Float32:
    """As a float of numpy that is no float of Python."""

    def __init__(self, value):
        self.value = value

    def as_integer_ratio(self):
        return self.value.as_integer_ratio()


def params(request):
    """As the service reads them."""
    return json.loads(oracle._to_json(request.params))


class NumbersOfOthers(unittest.TestCase):
    def test_numbers_of_any_length(self):
        for zeros in (598, 599, 639, 640, 4299, 4300, 20000):
            for value, text in [(10**zeros, "1" + zeros * "0"), (Fraction(-(10**zeros), 3), "-1%s/3" % (zeros * "0"))]:
                for given in (value, Fraction(value), text, numbers.LongFraction(value)):
                    self.assertEqual(numbers.exact(given), value)
                    said = json.loads(numbers.to_text(given), parse_int=str)
                    self.assertIn(said, (text, text + "/1"))
                    self.assertEqual(numbers.vector_to_text([given, 1, 1]).count("0"), zeros)
                    self.assertIn(text, oracle._to_json(numbers.vector_to_json([given, 1, 1])))
                    self.assertEqual(source.number("--time", given), ["--time=" + text])
                answer = numbers.fraction(text if "/" in text else text + "/1")
                self.assertEqual((answer, hash(answer)), (value, hash(value)))
                self.assertTrue(str(answer) and repr(answer))
                self.assertEqual(copy.deepcopy(pickle.loads(pickle.dumps(answer))), value)
        self.assertEqual(numbers.exact("0." + 700 * "0" + "1"), Fraction(1, 10**701))
        for wrong in ("x" * 5000, "1/" + 5000 * "0", 5000 * "1" + "/", "nan" + 5000 * "1"):
            self.assertRaisesRegex(ValueError, "not a number", numbers.to_json, wrong)

    def test_all_numbers(self):
        for number, same in [(Int64(-3), -3), (Float32(0.1), 0.1), (Float32(3.0), 3)]:
            self.assertEqual(numbers.to_json(number), numbers.to_json(same))
            self.assertEqual(Fraction(json.loads(numbers.to_text(number))), Fraction(same))
            self.assertEqual(numbers.vector_to_text([number] * 3).count(numbers.to_text(number)), 3)
        for wrong in (Float32(float("nan")), Float32(float("inf"))):
            self.assertRaisesRegex(ValueError, "not a number", numbers.to_json, wrong)
        for wrong in (None, 1j, [1], object()):
            self.assertRaisesRegex(TypeError, "not a number: .*__index__", numbers.to_json, wrong)

    def test_all_integers(self):
        one = Int64(1)
        shape = requests.define_shape([(one, 0, 0)] * 4, [[Int64(0), one, Int64(2)], ("v1", 2, 3)])
        self.assertEqual(params(shape)["faces"], [[0, 1, 2], ["v1", 2, 3]])
        self.assertEqual(params(requests.successors("m1", (one, 0)))["path"], [1, 0])
        self.assertEqual(params(requests.step("m1", [one], one)), {"model": "m1", "path": [1], "choice": 1})
        run = requests.replay("m1", [one, {"choice": one, "label": "x"}, "y"], steps=one)
        self.assertEqual(params(run)["choices"], [1, {"choice": 1, "label": "x"}, "y"])
        self.assertEqual(params(run)["steps"], 1)
        self.assertEqual(params(requests.replay("m1", seed=one))["choose"], {"random": 1})
        asked = requests.evaluate("m1", "true", [one], states=one, depth=one, time=one, seconds=Float32(0.5))
        self.assertEqual(params(asked)["limits"], {"seconds": "1/2", "states": 1, "depth": 1, "time": 1})
        turning = requests.first_time_of_contact("s1", "s1", (one, 0, 0), (one, 0, 0), span=one, grid=one)
        self.assertEqual((params(turning)["grid"], params(turning)["span"]), (1, 1))
        self.assertRaisesRegex(TypeError, "not an integer: 1.5", requests.replay, "m1", steps=1.5)
        self.assertRaisesRegex(TypeError, "not an integer", requests.successors, "m1", [0.0])

    def test_numpy(self):
        try:
            import numpy as np
        except ImportError:
            self.skipTest("no numpy")
        for kind in (np.int8, np.int64, np.uint16, np.float16, np.float32, np.float64, np.longdouble):
            with self.subTest(kind.__name__):
                self.assertEqual(numbers.vector_to_json(np.array([1, 2, 3], dtype=kind)), [1, 2, 3])
                self.assertEqual(Fraction(json.loads(numbers.to_text(kind(5)))), 5)
        self.assertEqual(numbers.to_json(np.float32(0.1)), "13421773/134217728")
        self.assertEqual(numbers.matrix_to_json(np.eye(3)), [[1, 0, 0], [0, 1, 0], [0, 0, 1]])
        faces = np.array([[0, 1, 2]])
        self.assertEqual(params(requests.define_shape(np.zeros((3, 3)), faces))["faces"], [[0, 1, 2]])
        self.assertRaises(TypeError, numbers.to_json, np.array([1, 2]))
        self.assertRaises(ValueError, numbers.to_json, np.float32("nan"))

    def test_choose(self):
        choose = lambda **how: params(requests.replay("m1", **how))["choose"]
        self.assertEqual(choose(choose="random", seed=1), {"random": 1})
        self.assertEqual(choose(seed=1), {"random": 1})
        self.assertEqual(choose(choose="first"), "first")
        self.assertRaisesRegex(ValueError, "takes a seed", choose, choose="random")
        self.assertRaisesRegex(ValueError, "a seed goes with", choose, choose="first", seed=1)


class Writing(unittest.TestCase):
    def test_numbers(self):
        for number, json_value in [
            (3, 3),
            (-0, 0),
            (Fraction(-3, 6), "-1/2"),
            (Fraction(4), 4),
            (0.5, "1/2"),
            (0.1, "3602879701896397/36028797018963968"),
            ("0.1", "1/10"),
            ("-6/4", "-3/2"),
            (Decimal("1.25"), "5/4"),
            (True, 1),
            (10**50, 10**50),
        ]:
            with self.subTest(number):
                self.assertEqual(numbers.to_json(number), json_value)
                self.assertEqual(Fraction(json.loads(numbers.to_text(number))), Fraction(json_value))

    def test_what_is_no_number(self):
        for wrong in (float("nan"), float("inf"), "x", "1/0", '1","a":"', ""):
            with self.subTest(wrong):
                self.assertRaises(ValueError, numbers.to_json, wrong)
                self.assertRaises(ValueError, numbers.to_text, wrong)
        for wrong in ((1, 2), (1, 2, 3, 4), "123"):
            with self.subTest(wrong):
                self.assertRaises(ValueError, numbers.vector_to_json, wrong)
        self.assertRaises(ValueError, numbers.matrix_to_json, [(1, 0, 0)])
        self.assertRaises(TypeError, numbers.to_json, None)

    def test_bulk_casts_are_written_as_single_ones(self):
        offset, velocity = (1, Fraction(2, 3), 0.25), ("1e-1", -7, Decimal(3))
        for count, text in enumerate(_cast_texts([("s1", "s22", offset, velocity)] * 2)):
            request = requests.first_time_of_contact("s1", "s22", offset, velocity)
            read = json.loads(text)
            self.assertEqual(read["id"], count)
            self.assertEqual(read["method"], request.method)
            for name in ("offset", "velocity"):
                exact = [Fraction(x) for x in read["params"][name]]
                self.assertEqual(exact, [Fraction(x) for x in request.params[name]])

    def test_handles_are_no_way_in(self):
        self.assertRaises(ValueError, requests.cast_template, 's1","x":"', "s1")

    def test_lines(self):
        texts = [str(i) for i in range(1100)]
        lines = list(_lines(texts))
        self.assertEqual([(first, count) for first, count, _ in lines], [(0, 512), (512, 512), (1024, 76)])
        self.assertEqual([x for _, _, line in lines for x in json.loads(line)], list(range(1100)))
        long = ['"%s"' % ("x" * 700_000)] * 3
        self.assertEqual([count for _, count, _ in _lines(long)], [1, 1, 1])
        self.assertEqual(_batch(["1", "2"]), b"[1,2]\n")


class Answers(unittest.TestCase):
    def test_meetings(self):
        hit = Meeting("at", "6/4")
        self.assertEqual((hit.time, hit.collides), (Fraction(3, 2), True))
        self.assertEqual(repr(hit), "Meeting(outcome='at', time=Fraction(3, 2))")
        self.assertEqual(len({Meeting("never"), Meeting("never"), Meeting("inside")}), 2)
        self.assertNotEqual(Meeting("at", "1/1", 3), Meeting("at", "1/1"))
        self.assertIsNone(Meeting("never").time)

    def test_all_methods_are_in_batches_too(self):
        returns = {name: getattr(value, "__annotations__", {}).get("return") for name, value in vars(requests).items()}
        methods = [name for name, made in returns.items() if str(made).startswith("Request[")]
        self.assertGreaterEqual(len(methods), 14)
        for name in sorted(methods):
            self.assertTrue(callable(getattr(Oracle, name)), name)
            self.assertTrue(callable(getattr(Batch, name)), name)


if __name__ == "__main__":
    unittest.main()
