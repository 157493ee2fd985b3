#!/usr/bin/env python3
"""simulate.py [--nodes N] [--frames N] [--seconds S] [--start S] [--load S] [--loss P] [--seed N]: what becomes of frames
on many nodes, by a model. Prints a Markdown table of numbers of shards and distributions of times.

A frame takes `seconds` in the mean: all the same; or log-normal of sigma 1; or by Pareto's law of exponent 1.5, whose
variance is infinite. A shard has a start (scheduler, process) and a load (the scene), then its frames; a node takes the
next shard of the queue when it is done with one, as a job array does. Each node is lost once with probability `loss`, at a
random moment within the time that the work ideally takes, for good; its shard is queued again after `requeue` seconds and goes
on behind the frames that it has done."""

import argparse
import heapq
import math
import random

REQUEUE_SECONDS = 300  # SlurmdTimeout's default, after which a node counts as lost


class Outcome:
    def __init__(self, nodes):
        self.done = 0  # frames
        self.finished = 0.0  # seconds, of the last
        self.busy = [0.0] * nodes  # with anything: starts and loads too
        self.starts = 0


def frame_times(law, frames, mean, seed):
    """Of that mean, all above 0; the same for the same seed."""
    chance = random.Random(seed)
    if law == "equal":
        return [mean] * frames
    if law == "log-normal":
        return [mean * math.exp(chance.gauss(-0.5, 1)) for _ in range(frames)]
    exponent = 1.5
    return [mean * (exponent - 1) / exponent * chance.paretovariate(exponent) for _ in range(frames)]


def shards_of(times, count):
    """Frames I, I + N, I + 2 N and so on, as `turntable --shard` has them."""
    return [times[part::count] for part in range(count)]


def simulate(shards, nodes, start, load, losses=None, requeue=REQUEUE_SECONDS):
    """`losses`: of a node, by its number, the second at which it is lost. Shards are lists of seconds."""
    losses = losses or {}
    outcome = Outcome(nodes)
    # Of each shard in the queue: from when on, its place in the order, its frames from the first that is not done.
    queue = [(0.0, i, 0) for i in range(len(shards))]
    heapq.heapify(queue)
    free = [(0.0, node) for node in range(nodes)]
    heapq.heapify(free)
    while queue:
        ready, shard, first = heapq.heappop(queue)
        if not free:
            raise ValueError("no node is left")
        now, node = heapq.heappop(free)
        begin = max(now, ready)  # whoever is free sooner waits for what is put back
        lost = losses.get(node, math.inf)
        if begin >= lost:
            heapq.heappush(queue, (ready, shard, first))
            continue  # the node is gone
        at = begin + start + load
        outcome.starts += 1
        frames = shards[shard]
        last = first
        while last < len(frames) and at + frames[last] <= lost:
            at += frames[last]
            last += 1
        outcome.done += last - first
        if last < len(frames) or at > lost:
            outcome.busy[node] += lost - begin
            heapq.heappush(queue, (lost + requeue, shard, last))
            continue  # and the node does not come back
        outcome.busy[node] += at - begin
        outcome.finished = max(outcome.finished, at)
        heapq.heappush(free, (at, node))
    return outcome


def random_losses(nodes, probability, within, seed):
    chance = random.Random(seed)
    return {node: chance.uniform(0, within) for node in range(nodes) if chance.random() < probability}


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("--nodes", type=int, default=1000)
    parser.add_argument("--frames", type=int, default=1_000_000)
    parser.add_argument("--seconds", type=float, default=2.0)
    parser.add_argument("--start", type=float, default=1.0)
    parser.add_argument("--load", type=float, default=3.0)
    parser.add_argument("--loss", type=float, default=0.01)
    parser.add_argument("--seed", type=int, default=1)
    a = parser.parse_args()
    ideal = a.frames * a.seconds / a.nodes
    print(f"{a.frames} frames of {a.seconds:g} s in the mean on {a.nodes} nodes, {a.start:g} s to start and {a.load:g} s to "
          f"load a shard, {100 * a.loss:g} % of the nodes lost; without any of that {ideal:.0f} s\n")
    print("| shards | frames a shard | equal, s | log-normal, s | Pareto, s | starts and loads | efficiency, log-normal |")
    print("|---|---|---|---|---|---|---|")
    losses = random_losses(a.nodes, a.loss, ideal, a.seed)
    times = {law: frame_times(law, a.frames, a.seconds, a.seed) for law in ("equal", "log-normal", "Pareto")}
    for a_node in (1, 2, 4, 8, 16, 32, 64, 128):
        count = a_node * a.nodes
        if count > a.frames:
            break
        outcomes = {law: simulate(shards_of(of_law, count), a.nodes, a.start, a.load, losses)
                    for law, of_law in times.items()}
        overhead = outcomes["equal"].starts * (a.start + a.load) / (a.frames * a.seconds)
        efficiency = sum(times["log-normal"]) / a.nodes / outcomes["log-normal"].finished
        print(f"| {count} | {a.frames / count:g} | " + " | ".join(f"{one.finished:.0f}" for one in outcomes.values()) +
              f" | {100 * overhead:.1f} % | {100 * efficiency:.0f} % |")


if __name__ == "__main__":
    main()
