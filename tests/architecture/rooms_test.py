#!/usr/bin/env python3
"""Shows that rooms.py finds each kind of violation, and finds none where there is none."""

import pathlib
import tempfile
import unittest

import rooms

CMAKE = """
tlsph_room(core LINK Eigen3::Eigen)
tlsph_room(linear ROOMS core PRIVATE_LINK $<BUILD_INTERFACE:suitesparse>)
tlsph_room(io ROOMS core PRIVATE_LINK hdf5)   # ROOMS linear in a comment counts for nothing
tlsph_room(simulation ROOMS core linear
           io)
tlsph_room(studies ROOMS simulation)
"""


class Rooms(unittest.TestCase):
    def check(self, cmake=CMAKE, **files):
        """Complaints about a small tree; a key `src__io__a_cpp` is the file src/io/a.cpp."""
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder)
            for name in ("include/tlsph", "src"):
                (root / name).mkdir(parents=True)
            (root / "src/CMakeLists.txt").write_text(cmake)
            for key, text in files.items():
                stem, suffix = key.replace("__", "/").rsplit("_", 1)
                path = root / f"{stem}.{suffix}"
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_text(text)
            return rooms.check(root)

    def assert_complaint(self, text, **files):
        violations, _ = self.check(**files)
        self.assertEqual(len(violations), 1, violations)
        self.assertIn(text, violations[0])

    def test_the_table_is_read_from_cmake(self):
        table = rooms.allowed_rooms(CMAKE)
        self.assertEqual(table["io"], {"io", "core"})
        self.assertEqual(table["simulation"], {"simulation", "core", "linear", "io"})
        self.assertEqual(table["studies"], {"studies", "simulation", "core", "linear", "io"})
        self.assertEqual(table["programs"], set(table))

    def test_a_room_may_be_named_only_after_its_declaration(self):
        with self.assertRaises(SystemExit):
            rooms.allowed_rooms("tlsph_room(a ROOMS b)\ntlsph_room(b)")

    def test_the_library_includes_no_study(self):
        cmake = "tlsph_room(core)\ntlsph_room(chart STUDY ROOMS core)\ntlsph_room(plan ROOMS {})\n"
        self.assertEqual(self.check(cmake.format("core"))[0], [])
        violations, _ = self.check(cmake.format("core chart"))
        self.assertEqual(len(violations), 1, violations)
        self.assertIn("plan, of the library, may include the study chart", violations[0])

    def test_lines_are_counted_by_room(self):
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder)
            for name in ("include/tlsph/io/a.hpp", "src/io/a.cpp"):
                (root / name).parent.mkdir(parents=True)
                (root / name).write_text("1\n2\n")
            self.assertEqual(rooms.count_lines(root), {"io": 4})

    def test_what_is_allowed_passes(self):
        violations, warnings = self.check(
            include__tlsph__linear__lu_hpp="#pragma once\n#include <Eigen/Core>\n#include <vector>\n",
            src__linear__private_hpp="#pragma once\n#include <umfpack.h>\n",
            src__linear__lu_cpp='#include "private.hpp"\n#include "tlsph/linear/lu.hpp"\n'
            '#include "tlsph/core/types.hpp"\n#include <SuiteSparseQR.hpp>\n#include <sys/wait.h>\n',
            src__studies__plan_cpp='#include "tlsph/io/csv.hpp"\n#include <nlohmann/json.hpp>\n',
            src__programs__main_cpp='#include "tlsph/studies/plan.hpp"\n#include <CLI/CLI.hpp>\n',
        )
        self.assertEqual((violations, warnings), ([], []))

    def test_another_room(self):
        self.assert_complaint("src/linear/lu.cpp:2: room linear may not include io",
                              src__linear__lu_cpp='\n#include "tlsph/io/csv.hpp"\n')

    def test_another_room_in_angle_brackets(self):
        self.assert_complaint("room io may not include linear",
                              include__tlsph__io__a_hpp="#pragma once\n# include <tlsph/linear/lu.hpp>\n")

    def test_a_path_around_the_rooms(self):
        self.assert_complaint("neither", src__io__a_cpp='#include "../linear/private.hpp"\n')

    def test_a_file_that_is_not_beside(self):
        self.assert_complaint("neither", src__io__a_cpp='#include "private.hpp"\n')

    def test_a_third_party_through_the_wrong_door(self):
        for header in ("toml++/toml.h", "CLI/CLI.hpp", "hdf5.h", "nanoflann.hpp", "cholmod.h",
                       "suitesparse/umfpack.h", "armadillo", "nlohmann/json.hpp"):
            with self.subTest(header):
                self.assert_complaint("whose door is", src__core__a_cpp=f"#include <{header}>\n")

    def test_a_third_party_in_a_public_header_of_its_own_room(self):
        self.assert_complaint("shows HDF5",
                              include__tlsph__io__a_hpp="#pragma once\n#include <hdf5.h>\n")

    def test_a_third_party_nobody_has_listed(self):
        self.assert_complaint("on no list", src__core__a_cpp="#include <absl/types/optional.h>\n")

    def test_a_room_that_does_not_exist(self):
        self.assert_complaint("no room attic", src__attic__a_cpp="")
        self.assert_complaint("no room attic", src__core__a_cpp='#include "tlsph/attic/a.hpp"\n')

    def test_a_header_without_guard(self):
        self.assert_complaint("pragma once", include__tlsph__core__a_hpp="struct A {};\n")

    def test_a_long_file_is_a_warning_only(self):
        violations, warnings = self.check(src__core__a_cpp="\n" * 301)
        self.assertEqual(violations, [])
        self.assertIn("301 lines", warnings[0])


if __name__ == "__main__":
    unittest.main()
