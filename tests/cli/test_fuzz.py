"""Some of the random scenes of fuzz.py; that file says how to run more."""

import os
import unittest

from fuzz import fuzz
from support import PROGRAM

CASES = int(os.environ.get("TLSPH_FUZZ_CASES", "500"))


class Fuzz(unittest.TestCase):
    def test_no_scene_breaks_a_promise(self):
        codes, found = fuzz(PROGRAM, CASES)

        self.assertEqual(found, {})
        # Else the generator makes nothing that runs, or mutations do nothing.
        self.assertGreater(codes[0], CASES / 5)
        self.assertGreater(codes[2], CASES / 10)


if __name__ == "__main__":
    unittest.main()
