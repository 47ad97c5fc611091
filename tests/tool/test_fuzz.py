# SPDX-FileCopyrightText: Penumbra authors
# SPDX-License-Identifier: BSD-3-Clause
"""Good files of every format, cut off and with bytes changed: drawn, or refused in one sentence.

PENUMBRA_FUZZ_RUNS sets how many runs there are, PENUMBRA_FUZZ_SEED where chance begins.
"""
import concurrent.futures
import os
import random
import shutil
import sys
import unittest

import command
import seeds

RUNS = int(os.environ.get("PENUMBRA_FUZZ_RUNS", "200"))
SEED = int(os.environ.get("PENUMBRA_FUZZ_SEED", "20"))
AT_ONCE = 2
HEAD = 600  # bytes in which formats describe themselves
DRAW = ("--size", "16x12", "--frames", "1", "--stock", "--quiet")


def truncated(data, chance):
    places = [1, 7, 64, len(data) // 10, len(data) // 3, len(data) * 9 // 10, len(data) - 1]
    return data[:chance.choice([place for place in places if 0 < place < len(data)] +
                               [chance.randrange(1, len(data))] * 3)]


def changed(data, chance):
    result = bytearray(data)
    reach = chance.choice([len(data), min(len(data), HEAD)])
    for _ in range(chance.choice([1, 4, 20])):
        place = chance.randrange(reach)
        result[place] = chance.choice(
            [0, 255, ord("9"), chance.randrange(256), result[place] ^ 1 << chance.randrange(8)])
    return bytes(result)


class Fuzz(command.CommandTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        (cls.folder / "good").mkdir()
        cls.files = seeds.make(cls.folder / "good")

    def draw(self, path, output):
        ended = self.penumbra("render", path, "-o", output, *DRAW)
        drawn = (self.folder / output).exists()
        (self.folder / output).unlink(missing_ok=True)
        return ended, drawn

    def in_parallel(self, jobs):
        with concurrent.futures.ThreadPoolExecutor(AT_ONCE) as workers:
            yield from workers.map(lambda job: (job[0], self.draw(*job[1:])), jobs)

    def test_good_files_are_drawn(self):
        jobs = [(path.name, path, f"{path.name}.png") for path in self.files]
        for name, (ended, drawn) in self.in_parallel(jobs):
            with self.subTest(name):
                self.assertEqual((ended.returncode, ended.stderr, drawn), (0, "", True))

    def damage(self):
        """One damaged file after the other, each in a folder of its own beside what it refers to."""
        chance = random.Random(SEED)
        for run in range(RUNS):
            good = self.files[run % len(self.files)]
            harm = (truncated, changed)[(run // len(self.files)) % 2]
            folder = self.folder / str(run)
            folder.mkdir()
            if (good.parent / good.stem).is_dir():
                os.symlink(good.parent / good.stem, folder / good.stem)
            bad = folder / good.name
            bad.write_bytes(harm(good.read_bytes(), chance))
            yield f"{harm.__name__} {good.name}, run {run}", bad, f"{run}.png"

    def test_damaged_files_end_in_a_picture_or_a_sentence(self):
        refused = 0
        for (name, bad, _), (_, (ended, drawn)) in self.paired(self.damage()):
            with self.subTest(name):
                if ended.returncode == 0:
                    self.assertEqual((ended.stderr, drawn), ("", True))
                else:
                    refused += 1
                    self.assert_sentence(ended, bad.name)
                    self.assertFalse(drawn, "a picture was left behind")
            shutil.rmtree(bad.parent)
        print(f"{RUNS} runs: {refused} refused, {RUNS - refused} drawn", file=sys.stderr)
        self.assertGreater(refused, RUNS / 4)

    def paired(self, jobs):
        jobs = list(jobs)
        return zip(jobs, self.in_parallel(jobs))


if __name__ == "__main__":
    unittest.main()
