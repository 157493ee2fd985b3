#!/usr/bin/env python3
"""The recipes of docs/scale.md, run as they stand there: GNU parallel's, and the jobs of the workflow file, a matrix of
shards and the job behind it, by a stand-in for the runner.

    recipes.py REFRASTER SOURCES

Exit 77, with a word, without GNU parallel, whose recipe is then all that is left out."""

import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True  # into the sources
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "support/script"))

from checks import check, faults


def blocks(page, language):
    return re.findall(rf"```{language}\n(.*?)```", page, re.S)


def make_suite(folder, refraster, sources):
    scene = (sources / "scenes/hello.json").read_text()
    for i in range(9):
        (folder / f"ball{i}.json").write_text(scene.replace('"glossiness": 90', f'"glossiness": {20 + i}', 1))
    (folder / "suite.json").write_text(
        '{"references": "refs", "defaults": {"size": [64, 36]}, "entries": [{"scene": "ball*.json"}]}')
    subprocess.run([refraster, "suite", "update", "suite.json", "-q"], cwd=folder, check=True)
    (folder / "ball4.json").write_text(scene.replace('"glossiness": 90', '"glossiness": 3', 1))


def shell(commands, folder, environment):
    return subprocess.run(["bash", "-c", commands], cwd=folder, env=environment, text=True, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT)


def check_results(folder, where, run):
    check(run.returncode == 1, f"{where}: the exit code is that of a difference, not {run.returncode}: {run.stdout}")
    check("1 different, 8 equal" in run.stdout, f"{where}: all entries are joined: {run.stdout}")
    check((folder / "results/pages/ball4.html").exists(), f"{where}: pages are")
    shutil.rmtree(folder / "results", ignore_errors=True)


def job(text, name):
    """The lines of a job of a workflow file: indented by two, its name first."""
    return re.search(rf"^  {name}:\n((?:    .*\n|\n)+)", text, re.M).group(1)


def run_workflow(text, folder, environment):
    """What a runner does: each job of the matrix on a machine of its own, whose folder goes to the store; then the last."""
    store = folder / "store"
    suite, merge = job(text, "suite"), job(text, "merge")
    shards = [int(number) for number in re.search(r"shard: \[(.*?)\]", suite).group(1).split(",")]
    commands = re.findall(r"- run: (refraster .*)", suite)
    check(len(commands) == 1 and "needs: suite" in merge, "the workflow has its two jobs")
    for shard in shards:
        machine = folder / f"machine{shard}"
        shutil.copytree(folder, machine, ignore=shutil.ignore_patterns("machine*", "store"))
        done = shell(commands[0].replace("${{ matrix.shard }}", str(shard)), machine, environment)
        check(done.returncode in (0, 1), f"shard {shard}: {done.stdout}")
        name = re.search(r"with: \{name: (.+), path: (.+)\}", suite)
        artefact = name.group(1).replace("${{ matrix.shard }}", str(shard))
        shutil.copytree(machine / name.group(2), store / artefact)
    shutil.copytree(store, folder / "parts")
    return shell(re.search(r"- run: (refraster .*)", merge).group(1), folder, environment)


def main():
    refraster, sources = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
    page = (sources / "docs/scale.md").read_text()
    environment = {**os.environ, "PATH": f"{refraster.parent}:{os.environ['PATH']}", "GITHUB_STEP_SUMMARY": "summary.md"}
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        make_suite(folder, refraster, sources)
        workflow = [text for text in blocks(page, "yaml") if "matrix" in text]
        check(len(workflow) == 1, "the page has one workflow file")
        check_results(folder, "workflow", run_workflow(workflow[0], folder, environment))
        recipes = [text for text in blocks(page, "sh") if "parallel" in text]
        check(len(recipes) == 1, "the page has one recipe for GNU parallel")
        if shutil.which("parallel"):
            check_results(folder, "parallel", shell(recipes[0], folder, environment))
            print("GNU parallel's recipe and the workflow's were run")
    if faults:
        return 1
    if not shutil.which("parallel"):
        print("SKIPPED: GNU parallel is not installed (scripts/setup parallel); the workflow's recipe was run")
        return 77
    return 0


sys.exit(main())
