"""`tlsph validate`: every quick case holds, the page of the repository says the same, and misuse."""

import json
import os
import pathlib
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


def pages_below(folder):
    """Pages of its folders, as paths from there."""
    return sorted(str(path.relative_to(folder)) for path in folder.glob("*/README.md"))


def links_of(page):
    """Folders of this repository that a page links to, itself or a page of theirs."""
    targets = re.findall(r"\]\(([^)#:]+)\)", page.read_text(encoding="utf-8"))
    paths = [pathlib.Path(os.path.normpath(page.parent / target)) for target in targets]
    return [path.parent if path.suffix else path for path in paths]


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

    def cases(self):
        """The program's own list."""
        return set(re.search(r"choose from (.*)", self.tlsph("validate", "none").stderr)[1].split(" | "))

    def test_the_page_holds_each_case_and_each_has_its_folder(self):
        page = rows_of((VALIDATION / "README.md").read_text(encoding="utf-8"))
        cases = self.cases()

        self.assertGreater(len(cases), 15)
        self.assertEqual({case for case, _, _ in page}, cases)
        self.assertLessEqual({f"{case}/README.md" for case in cases}, set(pages_below(VALIDATION)))
        self.assertFalse([key for key, row in page.items() if row[3] == "FAILS"])

    def test_a_folder_that_is_no_case_is_spoken_of_on_another_page(self):
        cases = self.cases()
        for page in pages_below(VALIDATION):
            name = page.split("/")[0]
            if name in cases:
                continue
            with self.subTest(name):
                others = {SOURCE / "README.md", *VALIDATION.glob("**/README.md")} - {VALIDATION / page}
                links = [target for other in others for target in links_of(other)]
                self.assertIn(VALIDATION / name, links)

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
