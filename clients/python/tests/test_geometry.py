"""Requests about shapes, to the program; expected values are found by hand."""

import pickle
import random
import unittest
from decimal import Decimal
from fractions import Fraction

from shapecalculus import (
    Body,
    Fixed,
    InvalidParams,
    LimitExceeded,
    Meeting,
    MethodNotFound,
    NotInContact,
    Oracle,
    ShapeRefused,
    Touch,
    UnknownHandle,
)
from tests.support import CORNERS, FACE_NAMES, FACES, MODEL, WithOracle, program

ORIGIN = (Fraction(0),) * 3


class Shapes(WithOracle):
    def test_figures(self):
        self.assertEqual((self.cube.vertices, self.cube.edges, self.cube.faces), (8, 12, 6))
        self.assertEqual((self.cube.volume, self.cube.centroid), (8, ORIGIN))
        self.assertRegex(self.cube.handle, r"^s[1-9][0-9]*$")

    def test_linear_and_quaternion(self):
        half = Fraction(1, 2)
        plank = self.oracle.define_shape(CORNERS, FACES, linear=[(3, 0, 0), (0, half, 0), (0, 0, 1)])
        self.assertEqual(plank.volume, 12)
        turned = self.oracle.define_shape(CORNERS, FACES, quaternion=(1, 0, 0, 1))
        self.assertEqual(turned.volume, 8)
        # The plank is 6 long and 1 wide: it meets a cube at 4 along x, and at 3/2 along y.
        self.assertEqual(self.oracle.first_time_of_contact(plank, turned, (9, 0, 0), (-1, 0, 0)).time, 5)
        self.assertEqual(self.oracle.first_time_of_contact(plank, turned, (0, 9, 0), (0, -1, 0)).time, Fraction(15, 2))
        with self.assertRaises(ShapeRefused):
            self.oracle.define_shape(CORNERS, FACES, linear=[(1, 0, 0), (0, 1, 0), (0, 0, 0)])

    def test_refused(self):
        with self.assertRaises(ShapeRefused) as caught:
            self.oracle.define_shape(CORNERS, FACES[:-1])
        fault = caught.exception.data["faults"][0]
        self.assertRegex(fault["code"], "^SC03[0-9]{2}$")
        report = self.oracle.check_shape(CORNERS, FACES[:-1])
        self.assertEqual((report.accepted, report.faults[0].code), (False, fault["code"]))
        self.assertIsNone(report.mass_properties)

    def test_check(self):
        report = self.oracle.check_shape(CORNERS, FACES, face_names=FACE_NAMES)
        self.assertTrue(report.accepted)
        self.assertEqual((report.faults, report.edges, report.euler), ((), 12, 2))
        self.assertEqual([c.number for c in report.conditions], [1, 2, 3, 4, 5, 6, 7])
        mass = report.mass_properties
        self.assertEqual((mass.volume, mass.centroid, mass.mass), (8, ORIGIN, 1))
        self.assertEqual(mass.inertia_of_mass[0], (Fraction(2, 3), 0, 0))

    def test_mass(self):
        mass = self.oracle.mass(self.cube, mass=3, at=(1, "1/2", 0.25))
        self.assertEqual((mass.mass, mass.centroid), (3, (1, Fraction(1, 2), Fraction(1, 4))))
        # m (2^2 + 2^2) / 12
        self.assertEqual(mass.inertia_of_mass, ((2, 0, 0), (0, 2, 0), (0, 0, 2)))
        self.assertEqual(self.oracle.mass(self.cube, turned=(2, 0, 0, 1)).inertia[2][2], Fraction(16, 3))

    def test_of_another_oracle(self):
        other = Oracle(program(), timeout=600)
        self.addCleanup(other.close)
        small = other.define_shape([[x / 2 for x in v] for v in CORNERS], FACES)
        mine = self.oracle.define_shape(CORNERS, FACES)
        again = pickle.loads(pickle.dumps(mine))
        self.assertEqual((again, self.oracle.mass(again).volume), (mine, 8))
        foreign = "of another Oracle"
        for shape in (small, small.handle, pickle.loads(pickle.dumps(small))):
            self.assertRaisesRegex(ValueError, foreign, self.oracle.mass, shape)
            self.assertRaisesRegex(ValueError, foreign, self.oracle.release_shape, shape)
            self.assertRaisesRegex(ValueError, foreign, self.oracle.contact, mine, shape, (2, 0, 0))
            touching = [Touch(mine, shape, (1, 0, 0))]
            self.assertRaisesRegex(ValueError, foreign, self.oracle.response, touching, Body(1, (1, 0, 0)), Fixed())
            casts = [(mine, mine, (4, 0, 0), (-1, 0, 0)), (shape, mine, (4, 0, 0), (-1, 0, 0))]
            self.assertRaisesRegex(ValueError, foreign, self.oracle.first_times_of_contact, casts)
            self.assertRaisesRegex(ValueError, foreign, self.oracle.batch().mass, shape)
        self.assertEqual(other.mass(small).volume, 1)
        model = other.load_model(MODEL)
        self.assertRaisesRegex(ValueError, foreign, self.oracle.successors, model)
        with self.oracle.batch() as batch:
            later = batch.define_shape(CORNERS, FACES)
        self.assertRaisesRegex(ValueError, foreign, other.mass, later.result())
        self.assertEqual(self.oracle.mass(later.result()).volume, 8)
        self.assertEqual(self.oracle.mass(str(mine.handle)).volume, 8)

    def test_release(self):
        shape = self.oracle.define_shape(CORNERS, FACES)
        self.assertIsNone(self.oracle.release_shape(shape))
        with self.assertRaises(UnknownHandle) as caught:
            self.oracle.mass(shape)
        self.assertEqual(caught.exception.data, {"handle": shape.handle})


class Contacts(WithOracle):
    def test_face_on_face(self):
        contact = self.oracle.contact(self.cube, self.cube, (2, 1, 0), velocity=(-1, 0, 0))
        self.assertEqual((contact.relation, contact.approaching), ("touching", True))
        self.assertEqual({corner[0] for corner in contact.region}, {1})
        self.assertEqual({corner[1:] for corner in contact.region}, {(y, z) for y in (0, 1) for z in (-1, 1)})
        self.assertEqual(contact.normals, ((1, 0, 0),))
        highest = contact.highest
        self.assertEqual((highest.first.kind, highest.first.name, highest.second.name), ("face", "right", "left"))
        self.assertEqual(highest.dimension, 2)
        self.assertEqual(sorted(highest.first.vertices), [1, 3, 5, 7])
        self.assertIn(highest, contact.pairs)

    def test_apart_and_inside(self):
        for x, relation in ((3, "apart"), (1, "interpenetrating")):
            contact = self.oracle.contact(self.cube, self.cube, (x, 0, 0))
            self.assertEqual((contact.relation, contact.region, contact.pairs), (relation, (), ()))
            self.assertIsNone(contact.highest)
            self.assertIsNone(contact.approaching)

    def test_within_resolution(self):
        gap = Fraction(1, 100)
        near = self.oracle.contact(self.cube, self.cube, (2 + gap, 0, 0), resolution="1/50", turned_b=(1, 0, 0, 1))
        self.assertEqual((near.relation, near.gap), ("near", (gap, 0, 0)))
        normal, height = near.plane
        self.assertEqual((normal[1:], height / normal[0]), ((0, 0), 1 + gap / 2))
        far = self.oracle.contact(self.cube, self.cube, (2 + gap, 0, 0), resolution="1/200")
        self.assertEqual((far.relation, far.gap), ("apart", None))

    def test_refused(self):
        for keywords in ({"velocity": (1, 0, 0), "resolution": 1}, {"resolution": 0}):
            with self.assertRaises(InvalidParams):
                self.oracle.contact(self.cube, self.cube, (2, 0, 0), **keywords)


class Casts(WithOracle):
    def test_outcomes(self):
        for offset, velocity, outcome, time in [
            ((4, 0, 0), (-1, 0, 0), "at", 2),
            ((4, 0, 0), ("-0.3", 0, 0), "at", Fraction(20, 3)),
            ((4, 0, 0), (Decimal("-0.3"), 0, 0), "at", Fraction(20, 3)),
            ((4, 0, 0), (-0.5, 0, 0), "at", 4),
            ((2, 0, 0), (-1, 0, 0), "at", 0),
            ((4, 2, 0), (-1, 0, 0), "never", None),
            ((1, 0, 0), (5, 0, 0), "inside", None),
        ]:
            with self.subTest(offset=offset, velocity=velocity):
                meeting = self.oracle.first_time_of_contact(self.cube, self.cube, offset, velocity)
                self.assertEqual((meeting.outcome, meeting.time), (outcome, time))
                self.assertEqual(meeting.collides, time is not None)

    def test_floats_are_taken_as_they_are(self):
        meeting = self.oracle.first_time_of_contact(self.cube, self.cube, (4, 0, 0), (-0.1, 0, 0))
        self.assertEqual(meeting.time, 2 / Fraction(0.1))

    def test_turning(self):
        # A cube of side 2 at distance 3 that turns a quarter in about pi/2: its corner reaches out to sqrt 2.
        meeting = self.oracle.first_time_of_contact(
            self.cube, self.cube, ("2.3", 0, 0), (0, 0, 0), spin_b=(0, 0, 1), span=4, grid=20
        )
        self.assertEqual((meeting.outcome, meeting.grid), ("at", 20))
        self.assertEqual((meeting.time * 2**20).denominator, 1)
        self.assertTrue(0 < meeting.time < 1)
        turn = dict(spin_b=(0, 0, 1), grid=4)
        for keywords, time in [
            (dict(since_b="1/10", span=4), Fraction(3, 16)),  # the grid counts from now
            (dict(since_b="1/10", span=4, phase=0), Fraction(3, 16)),
            (dict(since_b="1/10", span=4, phase="turn"), Fraction(1, 4) - Fraction(1, 10)),
            (dict(since_b="1/10", span=4, phase=Fraction(1, 10)), Fraction(1, 4) - Fraction(1, 10)),
            (dict(since_b="1/10", until="3/20", phase="turn"), Fraction(3, 20)),
            (dict(until="1/4"), Fraction(1, 4)),
            (dict(until="249/1000"), None),
        ]:
            with self.subTest(**keywords):
                meeting = self.oracle.first_time_of_contact(
                    self.cube, self.cube, ("9/4", 0, 0), (0, 0, 0), **turn, **keywords
                )
                self.assertEqual(meeting.time, time)
        still = self.oracle.first_time_of_contact(
            self.cube, self.cube, (4, 0, 0), (-1, 0, 0), span=3, resolution="1/1024", since_a=1, arm_b=(1, 0, 0)
        )
        self.assertEqual((still.outcome, still.time), ("at", 2))
        far = self.oracle.first_time_of_contact(
            self.cube, self.cube, (3, 0, 0), (0, 0, 0), spin_b=(0, 0, 1), span=4, grid=20
        )
        self.assertEqual(far.outcome, "never")

    def test_bulk_and_batch_as_one_by_one(self):
        chance = random.Random(7)
        turned = self.oracle.define_shape(CORNERS, FACES, quaternion=(3, 1, -1, 2))

        def vector(most):
            return tuple(Fraction(chance.randint(-most, most), chance.randint(1, 4)) for _ in range(3))

        casts = [(self.cube, chance.choice((self.cube, turned.handle)), vector(8), vector(3)) for _ in range(1500)]
        bulk = self.oracle.first_times_of_contact(casts)
        with self.oracle.batch() as batch:
            futures = [batch.first_time_of_contact(*cast) for cast in casts]
        # No assertEqual of the lists: it would look for their differences for minutes.
        self.assertEqual(len(bulk), len(casts))
        self.assertEqual([i for i, future in enumerate(futures) if future.result() != bulk[i]], [])
        self.assertEqual({meeting.outcome for meeting in bulk}, {"at", "never", "inside"})
        for cast, meeting in list(zip(casts, bulk))[::50]:
            self.assertEqual(self.oracle.first_time_of_contact(*cast), meeting)
            if meeting.collides:
                a, b, offset, velocity = cast
                there = tuple(p + meeting.time * v for p, v in zip(offset, velocity))
                contact = self.oracle.contact(a, b, there, velocity=velocity)
                self.assertEqual((contact.relation, contact.approaching), ("touching", True))

    def test_bulk_with_a_bad_handle(self):
        good, bad = (self.cube, self.cube, (4, 0, 0), (-1, 0, 0)), ("s4000", self.cube, (4, 0, 0), (-1, 0, 0))
        with self.assertRaises(UnknownHandle) as caught:
            self.oracle.first_times_of_contact([good] * 700 + [bad] + [good] * 700)
        self.assertEqual(caught.exception.index, 700)
        self.assertEqual(self.oracle.first_times_of_contact([good]), [Meeting("at", "2/1")])

    def test_bulk_with_what_is_no_vector(self):
        for offset in ("123", (1, 2), (1, 2, 3, 4)):
            with self.assertRaises(ValueError):
                self.oracle.first_times_of_contact([(self.cube, self.cube, offset, (-1, 0, 0))])

    def test_large_batches_do_not_block(self):
        long = Fraction(10**200 + 1, 10**199)
        casts = [(self.cube, self.cube, (long, i, 0), (-1, 0, 0)) for i in range(6000)]
        meetings = self.oracle.first_times_of_contact(casts)
        self.assertEqual(meetings[0].time, long - 2)
        self.assertEqual(meetings.count(Meeting("never")), 5998)

    def test_too_many_digits(self):
        with self.assertRaises(LimitExceeded) as caught:
            self.oracle.first_time_of_contact(self.cube, self.cube, (10**1500, 0, 0), (-1, 0, 0))
        self.assertEqual(caught.exception.data["limit"], "digits")
        self.assertEqual(caught.exception.data["most"], self.oracle.description.limits["digits"])


class Responses(WithOracle):
    def test_translational(self):
        after = self.oracle.response(
            [(self.cube, self.cube, (2, 0, 0))], Body(3, (2, 0, 0)), Body(1, (0, Fraction(1, 2), 0))
        )
        self.assertEqual(after.outcome, "bounced")
        self.assertEqual(after.first.velocity, (1, 0, 0))
        self.assertEqual(after.second.velocity, (3, Fraction(1, 2), 0))
        self.assertIsNone(after.first.spin)

    def test_off_a_wall(self):
        after = self.oracle.response([Touch(self.cube, self.cube, (2, 0, 0))], Body(3, (2, 1, 0)), Fixed())
        self.assertEqual((after.first.velocity, after.second.velocity), ((-2, 1, 0), ORIGIN))

    def test_parting(self):
        after = self.oracle.response([(self.cube, self.cube, (2, 0, 0))], Body(3, (-2, 0, 0)), Body(1, (0, 0, 0)))
        self.assertEqual((after.outcome, after.first.velocity), ("persistent", (-2, 0, 0)))

    def test_not_in_contact(self):
        with self.assertRaises(NotInContact) as caught:
            self.oracle.response([(self.cube, self.cube, (3, 0, 0))], Body(1, (1, 0, 0)), Fixed())
        self.assertEqual(caught.exception.data["relation"], "apart")

    def test_turning(self):
        inertia = self.oracle.mass(self.cube).inertia_of_mass
        still = ((0, 0, 0), inertia, (0, 0, 0))
        first = Body(1, (1, 0, 0), *still)
        second = Body(1, (0, 0, 0), (2, 0, 0), inertia, (0, 0, 0))
        touch = Touch(self.cube, self.cube, (2, 0, 0), at=(0, 0, 0))
        after = self.oracle.response([touch], first, second, resolution="1/1000")
        self.assertEqual((after.first.velocity, after.second.velocity), (ORIGIN, (1, 0, 0)))
        self.assertEqual((after.first.spin, after.second.spin), (ORIGIN, ORIGIN))


class Service(WithOracle):
    def test_description(self):
        description = self.oracle.describe()
        self.assertEqual((description.service, description.protocol), ("scc-oracle", 1))
        self.assertIn("first_time_of_contact", description.methods)
        self.assertEqual(description, self.oracle.description)

    def test_no_such_method(self):
        with self.assertRaises(MethodNotFound):
            self.oracle.call("shape.melt", {})
        with self.assertRaises(InvalidParams) as caught:
            self.oracle.call("shape.mass", {"shape": self.cube.handle, "colour": "red"})
        self.assertEqual(caught.exception.data["at"], "colour")


if __name__ == "__main__":
    unittest.main()
