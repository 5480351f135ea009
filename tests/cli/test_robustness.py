"""What the world does to the program: streams that take nothing, limits, signals, damaged and missing files."""

import os
import pathlib
import resource
import shutil
import signal
import subprocess
import time
import unittest

import h5py
import numpy as np

from support import BAR, PROGRAM, SHEET, SOURCE, ProgramTest, read_probes, read_summary

LOST = BAR.replace("amplitude = 1e3", "amplitude = -1e9")
# Its gradient is corrected by three factorisations, some seconds each.
SLOW_SET_UP = SHEET.replace("[body]", 'formulation = "consistent"\n[body]', 1).replace("spacing = 0.1", "spacing = 0.006")


class Streams(ProgramTest):
    def code(self, arguments, **streams):
        streams = {"stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL, **streams}
        return subprocess.run([PROGRAM, *arguments], cwd=self.folder, stdin=subprocess.DEVNULL, timeout=60,
                              check=False, **streams).returncode

    def test_errors_that_cannot_be_told_keep_their_exit_code(self):
        self.write("bad.toml", BAR.replace("spacing = 0.05", "spacing = 0"))
        self.write("lost.toml", LOST)
        with open("/dev/full", "w", encoding="utf-8") as full:
            for arguments, code in ((["run", "bad.toml"], 2), (["nonsense"], 2), (["run", "lost.toml"], 3)):
                with self.subTest(arguments):
                    self.assertEqual(self.code(arguments, stderr=full), code)
                    closed = subprocess.run(["sh", "-c", 'exec "$@" 2>&-', "sh", PROGRAM, *arguments],
                                            cwd=self.folder, timeout=60, check=False)
                    self.assertEqual(closed.returncode, code)

    def test_a_closed_stream_is_no_file_of_the_run(self):
        self.write("lost.toml", LOST)

        subprocess.run(["sh", "-c", 'exec "$@" 2>&- >&-', "sh", PROGRAM, "run", "lost.toml", "--out", "results"],
                       cwd=self.folder, timeout=60, check=False)

        with h5py.File(self.folder / "results/run.h5") as file:  # no message stands in it
            self.assertTrue(np.all(np.isfinite(file["frames/displacement"][:])))

    def test_a_full_standard_output_is_told_at_the_end(self):
        self.write("scene.toml", BAR)
        self.write("lost.toml", LOST)
        with open("/dev/full", "w", encoding="utf-8") as full:
            for arguments, code in ((["run", "scene.toml"], 4), (["plan", "scene.toml"], 4), (["--help"], 4),
                                    (["scene-reference"], 4), (["run", "lost.toml"], 3)):
                with self.subTest(arguments):
                    self.assertEqual(self.code(arguments, stdout=full), code)
        self.assertTrue((self.folder / "out/scene/summary.json").is_file())

    def test_a_reader_that_went_away_is_no_signal(self):
        self.write("scene.toml", BAR)
        reading, writing = os.pipe()
        os.close(reading)

        code = self.code(["run", "scene.toml"], stdout=writing)

        os.close(writing)
        self.assertEqual(code, 4)


class Limits(ProgramTest):
    def test_size_of_files(self):
        self.write("scene.toml", SHEET)

        done = self.tlsph("run", "scene.toml", "--out", "results",
                          preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (20000, 20000)))

        self.assertEqual(done.returncode, 4, done.stderr)
        self.assertRegex(done.stderr, r"^results/.*: cannot .*: File too large\n$")

    def test_memory(self):
        self.write("scene.toml", SHEET.replace("spacing = 0.1", "spacing = 0.001"))

        for command in (("run", "scene.toml", "--out", "results"), ("plan", "scene.toml")):
            done = self.tlsph(*command, "--threads" if command[0] == "run" else "--set",
                              "1" if command[0] == "run" else "output.frames=1",
                              preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_AS, (400 << 20, 400 << 20)))

            self.assertEqual(done.returncode, 2, done.stderr)
            self.assertRegex(done.stderr, r"^scene\.toml:4:11: body\.spacing: out of memory; choose a larger spacing\n$")
            self.assertEqual(self.listing(), ["scene.toml"])


    def test_memory_of_factorisations(self):
        self.write("scene.toml", SHEET.replace("spacing = 0.1", "spacing = 0.02\n[stabiliser]\nkind = \"pair\""))

        for limit in (130, 160, 190):
            done = self.tlsph("run", "scene.toml", "--set", "formulation=consistent", "--threads", "1",
                              "--out", "results", env={**os.environ, "OPENBLAS_NUM_THREADS": "1"},
                              preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_AS, (limit << 20, limit << 20)))

            self.assertEqual(done.returncode, 2, done.stderr)
            self.assertRegex(done.stderr, r"^scene\.toml:4:11: body\.spacing: out of memory; choose a larger spacing\n$")


class Depth(ProgramTest):
    """Keys and values nested deeper than any scene: told, in time and memory that do not grow with them."""

    def assert_refused(self, message, *arguments):
        def small():
            resource.setrlimit(resource.RLIMIT_AS, (1 << 30, 1 << 30))

        before = self.listing()
        done = self.tlsph("run", "scene.toml", "--out", "results", *arguments, preexec_fn=small)
        self.assertEqual(done.returncode, 2, done.stderr[:500])
        self.assertRegex(done.stderr, message)
        self.assertEqual(self.listing(), before)

    def test_in_the_file(self):
        for case, text, message in (
            ("dotted key", "\n" + ".".join(["a"] * 10000) + " = 1\n", r"^scene\.toml:2:34: a key of more than 16 parts"),
            ("quoted parts", ".".join(['"a.b"'] * 10000) + " = 1\n", r"^scene\.toml:1:\d+: a key of more than 16 parts"),
            ("table", "[" + " . ".join(["a"] * 10000) + "]\nb = 1\n", r"^scene\.toml:1:\d+: a key of more than 16 parts"),
            ("in a value", "a = { " + ".".join(["b"] * 10000) + " = 1 }\n", r"^scene\.toml:1:\d+: a key of more than 16"),
            ("list", "a = " + "[" * 100 + "]" * 100 + "\n", r"^scene\.toml:1:21: more than 16 levels"),
            ("tables", "a = " + "{ b.c.d = " * 90 + "1" + " }" * 90 + "\n", r"^scene\.toml:1:\d+: more than 16 levels"),
            ("long name", "a" * 1000000 + " = 1\n", r"^scene\.toml:1:1: a+: unknown key; allowed here: title"),
            ("beyond the parser", "a = " + "[" * 100000 + "]" * 100000 + "\n", r"^scene\.toml:1:\d+: not TOML"),
        ):
            with self.subTest(case):
                self.write("scene.toml", text)
                self.assert_refused(message)

    def test_dots_that_are_no_key(self):
        points = ", ".join(f"[{x}.0, 0.{x}]" for x in range(40))
        self.write("scene.toml", BAR.replace('title = "bar"', 'title = "' + "a." * 40 + '"  # ' + "b." * 40))
        self.assertEqual(self.tlsph("plan", "scene.toml").returncode, 0)
        self.write("scene.toml", f"title = '''\n{'a.' * 40}\n\\'''\na = [{points}]\n")
        self.assert_refused(r"^scene\.toml:4:1: a: unknown key")

    def test_in_an_override(self):
        self.write("scene.toml", BAR)
        self.assert_refused("names joined by dots", "--set", ".".join(["a"] * 20000) + "=1")
        self.assert_refused("names joined by dots", "--set", "a" + "[0]" * 20000 + "=1")
        self.assert_refused("a key of more than 16 parts", "--set", "a={" + ".".join(["b"] * 20000) + "=1}")
        self.assert_refused("unknown key", "--set", "a=" + "[" * 20000 + "]" * 20000)


class Places(ProgramTest):
    """Errors that only show when the body is built stand in the scene like all others."""

    def test_of_what_is_built(self):
        thesis = BAR.replace("dimension = 1", 'dimension = 1\nformulation = "thesis"')
        for case, text, place in (
            ("ghosts beyond the body", thesis + "[kernel]\nsupport = 15.5\n", r"30:11: kernel\.support: the ghosts reach"),
            ("the same by default", thesis.replace("spacing = 0.05", "spacing = 0.5"), r"1:1: kernel\.support: the ghosts"),
            ("a probe among too few points", BAR.replace("spacing = 0.05", "spacing = 1.0"),
             r"20:6: probe\[0\]\.at: no particles around"),
        ):
            with self.subTest(case):
                self.write("scene.toml", text)

                done = self.tlsph("run", "scene.toml", "--out", "results")

                self.assertEqual(done.returncode, 2, done.stderr)
                self.assertRegex(done.stderr, r"^scene\.toml:" + place)
                self.assertEqual(self.listing(), ["scene.toml"])

    def test_of_a_cloud_that_cannot_be_reached(self):
        self.write("file", "")
        os.symlink("round", self.folder / "round")
        for name in ("x" * 300, "x/" * 3000, "file/points.csv", "round", "no.csv"):
            with self.subTest(name):
                self.write("scene.toml", SHEET.replace("spacing = 0.1", f'cloud = "{name}"'))
                before = self.listing()

                done = self.tlsph("run", "scene.toml", "--out", "results")

                self.assertEqual(done.returncode, 2, done.stderr)
                self.assertRegex(done.stderr, r"^scene\.toml:4:9: body\.cloud: there is no file ")
                self.assertEqual(self.listing(), before)


def catches(process, number):
    """Whether the process has come to the handler of that signal."""
    status = pathlib.Path(f"/proc/{process.pid}/status").read_text(encoding="ascii")
    return int(status.split("SigCgt:")[1].split()[0], 16) >> (number - 1) & 1


class Signals(ProgramTest):
    def assert_ends(self, process, number, seconds):
        process.send_signal(number)
        begin = time.monotonic()
        self.assertEqual(process.wait(timeout=60), 128 + number)
        self.assertLess(time.monotonic() - begin, seconds)

    def test_in_a_set_up(self):
        self.write("slow.toml", SLOW_SET_UP)
        for command in (["run"], ["plan"], ["export"]):
            for number in (signal.SIGINT, signal.SIGTERM):
                with self.subTest(command=command, number=number):
                    process = self.start(*command, "slow.toml", *([] if command == ["plan"] else ["--out", "results"]))
                    self.wait_for(lambda: catches(process, number), process, "the set-up")
                    time.sleep(0.2)

                    self.assert_ends(process, number, 5.0)

                    self.assertEqual(self.listing(), ["slow.toml"])

    def test_in_the_set_up_of_a_study(self):
        self.write("slow.toml", SLOW_SET_UP.replace('formulation = "consistent"\n', ""))
        process = self.start("converge", "slow.toml", "--spacing", "0.006,0.005,0.004", "--formulation", "consistent",
                             "--out", "study")
        self.wait_for(lambda: catches(process, signal.SIGINT), process)
        time.sleep(0.5)

        process.send_signal(signal.SIGINT)
        time.sleep(0.2)
        self.assert_ends(process, signal.SIGINT, 5.0)  # the second one does not wait for the piece

    def test_export_leaves_no_half_file(self):
        self.write("scene.toml", SHEET.replace("spacing = 0.1", "spacing = 0.004"))
        process = self.start("export", "scene.toml", "--out", "matrices")
        self.wait_for(lambda: list(self.folder.glob("matrices/*.tmp")), process, "the export")

        self.assert_ends(process, signal.SIGTERM, 30.0)

        self.assertEqual(self.listing(), ["scene.toml"])

    def test_ignored_signals_stay_ignored(self):
        self.write("slow.toml", SLOW_SET_UP)
        process = subprocess.Popen(["nohup", "sh", "-c", "trap '' INT; exec \"$@\"", "sh", PROGRAM, "plan", "slow.toml"],
                                   cwd=self.folder, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                                   stderr=subprocess.DEVNULL)
        self.addCleanup(process.wait)
        self.addCleanup(process.kill)
        time.sleep(0.5)

        process.send_signal(signal.SIGINT)

        time.sleep(0.3)
        self.assertIsNone(process.poll())


class Fits(ProgramTest):
    def test_an_error_beyond_reach_comes_to_an_end(self):
        for error in ("1e-300", "1e-14"):
            with self.subTest(error):
                done = self.tlsph("fit", SOURCE / "examples/bar_wave.toml", "--error", error, "--quantity", "stress",
                                  "--out", "study", "--set", "time.end=2e-4")

                self.assertEqual(done.returncode, 1, done.stderr)
                self.assertIn("misses", done.stdout)

    def test_a_refusal_leaves_nothing(self):
        # No spacing shows a period: its answer does not settle.
        self.write("scene.toml", BAR.replace('[reference]\nexact = "bar-wave"\n', ""))
        for command in (["fit", "scene.toml", "--error", "0.01"], ["chart", "scene.toml", "--budget", "2s"]):
            for kept in (False, True):
                with self.subTest(command=command, kept=kept):
                    if kept:
                        (self.folder / "study").mkdir()
                        self.write("study/mine", "")
                    before = self.listing()

                    done = self.tlsph(*command, "--value", "tip.displacement_x.period", "--out", "study")

                    self.assertEqual(done.returncode, 2, done.stderr)
                    self.assertEqual(self.listing(), before)
            shutil.rmtree(self.folder / "study")


class Resumes(ProgramTest):
    """A resume looks at everything before it changes anything."""

    scene = BAR.replace("spacing = 0.05", "spacing = 0.02").replace("end = 2e-2", "end = 0.1").replace(
        "frames = 4", "frames = 4\nenergy_every = 1\ncheckpoint_steps = 20")

    def setUp(self):
        super().setUp()
        self.out = self.run_scene(self.scene, "--threads", "1")
        self.whole = {path.name: path.read_bytes() for path in self.out.iterdir()}

    def restore(self):
        for path in self.out.iterdir():
            path.unlink()
        for name, content in self.whole.items():
            (self.out / name).write_bytes(content)

    def resume(self, *arguments):
        return self.tlsph("run", "scene.toml", "--out", "results", "--resume", *(arguments or ("--threads", "1")))

    def test_other_threads_are_told(self):
        for threads, told in (("1", False), ("2", True)):
            with self.subTest(threads):
                self.restore()

                done = self.resume("--threads", threads)

                self.assertEqual((done.returncode, done.stderr), (0, ""))
                self.assertEqual("begun on 1 thread, resumed on 2: the same up to rounding, not bit for bit" in done.stdout,
                                 told)

    def assert_refused_untouched(self, message):
        before = {path.name: path.read_bytes() for path in self.out.iterdir()}
        done = self.resume()
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertRegex(done.stderr, message)
        self.assertEqual({path.name: path.read_bytes() for path in self.out.iterdir()}, before)

    def test_missing_files(self):
        for name in ("probes.csv", "probes_exact.csv", "run.h5", "checkpoint.h5"):
            with self.subTest(name):
                self.restore()
                (self.out / name).unlink()
                self.assert_refused_untouched(rf"^results/{name}: cannot ")

    def test_damaged_tables(self):
        for name in ("probes.csv", "probes_exact.csv"):
            with self.subTest(name):
                self.restore()
                text = (self.out / name).read_text(encoding="utf-8").split("\n")
                text[3] = text[3].translate(str.maketrans("0123456789", "1234567890"))
                (self.out / name).write_text("\n".join(text), encoding="utf-8")
                self.assert_refused_untouched(rf"^results/{name}: damaged")

    def test_damaged_frames(self):
        for item, row in (("frames/displacement", 1), ("frames/pk1", 1), ("frames/time", 1), ("series/kinetic", 2)):
            with self.subTest(item):
                self.restore()
                with h5py.File(self.out / "run.h5", "r+") as file:
                    values = file[item][row]
                    file[item][row] = values + 1e-12 * (1 + np.abs(values))
                self.assert_refused_untouched(r"^results/run\.h5: damaged: its first \d frames")

    def test_damaged_bytes(self):
        """Whatever a damaged byte does to the HDF5 library, the program says so, or the byte did not matter."""
        random = np.random.default_rng(5)
        size = len(self.whole["run.h5"])
        refused = 0
        for place in [*range(0, 64, 9), *random.integers(64, size, 32)]:
            with self.subTest(place=place):
                self.restore()
                damaged = bytearray(self.whole["run.h5"])
                damaged[place] ^= 1 << int(random.integers(8)) if place % 2 else 0xFF
                (self.out / "run.h5").write_bytes(damaged)

                done = self.resume()

                self.assertIn(done.returncode, (0, 2), (place, done.stderr))
                if done.returncode == 0:
                    self.assert_whole()
                else:
                    refused += 1
                    self.assertRegex(done.stderr, r"^results/run\.h5[:/]")
                    self.assertEqual((self.out / "run.h5").read_bytes(), bytes(damaged))
        self.assertGreater(refused, 3)

    def assert_whole(self):
        self.write("whole.h5", "").write_bytes(self.whole["run.h5"])
        with h5py.File(self.folder / "whole.h5") as one, h5py.File(self.out / "run.h5") as other:
            for name in ("particles/X", "frames/displacement", "frames/pk1", "frames/time", "series/kinetic"):
                np.testing.assert_array_equal(one[name][()], other[name][()])
        self.assertEqual((self.out / "probes.csv").read_bytes(), self.whole["probes.csv"])


if __name__ == "__main__":
    unittest.main()
