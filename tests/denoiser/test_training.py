# SPDX-FileCopyrightText: Penumbra authors
# SPDX-License-Identifier: BSD-3-Clause
"""Training of the denoiser's network: it learns, gives the same network again, also after an interruption, and PyTorch computes
what the reference does."""
import argparse
import contextlib
import io
import os
import pathlib
import tempfile
import unittest
from unittest import mock

import numpy as np

try:
    import torch
except ImportError:
    torch = None
else:
    import data
    import network
    import reference
    import train
    import weights
    from training_samples import batch_of, crop, sample_of, with_filtered

STEPS = 6


class Interruption(Exception):
    """Ends a training."""


def run(*arguments):
    """The command; returns what it prints."""
    printed = io.StringIO()
    with mock.patch("sys.argv", ["train-denoiser", *arguments]), contextlib.redirect_stdout(printed), \
            contextlib.redirect_stderr(io.StringIO()):
        train.main()
    return printed.getvalue()


@unittest.skipUnless(torch, "python3-torch is not installed")
class Training(unittest.TestCase):
    """A short training, in one folder."""

    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.printed = run("--short", "--folder", cls.folder.name)

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def samples(self):
        """What the short training learned from."""
        names = sorted(os.listdir(os.path.join(self.folder.name, data.FOLDER)))
        pairs = [(name.split("_")[0], int(name.split("_")[1].split(".")[0])) for name in names]
        with contextlib.redirect_stderr(io.StringIO()):
            return train.Samples(self.folder.name, pairs, lambda share: None)

    def training(self, folder):
        """A training of a few steps."""
        arguments = argparse.Namespace(seed=3, folder=folder, start=None, families=None, scenes=1, cameras=1, size=64, steps=STEPS)
        return train.Training(arguments)

    def network_of(self, training):
        """The text of the network's file."""
        path = os.path.join(training.args.folder, "network.txt")
        training.net.save(path, {"seed": 3})
        return pathlib.Path(path).read_text(encoding="ascii")

    def test_lowers_the_loss(self):
        # Each step sees only a few pictures, so its loss says little: compare the loss over all of them.
        batches = [batch_of([sample]) for sample, *_ in self.samples()]
        torch.manual_seed(0)
        untrained, trained = network.Denoiser(), network.Denoiser()
        trained.restore(os.path.join(self.folder.name, "network.txt"))
        with torch.no_grad():
            first, last = (np.mean([network.loss_of(net(batch), batch).item() for batch in batches]) for net in (untrained, trained))
        print(f"loss {first:.3f} -> {last:.3f}")
        self.assertLess(last, 0.9 * first)

    def test_writes_what_it_promises(self):
        self.assertIn("relMSE of the network", self.printed)
        for name in ("network.txt", "report.json", "loss.svg"):
            self.assertTrue(os.path.exists(os.path.join(self.folder.name, name)), name)
        _, layers = weights.read(os.path.join(self.folder.name, "network.txt"))
        learned = torch.load(os.path.join(self.folder.name, "checkpoint.pt"))["net"]["fine_out.weight"].flatten()
        written = torch.tensor(layers["fine_out"].values)  # rounded to 16 bits
        self.assertLess((written - learned).abs().max(), 1e-3 * learned.abs().max())

    def test_samples_are_prepared_once(self):
        self.samples()
        with mock.patch.object(data, "load", side_effect=AssertionError("prepared again")):
            found = self.samples()
        family, seed = "room", 0
        pictures = data.load(data.path_of(os.path.join(self.folder.name, data.FOLDER), family, seed))
        found = [part for part in found if part[1] == family]
        self.assertEqual(len(found), len(pictures))
        for (sample, _, frames), (signal, truth) in zip(found, pictures):
            expected = with_filtered(sample_of(signal, truth))
            self.assertEqual(frames, truth["count"])
            for name, values in sample.items():
                self.assertTrue(torch.equal(values, expected[name]), name)

    def test_same_seed_same_network(self):
        samples, found = self.samples(), []
        for _ in range(2):
            with tempfile.TemporaryDirectory() as folder, contextlib.redirect_stderr(io.StringIO()):
                training = self.training(folder)
                training.run(samples)
                found.append(self.network_of(training))
        self.assertEqual(*found)

    def test_goes_on_from_a_network(self):
        path = os.path.join(self.folder.name, "network.txt")
        with tempfile.TemporaryDirectory() as folder:
            arguments = argparse.Namespace(**{**vars(self.training(folder).args), "start": path})
            training = train.Training(arguments)
            training.net.save(os.path.join(folder, "again.txt"), weights.read(path)[0])
            self.assertEqual(pathlib.Path(folder, "again.txt").read_bytes(), pathlib.Path(path).read_bytes())
            before = training.net.net.last.bias.detach().clone()
            training.run(self.samples())
        self.assertGreater((training.net.net.last.bias - before).abs().max(), 1e-3)
        self.assertEqual(training.origin, weights.read(path)[0]["generator"])
        self.assertNotEqual(training.key, self.training(folder).key)

    def test_begins_anew_with_another_form_of_network(self):
        with tempfile.TemporaryDirectory() as folder:
            training, again = self.training(folder), self.training(folder)
            training.step = 3
            training.save()
            again.resume()
            self.assertEqual(again.step, 3)
            with mock.patch.object(network, "FINE", 4):
                other = self.training(folder)
            other.resume()
            self.assertEqual(other.step, 0)

    def test_goes_on_after_an_interruption(self):
        samples = self.samples()
        with tempfile.TemporaryDirectory() as folder, contextlib.redirect_stderr(io.StringIO()), \
                mock.patch.object(train, "SAVED", 2):
            whole = self.training(folder)
            whole.run(samples)
            os.remove(whole.path)
            broken, learn = self.training(folder), train.Training.learn

            def interrupted(training, given):
                if training.step == 3:
                    raise Interruption
                learn(training, given)
            with mock.patch.object(train.Training, "learn", interrupted), self.assertRaises(Interruption):
                broken.run(samples)
            resumed = self.training(folder)
            resumed.resume()
            self.assertEqual(resumed.step, 2)
            resumed.run(samples)
            self.assertEqual(self.network_of(resumed), self.network_of(whole))

    def test_a_broken_option_is_one_sentence(self):
        for arguments in (["--size", "100"], ["--steps", "0"], ["--families", "cubes"], ["--from", "missing.txt"]):
            with self.assertRaises(SystemExit) as ended:
                run(*arguments, "--folder", self.folder.name)
            self.assertNotEqual(ended.exception.code, 0)


@unittest.skipUnless(torch, "python3-torch is not installed")
class Agreement(unittest.TestCase):
    """PyTorch and the reference on surfaces that no scene has."""

    def signal(self, frames):
        """Noise on waves, with holes."""
        random = np.random.default_rng(1)
        y, x = np.mgrid[:64, :80] / 16
        depth = -3 + 0.2 * np.sin(x) * np.cos(y)
        count = np.where(random.random(depth.shape) < 0.1, 0, frames).astype(np.float32)
        normal = np.stack((0.5 + 0.05 * np.cos(x), 0.5 + 0.05 * np.sin(y)), -1)
        error = random.uniform(0.1, 0.9, depth.shape) if frames >= data.LEAST else np.zeros(depth.shape)
        values = [random.exponential(1, (*depth.shape, 3)) * (1 + x)[..., None], error, count, normal, depth, np.array((2.0, 2.5))]
        signal = data.Signal(*(value.astype(np.float32) for value in values))
        signal.light *= signal.frames[..., None] > 0
        signal.depth *= signal.frames > 0
        return signal

    def batch(self, signal):
        """The signal alone, as a batch."""
        surfaces = reference.Surfaces(signal)
        return batch_of([network.tensors(signal, surfaces.concavity, reference.slopes(signal, surfaces))])

    def truth(self, signal):
        """What a sample stores besides the signal; here its light is the target, too."""
        return {"target": signal.light, "target_error": signal.error, "measure": signal.light, "known": signal.frames > 0,
                "count": np.array(8), "direct": np.zeros_like(signal.light)}

    def test_torch_computes_what_the_reference_does(self):
        torch.manual_seed(1)
        net = network.Denoiser()
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "network.txt")
            net.save(path, {"seed": 1})
            net.restore(path)
            for frames in (1, 8, 200):
                signal = self.signal(frames)
                with torch.no_grad():
                    found = net(self.batch(signal))[0].permute(1, 2, 0).numpy()
                expected = reference.denoise(signal, path)
                difference = np.abs(found - expected).max() / expected.mean()
                print(f"{frames} frames: PyTorch and NumPy differ by {difference:.1e}")
                self.assertLess(difference, 1e-3)

    def test_parts_may_be_mirrored_and_turned(self):
        signal, random = self.signal(8), np.random.default_rng(2)
        sample = with_filtered(sample_of(signal, self.truth(signal)))
        sample["plain"] = network.plain_filter(batch_of([sample]))[0]
        self.assertGreater(sample["slope"].abs().mean(), 0.1)
        for _ in range(16):
            part = crop(sample, random)
            middle = (network.plain_filter(batch_of([part]))[0] - part["plain"])[:, 24:40, 24:40]
            self.assertLess(middle.abs().max(), 1e-4)

    def test_light_may_have_any_unit(self):
        torch.manual_seed(1)
        net = network.Denoiser()
        signal = self.signal(1)
        with torch.no_grad():
            plain = net(self.batch(signal)).numpy()
            for factor in (1e-3, 1e3):
                brighter = data.Signal(signal.light * factor, *(getattr(signal, name) for name in data.Signal.FIELDS[1:]))
                found = net(self.batch(brighter)).numpy() / factor
                self.assertLess(np.abs(found - plain).max(), 1e-3 * plain.mean())

    def test_outputs_that_a_file_lacks_start_at_their_first_values(self):
        torch.manual_seed(1)
        old, net = network.Denoiser(), network.Denoiser()
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "network.txt")
            old.save(path, {"seed": 1})
            facts, layers = weights.read(path)
            for name in ("out", "fine_out"):
                layer, count = layers[name], layers[name].weight_count()
                fewer = layer.outputs - network.LEVELS
                values = layer.values[:count // layer.outputs * fewer] + layer.values[count:count + fewer]
                layers[name] = weights.Layer(layer.inputs, fewer, layer.kernel, values)
            weights.write(path, facts, layers)
            self.assertEqual(net.restore(path), {"seed": "1"})
        batch = self.batch(self.signal(8))
        with torch.no_grad():
            *expected, _ = old.guides(batch)
            *found, others = net.guides(batch)
        for one, other in zip(expected, found):
            self.assertLess((one - other).abs().max(), 0.02)  # rounded to 16 bits
        self.assertLess((others - network.MOST_OTHERS * torch.sigmoid(torch.tensor(network.FIRST_BIASES[-1]))).abs().max(), 1e-6)

    def decided(self, trust, others):
        """A network without training that trusts the regression on places, and samples of other surfaces, fully or not at all."""
        torch.manual_seed(1)
        net = network.Denoiser()
        with torch.no_grad():
            net.net.last.bias[-2 * network.LEVELS:] = torch.tensor([50.0 if share else -50.0 for share in (trust, others)
                                                                    for _ in range(network.LEVELS)])
        return net

    def test_the_regression_on_places_is_a_mean(self):
        random = np.random.default_rng(3)
        for offsets, farthest in ((network.OFFSETS, 1), (network.WIDE_OFFSETS, 2)):
            samples = torch.from_numpy(random.exponential(1, (len(offsets), 1, 1000, 1)) ** 4)
            total, shares = samples.sum(0), []
            for chosen, own in enumerate(samples):
                fit = network.Regression()
                for number, (weight, place) in enumerate(zip(samples, offsets)):
                    fit.add(weight, [at / farthest for at in place], float(number == chosen))
                shares.append(own / total - fit.lean(total, own / total, torch.ones(1, 1, 1), farthest > 1))
            self.assertGreater(torch.stack(shares).min(), -1e-6)
            self.assertLess((sum(shares) - 1).abs().max(), 1e-6)
            self.assertGreater((shares[0] - samples[0] / total).abs().max(), 0.1)

    def test_even_slopes_of_light_stay_at_edges(self):
        signal = self.signal(1)
        signal.frames[:] = 1
        signal.depth[:] = -3
        signal.normal[:] = (0.5, 0.5)
        signal.light[:] = (1 + np.arange(signal.depth.shape[1]) / 8)[:, None]
        batch = self.batch(signal)
        with torch.no_grad():
            plain, fitted = ((self.decided(trust, False)(batch) - batch["light"])[0, :, :, 0].abs().mean().item()
                             for trust in (False, True))
        print(f"change of an even slope at the edge of a picture: {plain:.3f}, with the regression on places {fitted:.3f}")
        self.assertGreater(plain, 0.05)
        self.assertLess(fitted, 0.6 * plain)

    def test_samples_of_other_surfaces_count_as_the_network_says(self):
        signal = self.signal(1)
        signal.frames[:] = 1
        signal.depth[:] = -3
        signal.depth[:, ::2] = -4  # bars before a wall, each one pixel wide
        signal.normal[:] = (0.5, 0.5)
        signal.light[:] = np.random.default_rng(4).uniform(0.5, 1.5, signal.depth.shape)[..., None]
        signal.light[:, ::2] += 1
        batch = self.batch(signal)
        near = signal.depth > -3.5
        with torch.no_grad():
            apart, together = (self.decided(False, others)(batch)[0, 0].numpy() for others in (False, True))
        self.assertLess(abs(apart[near].mean() - 1), 0.02)
        self.assertGreater(together[near].mean(), 1.1)
        self.assertLess(abs(together.mean() - apart.mean()), 0.02)

    def test_errors_are_relative_to_the_light_that_is_seen(self):
        signal = self.signal(1)
        shown = []
        for direct in (0, 9):
            ones = np.ones_like(signal.light)
            truth = {**self.truth(signal), "target": ones, "measure": ones, "direct": direct * ones}
            batch = batch_of([with_filtered(sample_of(signal, truth))])
            picture = 1.5 * batch["target"]
            shown.append(network.relative_error(picture, batch).item())
            plain = network.plain_filter(batch)
            self.assertLess(network.loss_of(plain, batch).item(), 3)  # units of the error of this very picture
        self.assertAlmostEqual(shown[0], 0.25 / 1.01, 4)
        self.assertAlmostEqual(shown[1], shown[0] / 100, 6)

    def test_noise_of_targets_does_not_make_dark_pictures_seem_better(self):
        signal = self.signal(1)
        signal.frames[:] = 1
        random = np.random.default_rng(6)
        noisy = {name: random.gamma(4, 0.25, signal.light.shape).astype(np.float32) for name in ("target", "measure")}
        batch = batch_of([with_filtered(sample_of(signal, {**self.truth(signal), **noisy}))])
        dark, right, bright = (network.loss_of(torch.full_like(batch["light"], light), batch).item() for light in (0.8, 1, 1.2))
        print(f"loss of a picture that is a fifth too dark: {dark / right:.3f}, too bright: {bright / right:.3f}")
        self.assertGreater(dark, 1.02 * right)
        self.assertGreater(bright, 1.02 * right)

    def test_constant_light_stays(self):
        signal = self.signal(4)
        signal.light[:] = (signal.frames > 0)[..., None] * np.array((0.3, 0.5, 0.7), np.float32)
        for shares in (False, True):
            with torch.no_grad():
                found = self.decided(shares, shares)(self.batch(signal))[0].permute(1, 2, 0).numpy()
            self.assertLess(np.abs(found - signal.light)[signal.frames > 0].max(), 1e-6)


if __name__ == "__main__":
    unittest.main()
