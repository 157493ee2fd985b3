#!/usr/bin/env python3
"""scripts/gpu_check with a stand-in for the program: what it makes of steps that fail.

    test_gpu_check.py SOURCE_DIR"""

import pathlib
import subprocess
import sys
import tempfile
import unittest

SOURCE = pathlib.Path(sys.argv.pop(1)).resolve()
SCENES = sorted(scene.stem for scene in (SOURCE / "scenes/gallery").glob("*.json"))
WRONG = sorted(scene.stem for scene in (SOURCE / "tests/system/gl/wrong_shaders").glob("*.json"))


def lines(run, name):
    """What the run printed of a step."""
    return [line.split(maxsplit=1)[1] for line in run.stdout.splitlines() if line.split(maxsplit=1)[0] == name]


class GpuCheck(unittest.TestCase):
    def check(self, codes):
        """Runs the script with a program that ends with codes[WORD] where WORD is in its command line, else as it
        should: with 1 for a wrong shader and 0 for all others. Its command lines are in self.asked."""
        with tempfile.TemporaryDirectory() as folder:
            build = pathlib.Path(folder) / "build"
            build.mkdir()
            program = build / "refraster"
            cases = "".join(f'  *{word}*) echo "note: before"; echo "refraster: {word} says $1"; exit {code} ;;\n'
                            for word, code in codes.items())
            program.write_text('#!/bin/sh\necho "$*" >>"$(dirname "$0")/asked"\ncase "$*" in\n' + cases +
                               '  *wrong_shaders*) exit 1 ;;\nesac\n')
            program.chmod(0o755)
            run = subprocess.run([SOURCE / "scripts/gpu_check", "-b", build, "-r", "llvmpipe",
                                  pathlib.Path(folder) / "reports"], text=True, capture_output=True)
            self.asked = (build / "asked").read_text().splitlines()
            summary = pathlib.Path(folder) / "reports/summary.txt"
            self.assertEqual(summary.read_text(), run.stdout)
            return run

    def verified(self):
        return [pathlib.Path(line.split()[1]).stem for line in self.asked if line.startswith("verify ")]

    def test_all_is_well_where_every_scene_is_explained_and_every_fault_found(self):
        run = self.check({})
        self.assertEqual(run.returncode, 0, run.stdout)
        self.assertEqual(self.verified(), SCENES + WRONG)
        self.assertEqual(len(WRONG), 6)
        for line in self.asked:
            self.assertIn("--renderer llvmpipe", line)
            if line.startswith("verify "):
                self.assertRegex(line, r" --gl .*--device \S*/profile\.json .*--json \S+\.json --html \S+\.html$")

    def test_what_fails_is_said_and_the_rest_goes_on(self):
        run = self.check({"--probe": 3, "gallery/phong.": 1, "gallery/brass.": 70, "wrong_shaders/phi_d.": 0})
        self.assertEqual(run.returncode, 1)
        self.assertEqual(self.verified(), SCENES + WRONG)
        self.assertEqual(lines(run, "probe"), ["FAILED with exit code 3: refraster: --probe says gl"])
        self.assertEqual(lines(run, "verification"), ["goes on with the profile gl-generic"])
        self.assertIn("--device gl-generic", self.asked[-1])
        self.assertRegex(lines(run, "phong")[0], r"^UNEXPLAINED, \d+ s: phong\.html$")
        self.assertEqual(lines(run, "brass"), ["FAILED with exit code 70: refraster: gallery/brass. says verify"])
        self.assertRegex(lines(run, "wrong_phi_d")[0], "^FAULT NOT FOUND")
        self.assertRegex(lines(run, "wrong_normals")[0], "^fault found")
        self.assertRegex(lines(run, "grazing")[0], "^explained")
        self.assertRegex(lines(run, "result")[0], "^NOT as it should be")

    def test_without_opengl_nothing_is_verified(self):
        run = self.check({"hello.json": 5})
        self.assertEqual(run.returncode, 5)
        self.assertEqual(self.verified(), [])
        self.assertEqual(lines(run, "driver"), ["FAILED with exit code 5: refraster: hello.json says gl"])

    def test_a_folder_in_which_nothing_is_built_is_wrong_usage(self):
        with tempfile.TemporaryDirectory() as folder:
            run = subprocess.run([SOURCE / "scripts/gpu_check", "-b", folder, folder], text=True, capture_output=True)
        self.assertEqual(run.returncode, 2)
        self.assertEqual(run.stderr, f"scripts/gpu_check: no refraster in {folder}\n")


unittest.main(verbosity=0)
