#!/usr/bin/env python3
"""Whether junit.xml is XML and says what results.json says: check_junit.py SCENE REFRASTER, the words that start it."""

import json
import pathlib
import shutil
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ElementTree

scene, program = pathlib.Path(sys.argv[1]).resolve(), sys.argv[2:]
ELEMENTS = {"different": "failure", "no reference": "failure", "bad input": "error", "equal": None}

with tempfile.TemporaryDirectory() as folder:
    folder = pathlib.Path(folder)

    def suite(*words):
        return subprocess.run([*program, "suite", *words], cwd=folder, stdout=subprocess.DEVNULL).returncode

    shutil.copy(scene, folder / "same.json")
    changed = folder / "changed.json"
    shutil.copy(scene, changed)
    size = ["--references", "refs", "--size", "64x36"]
    assert suite("update", "same.json", "changed.json", *size) == 0
    changed.write_text(scene.read_text().replace('"background": "0.', '"background": "0.9'))
    shutil.copy(scene, folder / "new.json")
    odd = folder / "odd <&\"' ü\u0001.json"
    odd.write_text("{")
    (folder / "raw\udcff.json").write_text("{\x02")
    assert suite("run", "*.json", *size) == 3
    results = json.loads((folder / "results/results.json").read_text())
    states = {entry["name"]: entry["state"] for entry in results["entries"]}
    root = ElementTree.parse(folder / "results/junit.xml").getroot()
    cases = root.findall("testsuite/testcase")
    assert len(cases) == len(states) == 5, (len(cases), states)
    for case in cases:
        children = [child.tag for child in case]
        expected = ELEMENTS[states[case.get("name")]]
        assert children == ([expected] if expected else []), (case.get("name"), children)
    numbers = {name: int(root.get(name)) for name in ("tests", "failures", "errors", "skipped")}
    count = lambda tag: sum(1 for state in states.values() if ELEMENTS[state] == tag)
    assert numbers == {"tests": 5, "failures": count("failure"), "errors": count("error"), "skipped": 0}, numbers
print("junit.xml is what it should be")
