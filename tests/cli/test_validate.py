"""`tlsph validate`: every quick case holds, the page of the repository says the same, and misuse."""

import json
import os
import re
import unittest

from support import SOURCE, ProgramTest

VALIDATION = SOURCE / "validation"


def rows_of(page):
    """{(case, source, quantity): (reference, observed, tolerance, verdict)} of a validation page."""
    rows, case = {}, ""
    for line in page.splitlines():
        if not line.startswith("| "):
            continue
        cells = [cell.strip() for cell in re.split(r"(?<!\\)\|", line)[1:-1]]
        if len(cells) != 7 or cells[0] == "case":
            continue
        case = re.sub(r"\[(.*)\]\(.*\)", r"\1", cells[0]) or case
        rows[(case, cells[1], cells[2])] = tuple(cells[3:])
    return rows


class Validate(ProgramTest):
    def test_quick_cases_hold_and_the_page_says_so(self):
        done = self.tlsph("validate", "--quick", "--out", "results")

        self.assertEqual((done.returncode, done.stderr), (0, ""), done.stdout)
        table = json.loads((self.folder / "results/validation.json").read_text(encoding="utf-8"))
        self.assertTrue(table["holds"])
        page = rows_of((VALIDATION / "README.md").read_text(encoding="utf-8"))
        rows = rows_of((self.folder / "results/validation.md").read_text(encoding="utf-8"))
        self.assertGreater(len(rows), 50)
        for key, (reference, _, tolerance, verdict) in rows.items():
            with self.subTest(key):
                self.assertIn(key, page)
                self.assertEqual(page[key][0::2], (reference, tolerance))
                self.assertEqual(page[key][3], verdict)

    def test_each_case_has_its_folder_on_the_page(self):
        page = rows_of((VALIDATION / "README.md").read_text(encoding="utf-8"))
        cases = {case for case, _, _ in page}
        pages = {"plotting", "peers", "stability", "chart"}
        folders = {path.parent.name for path in VALIDATION.glob("*/README.md")} - pages

        self.assertEqual(cases, folders)
        self.assertFalse([key for key, row in page.items() if row[3] == "FAILS"])

    def test_only_the_named_case_runs(self):
        done = self.tlsph("validate", "three_materials", "--out", "results", "--quiet")

        self.assertEqual((done.returncode, done.stdout, done.stderr), (0, "", ""))
        table = json.loads((self.folder / "results/validation.json").read_text(encoding="utf-8"))
        self.assertEqual([case["case"] for case in table["cases"]], ["three_materials"])
        self.assertTrue((self.folder / "results/three_materials").is_dir())

    def test_an_unknown_case_is_bad_input(self):
        done = self.tlsph("validate", "three_matrials")

        self.assertEqual((done.returncode, done.stdout), (2, ""))
        self.assertIn('there is no case "three_matrials"; choose from ', done.stderr)
        self.assertIn("three_materials", done.stderr)
        self.assertEqual(self.listing(), [])

    def test_a_missing_folder_of_cases_is_told(self):
        done = self.tlsph("validate", "three_materials", env=dict(os.environ, TLSPH_VALIDATION="/no/such/folder"))

        self.assertEqual(done.returncode, 1)
        self.assertIn("came to no end: ", done.stdout)
        self.assertIn("/no/such/folder/three_materials/bar.toml", done.stdout)


if __name__ == "__main__":
    unittest.main()
