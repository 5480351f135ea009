"""Signals, kill -9 and --resume: a run in pieces is the run in one, bit for bit."""

import signal
import unittest

import h5py
import numpy as np

from support import SHEET, ProgramTest, read_probes, read_summary

# Some seconds of stepping, a checkpoint every few hundred steps.
LONG = SHEET.replace("spacing = 0.1", "spacing = 0.02").replace("end = 2e-2", "end = 1.0").replace(
    "frames = 4", "frames = 40\nprobe_every = 10\ncheckpoint_steps = 200"
)


class Pieces(ProgramTest):
    def start_long_run(self):
        self.write("long.toml", LONG)
        return self.start("run", "long.toml", "--out", "pieces", "--threads", "1", "--quiet")

    def has_rows(self, count):
        path = self.folder / "pieces/probes.csv"
        return path.is_file() and path.read_bytes().count(b"\n") > count

    def has_checkpoint(self):
        return (self.folder / "pieces/checkpoint.h5").is_file()

    def resume(self):
        done = self.tlsph("run", "long.toml", "--out", "pieces", "--threads", "1", "--quiet", "--resume")
        self.assertEqual((done.returncode, done.stderr), (0, ""))

    def assert_same_as_in_one(self):
        whole = self.run_scene(LONG, "--threads", "1", name="long.toml", out="whole")
        pieces = self.folder / "pieces"
        with h5py.File(whole / "run.h5") as one, h5py.File(pieces / "run.h5") as other:
            names = []
            one.visititems(lambda name, item: names.append(name) if isinstance(item, h5py.Dataset) else None)
            self.assertGreater(len(names), 8)
            for name in names:
                with self.subTest(name):
                    np.testing.assert_array_equal(one[name][()], other[name][()])
        self.assertEqual(read_probes(whole / "probes.csv"), read_probes(pieces / "probes.csv"))
        one, other = read_summary(whole), read_summary(pieces)
        for key in ("steps", "end_time", "dt", "energy", "momentum", "failure"):
            self.assertEqual(one[key], other[key], key)

    def test_kill_9(self):
        process = self.start_long_run()
        self.wait_for(lambda: self.has_checkpoint() and self.has_rows(100), process, "the run")

        process.kill()
        process.wait()

        with h5py.File(self.folder / "pieces/run.h5") as file:
            frames = file["frames/time"].shape[0]
            self.assertGreaterEqual(frames, 1)
            self.assertTrue(np.all(np.isfinite(file["frames/displacement"][: frames])))
        self.resume()
        self.assert_same_as_in_one()

    def assert_stops_and_goes_on(self, number, code):
        process = self.start_long_run()
        self.wait_for(lambda: self.has_rows(20), process, "the run")

        process.send_signal(number)

        self.assertEqual(process.wait(timeout=60), code)
        self.assertTrue(self.has_checkpoint())
        self.resume()
        self.assert_same_as_in_one()

    def test_interrupt(self):
        self.assert_stops_and_goes_on(signal.SIGINT, 130)

    def test_terminate(self):
        self.assert_stops_and_goes_on(signal.SIGTERM, 143)

    def test_resume_without_a_checkpoint_is_bad_input(self):
        self.write("long.toml", LONG)

        done = self.tlsph("run", "long.toml", "--out", "pieces", "--resume")

        self.assertEqual(done.returncode, 2)
        self.assertIn("checkpoint", done.stderr)
        self.assertEqual(self.listing(), ["long.toml"])

    def test_resume_of_another_scene_is_bad_input(self):
        process = self.start_long_run()
        self.wait_for(self.has_checkpoint, process, "the run")
        process.kill()
        process.wait()

        done = self.tlsph("run", "long.toml", "--out", "pieces", "--resume", "--set", "body.spacing=0.05")

        self.assertEqual(done.returncode, 2, done.stderr)

    def test_resume_stands_on_the_points_it_began_with(self):
        square = [f"{x / 4},{y / 4},{'end' if x == 4 else ''}" for x in range(5) for y in range(5)]
        points = "x,y,tag\n" + "\n".join(square) + "\n"
        self.write("points.csv", points)
        self.run_scene(SHEET.replace("spacing = 0.1", 'cloud = "points.csv"'), name="cloud.toml", out="pieces")
        again = ("run", "cloud.toml", "--out", "pieces", "--quiet", "--resume")
        for change, changed in {
            "moved": points.replace("0.5,0.5,", "0.5,0.51,"),
            "one more": points + "0.6,0.6,\n",
            "tag": points.replace("1.0,0.25,end", "1.0,0.25,"),
        }.items():
            with self.subTest(change):
                self.assertNotEqual(changed, points)
                self.write("points.csv", changed)
                before = {path: path.read_bytes() for path in (self.folder / "pieces").iterdir()}

                done = self.tlsph(*again)

                self.assertEqual(done.returncode, 2, done.stderr)
                self.assertRegex(done.stderr, r"^cloud\.toml:4:9: body\.cloud: the points of points\.csv are no longer")
                self.assertIn("run anew without --resume", done.stderr)
                self.assertEqual({path: path.read_bytes() for path in (self.folder / "pieces").iterdir()}, before)

        self.write("points.csv", "# the same points\n" + points)
        done = self.tlsph(*again)

        self.assertEqual((done.returncode, done.stderr), (0, ""))


if __name__ == "__main__":
    unittest.main()
