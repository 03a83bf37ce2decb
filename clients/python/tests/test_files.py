"""Files of checkpoints: what is damaged is never believed."""

import os
import tempfile
import unittest

from shapecalculus._files import BadFile, CannotKeep, get_file, make_folder, place, put_file


class Files(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.path = place(self.folder.name + "/", "a.part")

    def test_what_was_put_is_there(self):
        self.assertIsNone(get_file(self.path))
        for data in (b"", b"\n", bytes(range(256)) * 3):
            put_file(self.path, data)
            self.assertEqual(get_file(self.path), data)
        self.assertEqual(os.listdir(self.folder.name), ["a.part"])

    def test_every_damage_is_recognised(self):
        put_file(self.path, b"some states")
        with open(self.path, "rb") as f:
            whole = f.read()
        flipped = [whole[:k] + bytes([whole[k] ^ (1 << bit)]) + whole[k + 1 :] for k in range(len(whole)) for bit in (0, 7)]
        for data in [whole[:k] for k in range(len(whole))] + [whole + b"x"] + flipped:
            with open(self.path, "wb") as f:
                f.write(data)
            with self.assertRaises(BadFile) as caught:
                get_file(self.path)
            self.assertIn(self.path, str(caught.exception))

    def test_where_nothing_can_be_kept(self):
        put_file(self.path, b"x")
        below = place(self.path, "b.part")
        for what in (lambda: put_file(below, b"x"), lambda: get_file(below), lambda: make_folder(below)):
            with self.assertRaises(CannotKeep) as caught:
                what()
            self.assertIn(below, str(caught.exception))


if __name__ == "__main__":
    unittest.main()
