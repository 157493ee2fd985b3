#!/usr/bin/env python3
"""What must hold of bench/scale/simulate.py whatever the numbers are."""

import math
import random
import sys
import unittest

sys.dont_write_bytecode = True  # into the sources

import simulate


def cases():
    chance = random.Random(7)
    for number in range(60):
        nodes, count = chance.randint(1, 12), chance.randint(1, 40)
        times = simulate.frame_times(("equal", "log-normal", "Pareto")[number % 3], chance.randint(1, 300),
                                     chance.uniform(0.1, 5), number)
        yield nodes, times, count, chance.uniform(0, 3), chance.uniform(0, 3)


class Laws(unittest.TestCase):
    def test_parts_are_all_frames_once(self):
        for _, times, count, _, _ in cases():
            parts = simulate.shards_of(times, count)
            self.assertEqual(sorted(sum(parts, [])), sorted(times))
            self.assertLessEqual(max(map(len, parts)) - min(map(len, parts)), 1)

    def test_every_frame_is_done_once_and_no_sooner_than_it_can_be(self):
        for nodes, times, count, start, load in cases():
            shards = simulate.shards_of(times, count)
            outcome = simulate.simulate(shards, nodes, start, load)
            work = sum(times) + count * (start + load)
            longest = max(sum(shard) for shard in shards) + start + load
            self.assertEqual(outcome.done, len(times))
            self.assertEqual(outcome.starts, count)
            self.assertAlmostEqual(sum(outcome.busy), work)
            least = max(work / nodes, longest)
            self.assertGreaterEqual(outcome.finished, least * (1 - 1e-12))  # sums of some hundred numbers
            # Graham, 1966: a list that is taken in any order takes at most so much.
            self.assertLessEqual(outcome.finished, (work / nodes + longest * (1 - 1 / nodes)) * (1 + 1e-12))

    def test_equal_frames_in_as_many_shards_as_nodes_take_what_is_worked_out_by_hand(self):
        outcome = simulate.simulate(simulate.shards_of([2.0] * 100, 10), 10, 1.0, 3.0)
        self.assertEqual(outcome.finished, 1 + 3 + 10 * 2)

    def test_a_lost_node_costs_what_is_worked_out_by_hand(self):
        # Two shards of three frames of 10 s. Node 1 is lost at 20 s, when one frame is done (at 1 + 3 + 10) and the second is
        # not; 305 s later node 0, free since 34 s, starts again and does two.
        outcome = simulate.simulate([[10.0] * 3, [10.0] * 3], 2, 1.0, 3.0, {1: 20.0}, 305)
        self.assertEqual(outcome.finished, 20 + 305 + 4 + 20)
        self.assertEqual((outcome.done, outcome.starts), (6, 3))

    def test_with_losses_every_frame_is_done_all_the_same(self):
        for nodes, times, count, start, load in cases():
            losses = simulate.random_losses(nodes, 0.5, sum(times) / nodes, count)
            losses.pop(0, None)  # one stays
            shards = simulate.shards_of(times, count)
            outcome = simulate.simulate(shards, nodes, start, load, losses, 10)
            self.assertEqual(outcome.done, len(times))
            self.assertGreaterEqual(outcome.starts, count)
            for node, second in losses.items():
                self.assertLessEqual(outcome.busy[node], second * (1 + 1e-12))
        with self.assertRaises(ValueError):
            simulate.simulate([[1.0]], 1, 0, 0, {0: 0.5})

    def test_times_have_their_mean_and_are_the_same_for_a_seed(self):
        for law, tolerance in (("equal", 0), ("log-normal", 6 * math.sqrt(math.e - 1))):
            times = simulate.frame_times(law, 100_000, 2.0, 3)
            # Six standard errors of the mean.
            self.assertLessEqual(abs(sum(times) / len(times) - 2), 2 * tolerance / math.sqrt(len(times)))
        # Pareto's has no variance; its median is known: (alpha - 1) / alpha * 2^(1 / alpha) times the mean.
        times = sorted(simulate.frame_times("Pareto", 100_001, 2.0, 3))
        expected = 2 * (0.5 / 1.5) * 2 ** (1 / 1.5)
        # The share below the true median is a half, within six standard errors of a coin's.
        below = sum(time < expected for time in times) / len(times)
        self.assertLessEqual(abs(below - 0.5), 6 * 0.5 / math.sqrt(len(times)))
        self.assertEqual(times, sorted(simulate.frame_times("Pareto", 100_001, 2.0, 3)))
        self.assertNotEqual(times, sorted(simulate.frame_times("Pareto", 100_001, 2.0, 4)))


unittest.main()
