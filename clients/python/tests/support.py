"""What the tests against the program share."""

import os
import shutil
import unittest

from shapecalculus import Oracle

HERE = os.path.dirname(os.path.abspath(__file__))
CLIENT = os.path.dirname(HERE)

CORNERS = [(x, y, z) for z in (-1, 1) for y in (-1, 1) for x in (-1, 1)]
FACES = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]
FACE_NAMES = ["bottom", "top", "front", "back", "left", "right"]

MODEL = """
param speed = 2

shape Cube {
  vertices a (-1,-1,-1)  b (1,-1,-1)  c (1,1,-1)  d (-1,1,-1)
           e (-1,-1,1)   f (1,-1,1)   g (1,1,1)   h (-1,1,1)
  faces    bottom [a,d,c,b]  top [e,f,g,h]  left [a,e,h,d]
           right [b,c,g,f]   front [a,b,f,e]  back [d,h,g,c]
}

behaviour Open  on Cube = <bond, {right}>. Bound
behaviour Shut  on Cube = <~bond, {left}>. Bound
behaviour Bound on Cube = eps(2). rho({<bond, {left, right}>}). nil

process p = Cube mass 3 velocity (speed,0,0) [Open]
process q = Cube mass 1 at translate (7,0,0) [Shut]

check meets : eventually bound(p, q)
"""


def program():
    """The scc to be tried: the one in SCC, which must be there, or the one on the PATH."""
    return os.environ.get("SCC") or shutil.which("scc")


class WithOracle(unittest.TestCase):
    """Tests which share one service; it must survive all of them."""

    @classmethod
    def setUpClass(cls):
        if program() is None:
            raise unittest.SkipTest("no scc: name it in the environment variable SCC")
        cls.oracle = Oracle(program(), timeout=600)
        cls.cube = cls.oracle.define_shape(CORNERS, FACES, face_names=FACE_NAMES)

    @classmethod
    def tearDownClass(cls):
        cls.oracle.close()
