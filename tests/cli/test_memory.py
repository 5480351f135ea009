"""The memory that `plan` tells is the most that a run has resident, to 15 %."""

import re
import unittest

from support import ProgramTest, read_summary

BODY = """\
[body]
shape = {{ box = [[0.0, 0.0], [1.0, 1.0]] }}
spacing = {}
[material]
young = 1e6
poisson = 0.3
density = 1000
[[boundary]]
where = "left"
symmetry = true
[[boundary]]
where = "bottom"
symmetry = true
[[boundary]]
where = "top"
symmetry = true
[time]
end = 1e-3
[output]
frames = 1
"""

# Settings and the spacing at which operators are most of the memory.
BODIES = {
    "stress-point": ((), 3e-3),
    "stress-point, linear law": (("material.law=linear-elastic",), 3e-3),
    "stress-point, jittered": (("body.jitter=0.2",), 4e-3),
    "stress-point, wider, with pairs": (("kernel.support=1.8", "stabiliser.kind=pair"), 1e-2),
    "variational": (("formulation=variational",), 1e-2),
    "variational, wider": (("formulation=variational", "kernel.support=3.5"), 1e-2),
    "variational, damped": (("formulation=variational", "stabiliser.as=viscosity"), 1.25e-2),
    "variational, no stabiliser": (("formulation=variational", "stabiliser.kind=none"), 6e-3),
    "consistent": (("formulation=consistent", "body.jitter=0.2"), 0.04),
    "mirror": (("formulation=mirror",), 1.25e-2),
    "thesis": (("formulation=thesis",), 1.4e-2),
    "hexagonal": (("body.layout=hexagonal",), 1e-2),
}


class Memory(ProgramTest):
    def test_a_run_takes_what_the_plan_says(self):
        for name, (settings, spacing) in BODIES.items():
            with self.subTest(name):
                arguments = [word for setting in settings for word in ("--set", setting)]
                out = self.run_scene(BODY.format(spacing), "--threads", "1", *arguments)
                plan = self.tlsph("plan", "scene.toml", *arguments)

                told = 1e6 * float(re.search(r"memory about ([0-9.e+]+) MB", plan.stdout)[1])
                peak = read_summary(out)["peak_memory_bytes"]
                self.assertLessEqual(abs(peak / told - 1.0), 0.15, f"{peak:.3g} of {told:.3g} bytes")


if __name__ == "__main__":
    unittest.main()
