"""`tlsph benchmark` sets steps beside what the machine can do. Its timings are no matter here."""

import csv
import json
import unittest

from support import ProgramTest


class Benchmark(ProgramTest):
    def test_table_and_files(self):
        done = self.tlsph("benchmark", "--particles", "1000", "--seconds", "1e-4", "--out", "out")

        self.assertEqual(done.returncode, 0, done.stderr)
        for word in ("triad", "multiply-adds", "share", "memory", "collocated, 21 neighbours"):
            self.assertIn(word, done.stdout)
        tree = json.loads((self.folder / "out/benchmark.json").read_text())
        with open(self.folder / "out/benchmark.csv", newline="") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual([row["case"] for row in rows], [row["case"] for row in tree["rows"]])
        for row, entry in zip(rows, tree["rows"]):
            with self.subTest(row["case"]):
                self.assertGreater(float(row["ns"]), 0)
                self.assertGreater(entry["share_of_limit"], 0)
                nodes_and_points = int(row["stencil_rows"]) + int(row["general_rows"])
                self.assertGreater(nodes_and_points, 1.8 * int(row["particles"]))
                # A thousand particles have few rows that are alike 96 neighbours wide.
                if not any(word in row["case"] for word in ("irregular", "mixed", "96")):
                    self.assertLess(int(row["general_rows"]), 0.1 * nodes_and_points + 30)
        wide = next(row for row in rows if row["case"].startswith("collocated, 96"))
        self.assertGreater(float(wide["neighbours"]), 60)

    def test_bad_arguments(self):
        for arguments in (("--particles", "3"), ("--seconds", "0"), ("--what",)):
            with self.subTest(arguments):
                done = self.tlsph("benchmark", *arguments)

                self.assertEqual(done.returncode, 2)
                self.assertFalse((self.folder / "out").exists())


if __name__ == "__main__":
    unittest.main()
