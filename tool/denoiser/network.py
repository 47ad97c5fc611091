# SPDX-FileCopyrightText: Penumbra authors
# SPDX-License-Identifier: BSD-3-Clause
"""The denoiser's network and the filter that it guides, in PyTorch, as the shaders of glsl/denoising compute them.

A U-Net (Ronneberger, Fischer and Brox 2015, U-Net: Convolutional Networks for Biomedical Image Segmentation) at half resolution
gives features, bandwidths and sharpnesses to each pixel. Four levels of a filter average samples of the same surface whose
features are alike (Isik, Mullia, Fisher, Eisenmann and Gharbi 2021, Interactive Monte Carlo Denoising using Affinity of Neural
Features). The result is a mean of measured samples. Tensors of a batch are (n, channels, h, w), h and w multiples of TILE.
"""
import numpy as np
import torch
import weights
from torch import nn
from torch.nn import functional

TILE = 16                 # pixels, of the mean luminance that light is divided by
WIDTHS = (8, 16, 24, 32)  # channels of the U-Net's levels
INPUTS, FEATURES, LEVELS = 16, 4, 4
FINE = 8                  # hidden channels of the layers that see single pixels
RADIUS = 8                # reach of the filter in pixels
LAST = 256                # frames from which nothing is filtered
BEND, BEND_HALVED, MOST_BEND = 10, 4, 2.25  # of normals, see glsl/lib/alike.glsl, glsl/denoising/signal.glsl and filter.frag
TOLERANCE, LIGHT_HALVED = 3.25, 32  # of the filter without a network
MOST_LIGHT = 3            # times the mean, that the network sees
FEATURE_FRAMES = 4        # see glsl/denoising/filter.frag, also for what follows
SHARPNESS_PER_FRAME, FEWEST_FRAMES, SHARP_FRAMES, LEAST_SHARE = 0.05, 8, 12, 0.4
MOST_OTHERS = 0.5         # share of samples of other surfaces, see glsl/denoising/guides.frag
LEAST_SHARPNESS = 0.15    # half of 1 / TOLERANCE: so that what stands out of the noise is not blurred away
DEPTH_CHANGE = 16
KERNELS = {1: (0.5, 0.25), 2: (0.375, 0.25, 0.0625)}  # splines: levels of equal weights would leave patterns of dots
FARTHEST = (2, 1, 1, 1)   # samples along an axis, by level
RIDGE = 0.1               # of the regression on places, in squared distances of samples, see glsl/denoising/filter.frag
MOST_SQUARE = 400         # relative squared difference of a pixel from which it counts less in the loss
FIRST_BIASES = (-2.0, -1.2, -1.0, -3.0)  # of the outputs by level; see Denoiser.guides()
OFFSETS = [(x, y) for y in (-1, 0, 1) for x in (-1, 0, 1)]
WIDE_OFFSETS = [(x, y) for y in range(-2, 3) for x in range(-2, 3) if abs(x) + abs(y) <= 2]
LUMINANCE = torch.tensor((0.2126, 0.7152, 0.0722))[:, None, None]


def luminance(color):
    """Luminance of light, with one channel."""
    return (color * LUMINANCE).sum(1, keepdim=True)


def moved(values, x, y):
    """The values x pixels to the right and y up; 0 from outside."""
    height, width = values.shape[-2:]
    padded = functional.pad(values, (max(-x, 0), max(x, 0), max(-y, 0), max(y, 0)))
    return padded[..., max(y, 0):max(y, 0) + height, max(x, 0):max(x, 0) + width]


def decode(normal):
    """Unit vectors of octahedral normals."""
    xy = 2 * normal - 1
    z = 1 - xy.abs().sum(1, keepdim=True)
    fold = (-z).clamp(min=0)
    xy = xy - torch.where(xy >= 0, fold, -fold)
    return functional.normalize(torch.cat((xy, z), 1), dim=1)


def tensors(signal, concavity, slopes, fits=True):
    """A signal as tensors (channels, h, w). ray: view x and y of a pixel at depth -1; angle: width of a pixel there; concavity and
    slope: see reference.Surfaces and reference.slopes(); fits: 1 if the filter without a network uses the slopes."""
    height, width = signal.frames.shape
    x = (torch.arange(width) + 0.5) / width * 2 - 1
    y = (torch.arange(height) + 0.5) / height * 2 - 1
    scale = torch.from_numpy(np.asarray(signal.projection, np.float32))
    values = {"light": signal.light.transpose(2, 0, 1), "normal": signal.normal.transpose(2, 0, 1), "concavity": concavity[None],
              "slope": slopes.reshape(height, width, 12).transpose(2, 0, 1)}
    values.update({name: getattr(signal, name)[None] for name in ("error", "frames", "depth")})
    made = {name: torch.from_numpy(np.ascontiguousarray(value, np.float32)) for name, value in values.items()}
    made["ray"] = torch.stack((x[None, :].expand(height, width) / scale[0], y[:, None].expand(height, width) / scale[1]))
    made["angle"] = (2 / (width * scale[0])).reshape(1, 1, 1)
    return {**made, "fits": torch.full((1, 1, 1), float(fits))}


def surfaces(batch):
    """Add to a batch what follows from the surfaces. pixel: its width there; toward: cosine of the direction to the eye."""
    depth, frames = batch["depth"], batch["frames"]
    position = torch.cat((-depth * batch["ray"], depth), 1)
    direction = decode(batch["normal"])
    toward = -(direction * position).sum(1, keepdim=True) / position.norm(dim=1, keepdim=True).clamp(min=1e-12)
    return {**batch, "exists": (frames > 0).float(), "direction": direction, "position": position, "toward": toward,
            "shape": torch.cat((direction, batch["concavity"]), 1), "pixel": depth.abs() * batch["angle"]}


def similarities(batch, step, bend=BEND, offsets=tuple(OFFSETS)):
    """Whether pixels around each, `step` apart, show the same surface: glsl/lib/alike.glsl. bend: how much the squared difference
    of normals counts."""
    facing = batch["toward"].abs().clamp(0.2, 1)
    depth = torch.where(batch["exists"] > 0, batch["depth"], torch.full_like(facing, -1))
    found = []
    for x, y in offsets:
        x, y = x * step, y * step
        apart = moved(batch["position"], x, y) - batch["position"]
        other = moved(depth, x, y)
        closer = depth / torch.where(other < 0, other, torch.full_like(other, -1))  # as window depths are compared
        distance = (batch["direction"] * apart).sum(1, keepdim=True).abs() * facing * closer
        distance = distance / (step * batch["pixel"]).clamp(min=1e-12)
        turned = ((moved(batch["normal"], x, y) - batch["normal"]) ** 2).sum(1, keepdim=True)
        alike = (2 - distance).clamp(0, 1) * (1 - bend * turned).clamp(0, 1)
        found.append(alike * moved(batch["exists"], x, y) * batch["exists"])
    return found


def tile_shares(count):
    """Shares of the tiles in the scale of each block of 2x2 pixels along an axis of so many pixels."""
    blocks, tiles = count // 2, count // TILE
    shares = torch.zeros(blocks, tiles)
    for block in range(blocks):
        place = (2 * block + 1) / TILE - 0.5
        corner, fraction = int(np.floor(place)), place - np.floor(place)
        for tile, share in zip(range(corner - 1, corner + 3), (1 - fraction, 1, 1, fraction)):
            if 0 <= tile < tiles:
                shares[block, tile] += share
    return shares


def scales(batch):
    """Mean luminance around each pixel, the same in a block of 2x2."""
    exists = batch["exists"]
    sums = [functional.avg_pool2d(value, TILE) for value in (luminance(batch["light"]) * exists, exists)]
    up, across = (tile_shares(size) for size in exists.shape[-2:])
    light, count = (up @ value @ across.T for value in sums)
    scale = (light / count.clamp(min=1e-6 / TILE ** 2)).clamp(min=1e-20)
    return functional.interpolate(scale, scale_factor=2, mode="nearest")


def inputs(batch):
    """What the network gets: for each pixel, and their means over the surfaces of blocks of 2x2 pixels."""
    exists, light, frames = batch["exists"], batch["light"], batch["frames"]
    scale = scales(batch)
    near, weights_near, bright = 0, 0, luminance(light)
    brightest = torch.full_like(bright, -1)
    for (x, y), alike in zip(OFFSETS, similarities(batch, 1)):
        weight = alike * moved(frames, x, y)
        near, weights_near = near + weight * moved(light, x, y), weights_near + weight
        if x or y:
            brightest = torch.where(weight > 0, torch.maximum(brightest, moved(bright, x, y)), brightest)
    share = torch.where(brightest < 0, torch.ones_like(bright), (brightest / bright.clamp(min=1e-20)).clamp(max=1))
    edge = sum((1 - (batch["direction"] * moved(batch["direction"], x, y)).sum(1, keepdim=True).clamp(0, 1)) *
               moved(exists, x, y) for x, y in ((1, 0), (-1, 0), (0, 1), (0, -1)))
    depth = torch.where(exists > 0, batch["depth"], torch.full_like(exists, -1))
    changes = [DEPTH_CHANGE * (moved(batch["depth"], x, y) / depth - 1).clamp(-1, 1) * moved(exists, x, y)
               for x, y in ((1, 0), (0, 1))]
    lights = share * light, near / weights_near.clamp(min=1e-6), share * batch["error"] * bright
    values = [*(torch.log1p((value / scale).clamp(max=MOST_LIGHT)) for value in lights), frames / (frames + 8),
              batch["direction"], batch["toward"], edge, exists, *changes]
    single = torch.cat(values, 1) * exists
    blocks = functional.avg_pool2d(single, 2) / functional.avg_pool2d(exists, 2).clamp(min=0.25)
    return single, blocks


class UNet(nn.Module):
    """Convolutions on the way down and up again."""

    def __init__(self, outputs):
        super().__init__()
        ends = (INPUTS, *WIDTHS)
        self.down = nn.ModuleList(nn.Conv2d(a, b, 3, padding=1) for a, b in zip(ends, WIDTHS))
        pairs = [(WIDTHS[i + 1] + WIDTHS[i], WIDTHS[i]) for i in reversed(range(len(WIDTHS) - 1))]
        self.up = nn.ModuleList(nn.Conv2d(a, b, 3, padding=1) for a, b in pairs)
        self.last = nn.Conv2d(WIDTHS[0], outputs, 3, padding=1)

    def forward(self, values):
        """The outputs of each texel."""
        kept = []
        for number, layer in enumerate(self.down):
            values = functional.relu(layer(functional.max_pool2d(values, 2) if number else values))
            kept.append(values)
        for number, layer in enumerate(self.up):
            larger = functional.interpolate(values, scale_factor=2, mode="nearest")
            values = functional.relu(layer(torch.cat((larger, kept[-2 - number]), 1)))
        return self.last(values)


def variance(known, squares, weighted, moments, total):
    """Noise of a weighted mean: from that of its samples, or from how much they differ."""
    spread = (moments[1] / total - (moments[0] / total) ** 2).clamp(min=0)
    return torch.where(known, weighted, squares * spread)


def turned(batch, x, y):
    """Change of light that the regression on normals and concavities expects from the pixels x to the right and y up."""
    slope, here = batch["slope"].unflatten(1, (4, 3)), batch["shape"]
    return ((here - moved(here, x, y))[:, :, None] * slope).sum(1)


class Regression:
    """Weighted sums of samples around each pixel, for the light there by a linear ridge regression on the place, in samples."""

    def __init__(self):
        self.places, self.squares, self.products = [0, 0], [0, 0, 0], [0, 0]

    def add(self, weight, place, change):
        """A sample: its place, and how much its light differs."""
        x, y = place
        self.places = [total + weight * at for total, at in zip(self.places, (x, y))]
        self.squares = [total + weight * square for total, square in zip(self.squares, (x * x, x * y, y * y))]
        self.products = [total + weight * at * change for total, at in zip(self.products, (x, y))]

    def lean(self, total, mean, trust, wide):
        """What the mean change exceeds that at the pixel by, because its samples lie more on one side. wide: see WIDE_OFFSETS."""
        x, y = (value / total for value in self.places)
        xx, xy, yy = (value / total for value in self.squares)
        xx, xy, yy = xx - x * x + RIDGE, xy - x * y, yy - y * y + RIDGE
        along, across = ((yy * x - xy * y) / (xx * yy - xy * xy), (xx * y - xy * x) / (xx * yy - xy * xy))
        sizes = along.abs(), across.abs()
        most = torch.maximum(*sizes) if wide else sum(sizes)
        trust = torch.minimum(trust, 1 / (most - along * x - across * y).clamp(min=1e-6))  # no weight is negative
        return trust * ((along * self.products[0] + across * self.products[1]) / total - (along * x + across * y) * mean)


def filtered(batch, reach, weigh, levels=LEVELS, most_bend=torch.inf, shares=None):
    """The signal after so many levels. weigh(level, x, y, guided): weight of the samples at an offset, besides the kernel's, their
    frames and their similarity; guided: differences of luminance in standard deviations, 0 where noise is unknown. most_bend:
    see MOST_BEND. shares: of the regression on places, and of samples of other surfaces, by level; without them all levels have
    nine samples."""
    light, frames = batch["light"], batch["frames"]
    bend = BEND * torch.minimum(1 + (frames - 1).clamp(min=0) / BEND_HALVED, torch.as_tensor(most_bend))
    noise = batch["error"] * luminance(light)
    for level in range(levels):
        step, farthest = 2 ** level, FARTHEST[level] if shares else 1
        kernel, offsets = KERNELS[farthest], OFFSETS if farthest == 1 else WIDE_OFFSETS
        bright, known = luminance(light), noise > 0
        total = change = first = second = squares = weighted = 0
        fit = Regression()
        trust, others = (values[:, level:level + 1] for values in shares) if shares else (None, None)
        for place, alike in zip(offsets, similarities(batch, step, bend, offsets)):
            x, y = (at * step for at in place)
            there, other_noise = moved(light, x, y) + turned(batch, x, y), moved(noise, x, y)
            other = luminance(there)
            apart = (other - bright).abs() * torch.rsqrt((noise ** 2 + other_noise ** 2).clamp(min=1e-30))
            guided = torch.where(known, apart, torch.zeros_like(apart))
            if shares:
                both = batch["exists"] * moved(batch["exists"], x, y)
                alike = alike + torch.minimum(others, moved(others, x, y)) * (both - alike)
            weight = kernel[abs(place[0])] * kernel[abs(place[1])] * alike * moved(frames, x, y) * weigh(level, x, y, guided)
            total, change = total + weight, change + weight * (there - light)
            first, second = first + weight * other, second + weight * other ** 2
            squares, weighted = squares + weight ** 2, weighted + (weight * other_noise) ** 2
            if shares:
                fit.add(weight, [at / farthest for at in place], there - light)
        total = total.clamp(min=1e-6)
        share = (2 * reach / step - 1).clamp(0, 1)
        change = change / total
        if shares:
            change = change - fit.lean(total, change, trust, farthest > 1)
        light = (light + share * change).clamp(min=0)
        left = variance(known, squares, weighted, (first, second), total).detach().sqrt() / total.detach()
        noise = torch.minimum(noise + share * (left - noise), luminance(light).detach()) * batch["exists"]
    return light


def fade(frames, halved):
    """Reach of the filter after a number of frames: glsl/lib/filter_reach.glsl."""
    return RADIUS * (2 - 2 * frames / LAST).clamp(0, 1) / (1 + frames / halved)


def plain_filter(batch, levels=LEVELS):
    """The filter without a network."""
    def weigh(_level, _x, _y, guided):
        return torch.exp(-guided / TOLERANCE)
    batch = {**batch, "slope": batch["slope"] * batch["fits"]}
    return filtered(batch, fade(batch["frames"], LIGHT_HALVED), weigh, levels)


class Denoiser(nn.Module):
    """The filter with the network."""

    def __init__(self):
        super().__init__()
        self.net = UNet(FEATURES + len(FIRST_BIASES) * LEVELS)
        self.fine = nn.Conv2d(INPUTS, FINE, 1, bias=False)  # an input is 1
        self.fine_out = nn.Conv2d(FINE, self.net.last.out_channels, 1, bias=False)
        for last in (self.net.last, self.fine_out):
            nn.init.normal_(last.weight, std=0.02)
        with torch.no_grad():  # much as without a network; sharpnesses below their limit in first frames, so that they learn
            self.net.last.bias.copy_(torch.tensor([0.0] * FEATURES + [bias for bias in FIRST_BIASES for _ in range(LEVELS)]))

    def guides(self, batch):
        """Features of each pixel of a batch with its surfaces, in a picture of the training's size; and by level bandwidths,
        sharpnesses, shares of the regression on places and of samples of other surfaces."""
        single, blocks = inputs(batch)
        outputs = functional.interpolate(self.net(blocks), scale_factor=2, mode="bilinear", align_corners=False)
        outputs = outputs + self.fine_out(functional.relu(self.fine(single)))
        features, bandwidths, sharpnesses, trusts, others = outputs.split((FEATURES, *(LEVELS for _ in FIRST_BIASES)), 1)
        sharpnesses = functional.softplus(sharpnesses).clamp(min=LEAST_SHARPNESS)
        return features, functional.softplus(bandwidths), sharpnesses, trusts.sigmoid(), MOST_OTHERS * others.sigmoid()

    def forward(self, batch):
        """Filtered light of a batch with its surfaces."""
        features, bandwidths, sharpnesses, *shares = self.guides(batch)
        frames = batch["frames"]

        def weigh(level, x, y, guided):
            apart = ((moved(features, x, y) - features) ** 2).sum(1, keepdim=True)
            bandwidth, sharpness = (torch.maximum(own, moved(own, x, y)) for own in
                                    (values[:, level:level + 1] for values in (bandwidths, sharpnesses)))
            bandwidth = bandwidth * (torch.maximum(frames, moved(frames, x, y)) / FEATURE_FRAMES).clamp(max=1)
            least = torch.minimum(frames, moved(frames, x, y)).clamp(min=1)
            most = SHARPNESS_PER_FRAME * least.clamp(min=FEWEST_FRAMES)
            sharpness = torch.minimum(sharpness, most) * (SHARP_FRAMES / least).clamp(LEAST_SHARE, 1)
            return torch.exp(-bandwidth * apart - sharpness * guided)
        return filtered(batch, fade(frames, 1e9), weigh, most_bend=MOST_BEND, shares=shares)

    def layers(self):
        """Convolutions by their names in the file."""
        named = {f"e{i}": layer for i, layer in enumerate(self.net.down)}
        named.update({f"d{i}": layer for i, layer in enumerate(self.net.up)})
        return {**named, "out": self.net.last, "fine": self.fine, "fine_out": self.fine_out}

    def save(self, path, facts):
        """Write the file of the network."""
        layers = {}
        for name, layer in self.layers().items():
            values = [part.detach().reshape(-1).tolist() for part in (layer.weight, layer.bias) if part is not None]
            layers[name] = weights.Layer(layer.in_channels, layer.out_channels, layer.kernel_size[0], sum(values, []))
        weights.write(path, facts, layers)

    def restore(self, path):
        """Take the weights of a file, and return its facts. Outputs that it lacks are their first biases."""
        facts, layers = weights.read(path)
        with torch.no_grad():
            for name, layer in self.layers().items():
                found, values = layers[name], torch.tensor(layers[name].values)
                count = found.weight_count()
                layer.weight[:found.outputs] = values[:count].reshape(found.outputs, *layer.weight.shape[1:])
                layer.weight[found.outputs:] = 0
                if layer.bias is not None:
                    layer.bias[:found.outputs] = values[count:]
        return facts


def mean_of(values, batch):
    """Means of pictures over their known pixels and channels."""
    known = batch["known"]
    return (values * known).sum((1, 2, 3)) / (values.shape[1] * known.sum((1, 2, 3)).clamp(min=1))


def squares_of(picture, batch, target="target"):
    """Squared difference of each pixel from the target of this name, relative to what a picture shows, light together with direct
    light; its mean is relMSE. The light in the divisor is that of other random numbers, see data.target()."""
    shown = (batch["measure"] + batch["direct"]) ** 2
    return (picture - batch[target]) ** 2 / (shown + batch["least"])


def relative_error(picture, batch):
    """relMSE of each picture of a batch against its target, which may have noise."""
    return mean_of(squares_of(picture, batch), batch)


def loss_of(picture, batch, target="target"):
    """relMSE in units of the error that the filter without a network leaves: noise of all sizes counts alike. Where a relative
    difference exceeds a limit, what follows counts linearly (Huber 1964, Robust Estimation of a Location Parameter)."""
    squares = squares_of(picture, batch, target)
    most = torch.full_like(squares, MOST_SQUARE)
    squares = torch.where(squares > most, 2 * (most * torch.maximum(squares, most)).sqrt() - most, squares)
    return (mean_of(squares, batch) / batch["filtered"].flatten()).mean()
