#!/usr/bin/env python3
"""A suite of 200 entries as a job array of a real Slurm with two nodes, one of which is lost in the middle of a task.

    run.py REFRASTER SOURCES

What is joined must be what one machine finds, byte for byte but for what is measured; no process may be left. Prints what
was done and how long it took, which docs/scale.md holds its model against. Exit 77, with a word, where there is no Slurm."""

import datetime
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import time

sys.dont_write_bytecode = True  # into the sources
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "support/script"))
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[3] / "bench/scale"))

import cluster
import simulate
from checks import check, faults

ENTRIES, PARTS = 200, 8
CHANGED = (17, 90)  # entries that differ from their reference
MEASURED = re.compile(r'"(seconds|finished|peak_bytes)": [^\n,]*')


def make_suite(folder, refraster, sources):
    scene = (sources / "scenes/hello.json").read_text()

    def save(i, glossiness):
        (folder / f"ball{i:03}.json").write_text(scene.replace('"glossiness": 90', f'"glossiness": {glossiness}', 1))

    for i in range(ENTRIES):
        save(i, 20 + i)
    (folder / "suite.json").write_text(
        '{"references": "refs", "defaults": {"size": [320, 180], "samples": 4}, "entries": [{"scene": "ball*.json"}]}')
    subprocess.run([refraster, "suite", "update", "suite.json", "-q"], cwd=folder, check=True)
    for i in CHANGED:
        save(i, 3)


def text_of_results(folder):
    """results.json without what is measured."""
    return MEASURED.sub(r'"\1": 0', (folder / "results.json").read_text())


def files_of(folder):
    return {str(path.relative_to(folder)): path.read_bytes()
            for part in ("images", "pages") for path in sorted((folder / part).rglob("*")) if path.is_file()}


def done_in(shard):
    """Entries in the journals of a part, and whether its results are written."""
    records = sum(text.count(b"refraster-journal result ") for text in
                  (path.read_bytes() for path in shard.glob("journal/*")))
    return records, (shard / "results.json").exists()


def slurm_times(log):
    """What Slurm took: the mean from the end of a task to the start of the next on its node, and from the last word of a
    lost node's task to its second start; seconds."""
    gaps, again, ended, nodes, put_back = [], None, {}, {}, None
    for stamp, text in re.findall(r"^\[(\S+)\] (.*)$", log, re.M):
        now = datetime.datetime.fromisoformat(stamp).timestamp()
        if allocated := re.search(r"Allocate (JobId=\S+) NodeList=(\S+)", text):
            job, node = allocated.groups()
            nodes[job] = node
            if job == put_back:
                again = now
            elif node in ended:
                gaps.append(now - ended[node])
        elif done := re.search(r"_job_complete: (JobId=\S+) done", text):
            ended[nodes[done.group(1)]] = now
        elif requeued := re.search(r"requeue job (JobId=\S+) due to failure", text):
            put_back = requeued.group(1)
    return sum(gaps) / len(gaps), again


def model(seconds_alone, wait, lost_at, again_after):
    """What the model of docs/scale.md says of the same."""
    times = [seconds_alone / ENTRIES] * ENTRIES
    return simulate.simulate(simulate.shards_of(times, PARTS), 2, wait, 0, {1: lost_at}, again_after).finished


def run(folder, refraster, sources):
    make_suite(folder, refraster, sources)
    start = time.monotonic()
    alone = subprocess.run([refraster, "suite", "run", "suite.json", "-o", "alone", "--jobs", "1", "-q"], cwd=folder)
    seconds_alone = time.monotonic() - start
    check(alone.returncode == 1, "two entries differ")

    (folder / "cluster").mkdir()
    with cluster.Cluster(folder / "cluster") as slurm:
        slurm.environment["REFRASTER"] = refraster
        start = time.monotonic()
        submitted = subprocess.run([sources / "scripts/slurm/submit", str(PARTS), "suite.json", "results"], cwd=folder,
                                   env=slurm.environment, stdout=subprocess.PIPE, text=True, check=True).stdout
        print(submitted.strip(), flush=True)
        merge = submitted.split()[-1]

        def task_on(node):
            """The number of the part that a node is at, with some entries done and some not."""
            for line in slurm.ask("squeue", "-h", "-w", node, "-t", "RUNNING", "-o", "%a %K").splitlines():
                number = line.split()[-1]
                if number.isdigit():
                    records, finished = done_in(folder / "results/shards" / number)
                    if records >= 3 and not finished:
                        return number
            return None

        lost = []
        slurm.wait_for(lambda: lost or lost.extend(filter(None, [task_on("n2")])) or lost, "a task on n2")
        ended = slurm.lose("n2")
        before = done_in(folder / "results/shards" / lost[0])[0]
        lost_at, lost_clock = time.monotonic() - start, time.time()
        print(f"lost n2 at {lost_at:.1f} s, with {ended} processes, in part {lost[0]} of {PARTS}, "
              f"{before} entries done", flush=True)
        check(ended > 0, "a task ran on the node that was lost")
        slurm.wait_for(lambda: not slurm.ask("squeue", "-h", "-j", merge, "-o", "%T").strip() and
                       (folder / "results/logs/merge.log").exists(), "the merge")
        seconds = time.monotonic() - start
        log = (folder / "cluster/slurmctld.log").read_text()
        wait, again = slurm_times(log)
        print(f"Slurm: {wait:.2f} s from task to task, {again - lost_clock:.1f} s from the loss to the task's second start")
        restarts = re.findall(r"Restarts=(\d+)", slurm.ask("scontrol", "show", "job", merge.strip()))
        check("0" in restarts or not restarts, "the merge ran once")
        log = (folder / "results/logs" / f"{lost[0]}.log").read_text()
        print(f"log of part {lost[0]}:\n" + "".join(f"  {line}\n" for line in log.splitlines()), end="", flush=True)
        print("log of the merge:\n" + "".join(f"  {line}\n" for line in
                                              (folder / "results/logs/merge.log").read_text().splitlines()), end="", flush=True)
        known = re.search(r"\((\d+) known from before", log)
        check(known is not None and int(known.group(1)) >= before, "what the lost node had done was not done again")

    check(not cluster.descendants(cluster.processes(), os.getpid()), "no process is left")
    joined = text_of_results(folder / "results")
    check(joined == text_of_results(folder / "alone"), "the joined results are those of one machine")
    files = files_of(folder / "results")
    check(files == files_of(folder / "alone") and len(files) >= 3 * len(CHANGED), "so are images and pages")
    states = [entry["state"] for entry in json.loads(joined)["entries"]]
    check(states.count("different") == len(CHANGED) and states.count("equal") == ENTRIES - len(CHANGED), "all are there")
    predicted = model(seconds_alone, wait, lost_at, again - lost_clock)
    print(f"{ENTRIES} entries: one process {seconds_alone:.1f} s; {PARTS} parts on two nodes, of which one was lost, "
          f"{seconds:.1f} s, the model {predicted:.1f} s", flush=True)


def main():
    refraster, sources = str(pathlib.Path(sys.argv[1]).resolve()), pathlib.Path(sys.argv[2]).resolve()
    why = cluster.missing()
    if why:
        print(f"SKIPPED: {why}")
        return 77
    with tempfile.TemporaryDirectory() as folder:
        run(pathlib.Path(folder), refraster, sources)
    return 1 if faults else 0


sys.exit(main())
