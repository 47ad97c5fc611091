# SPDX-FileCopyrightText: Penumbra authors
# SPDX-License-Identifier: BSD-3-Clause
"""The denoiser in NumPy, written after the shaders and independently of PyTorch: the reference of both."""
import numpy as np
import weights

TILE, LEVELS, RADIUS, LAST = 16, 4, 8, 256
FEATURE_FRAMES, SHARPNESS_PER_FRAME, FEWEST_FRAMES, SHARP_FRAMES, LEAST_SHARE = 4, 0.05, 8, 12, 0.4
LEAST_SHARPNESS, MOST_OTHERS, MOST_LIGHT = 0.15, 0.5, 3
BEND, BEND_HALVED, MOST_BEND = 10, 4, 2.25
# Ridges of the regression on normals and concavities in a first frame, their minimum, and the light at which outliers are clamped.
RIDGES, LEAST_RIDGES, MOST_IN_TILE = (0.05, 0.05, 0.05, 0.1), (0, 0, 0, 0.025), 8
REACHES, FARTHEST, STEPS = 48, 6, 32767  # of concavities, see glsl/denoising/pack.frag and signal.glsl
PLACE_RIDGE = 0.1              # of the regression on places
KERNELS = (0.5, 0.25), (0.375, 0.25, 0.0625)
LUMINANCE = np.array((0.2126, 0.7152, 0.0722))
OFFSETS = [(x, y) for y in (-1, 0, 1) for x in (-1, 0, 1)]
WIDE_OFFSETS = [(x, y) for y in range(-2, 3) for x in range(-2, 3) if abs(x) + abs(y) <= 2]


def half(values):
    """Rounded as textures of half floats hold them."""
    return values.astype(np.float16).astype(float)


def moved(values, x, y):
    """The values x pixels to the right and y up; 0 from outside."""
    height, width = values.shape[:2]
    result = np.zeros_like(values)
    rows = slice(max(-y, 0), height - max(y, 0)), slice(max(y, 0), height - max(-y, 0))
    columns = slice(max(-x, 0), width - max(x, 0)), slice(max(x, 0), width - max(-x, 0))
    if abs(x) < width and abs(y) < height:
        result[rows[0], columns[0]] = values[rows[1], columns[1]]
    return result


def read_network(path):
    """Weights (outputs, inputs, y, x) and biases by the layer's name."""
    _, layers = weights.read(path)
    found = {}
    for name, layer in layers.items():
        values, count = np.array(layer.values), layer.weight_count()
        found[name] = values[:count].reshape(layer.outputs, layer.inputs, layer.kernel, layer.kernel), values[count:]
    return found


class Surfaces:
    """The surfaces of a signal, see data.Signal."""

    def __init__(self, signal):
        height, width = signal.frames.shape
        self.exists, self.frames = signal.frames > 0, signal.frames.astype(float)
        self.depth, self.normal = signal.depth.astype(float), signal.normal.astype(float)
        x = ((np.arange(width) + 0.5) / width * 2 - 1) / signal.projection[0]
        y = ((np.arange(height) + 0.5) / height * 2 - 1) / signal.projection[1]
        self.position = np.stack((-self.depth * x[None, :], -self.depth * y[:, None], self.depth), -1)
        self.pixel = 2 * np.abs(self.depth) / (width * signal.projection[0])
        xy = 2 * self.normal - 1
        z = 1 - np.abs(xy).sum(-1)
        xy = xy - np.where(xy >= 0, 1, -1) * np.maximum(-z, 0)[..., None]
        direction = np.concatenate((xy, z[..., None]), -1)
        self.direction = direction / np.maximum(np.linalg.norm(direction, axis=-1, keepdims=True), 1e-12)
        distance = np.maximum(np.linalg.norm(self.position, axis=-1), 1e-12)
        self.toward = -(self.direction * self.position).sum(-1) / distance
        self.concavity = self.concavities(max(int(min(height, width) / REACHES + 0.5), 2))

    def rise(self, x, y, reach):
        """Sine of the angle at which surfaces rise above the plane of each pixel's, and how much they count."""
        apart = moved(self.position, reach * x, reach * y) - self.position
        far = np.maximum(np.linalg.norm(apart, axis=-1), 1e-30)
        share = far / np.maximum(FARTHEST * reach * self.pixel, 1e-30)
        weight = (moved(self.exists, reach * x, reach * y) & self.exists) / (1 + share ** 2)
        return (self.direction * apart).sum(-1) / far, weight

    def concavities(self, reach):
        """How hollow the surface at each pixel is: glsl/denoising/pack.frag. Rounded as the signal holds it."""
        rise, count, falls = np.zeros_like(self.depth), np.zeros_like(self.depth), []
        for x, y in OFFSETS[:4]:
            (one, weight), (other, other_weight) = self.rise(x, y, reach), self.rise(-x, -y, reach)
            rise += weight * np.maximum(one, 0) + other_weight * np.maximum(other, 0)
            count += weight + other_weight
            falls.append(2 * np.minimum(weight, other_weight) * np.minimum(np.maximum(one, other), 0))
        concavity = (rise + sum(falls) - np.min(falls, axis=0)) / np.maximum(count, 1e-6)
        root = np.floor(STEPS * (np.sign(concavity) * np.sqrt(np.abs(concavity)) + 1) + 0.5) / STEPS - 1
        return root * np.abs(root)

    def shapes(self):
        """What light is fitted to: the normal and the concavity, (h, w, 4)."""
        return np.concatenate((self.direction, self.concavity[..., None]), -1)

    def similarity(self, x, y, step, bend=BEND):
        """How much the pixels x and y away, `step` pixels per unit, show the same surface. bend: how much the squared difference of
        normals counts."""
        x, y = x * step, y * step
        apart = moved(self.position, x, y) - self.position
        closer = self.depth / np.where(moved(self.exists, x, y), moved(self.depth, x, y), -1)  # as window depths are compared
        plane = np.abs((self.direction * apart).sum(-1)) * np.clip(np.abs(self.toward), 0.2, 1) * closer
        turned = ((moved(self.normal, x, y) - self.normal) ** 2).sum(-1)
        alike = np.clip(2 - plane / np.maximum(step * self.pixel, 1e-12), 0, 1) * np.clip(1 - bend * turned, 0, 1)
        return np.where(moved(self.exists, x, y) & self.exists, alike if x or y else 1, 0)


def in_tiles(values):
    """Sums of tiles."""
    rows = np.add.reduceat(values, np.arange(0, values.shape[0], TILE), axis=0)
    return np.add.reduceat(rows, np.arange(0, values.shape[1], TILE), axis=1)


def block_scales(luminance, exists):
    """Mean luminance around each block of 2x2 pixels."""
    sums = [in_tiles(values) for values in (luminance * exists, exists.astype(float))]
    shares = []
    for pixels, tiles in zip(luminance.shape, sums[0].shape):
        table = np.zeros(((pixels + 1) // 2, tiles))
        for block, row in enumerate(table):
            place = (2 * block + 1) / TILE - 0.5
            corner, fraction = int(np.floor(place)), place - np.floor(place)
            for tile, share in zip(range(corner - 1, corner + 3), (1 - fraction, 1, 1, fraction)):
                if 0 <= tile < tiles:
                    row[tile] += share
        shares.append(table)
    light, count = (shares[0] @ values @ shares[1].T for values in sums)
    return np.maximum(light / np.maximum(count, 1e-6), 1e-20)


def in_blocks(values):
    """Sums of blocks of 2x2 pixels; pixels outside count as 0."""
    height, width = values.shape[:2]
    padded = np.pad(values, ((0, height % 2), (0, width % 2), (0, 0)))
    return padded.reshape((height + 1) // 2, 2, (width + 1) // 2, 2, -1).sum((1, 3))


def enlarged(values, height, width):
    """Each texel as 2x2."""
    return values.repeat(2, 0).repeat(2, 1)[:height, :width]


def inputs(signal, surfaces):
    """What the network gets, for pixels and for blocks."""
    light, exists = signal.light.astype(float), surfaces.exists
    height, width = exists.shape
    luminance = light @ LUMINANCE
    scale = enlarged(block_scales(luminance, exists)[..., None], height, width)
    near, total, brightest = np.zeros_like(light), np.zeros_like(scale), np.full_like(luminance, -1)
    for x, y in OFFSETS:
        weight = (surfaces.similarity(x, y, 1) * moved(surfaces.frames, x, y))[..., None]
        near, total = near + weight * moved(light, x, y), total + weight
        if x or y:
            brightest = np.maximum(brightest, np.where(weight[..., 0] > 0, moved(luminance, x, y), -1))
    share = np.where(brightest < 0, 1, np.minimum(brightest / np.maximum(luminance, 1e-20), 1))[..., None]
    sides = ((1, 0), (-1, 0), (0, 1), (0, -1))
    edge = sum((1 - np.clip((surfaces.direction * moved(surfaces.direction, x, y)).sum(-1), 0, 1)) * moved(exists, x, y)
               for x, y in sides)
    depth = np.where(exists, surfaces.depth, -1)
    changes = [16 * np.clip(moved(surfaces.depth, x, y) / depth - 1, -1, 1) * moved(exists, x, y) for x, y in ((1, 0), (0, 1))]
    near = near / np.maximum(total, 1e-6)
    lights = [np.log1p(np.minimum(value / scale, MOST_LIGHT)) for value in
              (share * light, near, share * (signal.error * luminance)[..., None])]
    single = np.concatenate((*lights,
                             (surfaces.frames / (surfaces.frames + 8))[..., None], surfaces.direction,
                             np.stack((surfaces.toward, edge, np.ones_like(edge), *changes), -1)), -1) * exists[..., None]
    return single, half(in_blocks(single) / np.maximum(in_blocks(exists[..., None].astype(float)), 1))


def slopes(signal, surfaces):
    """Derivative of light with respect to the normal and the concavity around each pixel, (h, w, component, channel): a ridge
    regression over tiles and their neighbours, glsl/denoising/slopes.comp."""
    height, width = surfaces.exists.shape
    light, weight, shape = signal.light.astype(float), surfaces.frames[..., None], surfaces.shapes()
    luminance = light @ LUMINANCE
    mean = (in_tiles(np.sqrt(luminance) * surfaces.exists) / np.maximum(in_tiles(surfaces.exists.astype(float)), 1)) ** 2
    most = MOST_IN_TILE * mean.repeat(TILE, 0).repeat(TILE, 1)[:height, :width]
    light = light * np.minimum(most / np.maximum(luminance, 1e-20), 1)[..., None]

    def products(other):
        return (shape[..., :, None] * other[..., None, :]).reshape(height, width, -1)
    parts = shape, light, products(shape), products(light)
    sums = np.pad(in_tiles(np.concatenate((weight * np.concatenate(parts, -1), weight, surfaces.exists[..., None]), -1)),
                  ((1, 1), (1, 1), (0, 0)))
    rows, columns = mean.shape
    sums = sum((1 - 0.5 * abs(x)) * (1 - 0.5 * abs(y)) * sums[1 + y:1 + y + rows, 1 + x:1 + x + columns] for x, y in OFFSETS)
    total, count = sums[..., -2], sums[..., -1]
    means = np.split(sums / np.maximum(total, 1e-6)[..., None], np.cumsum([part.shape[-1] for part in parts]), -1)
    first, bright = means[0][..., None], means[1][..., None, :]
    spread = means[2].reshape(rows, columns, 4, 4) - first * first.swapaxes(-1, -2)
    ridge = np.maximum((np.maximum(count, 1) / np.maximum(total, 1))[..., None] * RIDGES, LEAST_RIDGES)
    found = np.linalg.solve(spread + ridge[..., None] * np.eye(4), means[3].reshape(rows, columns, 4, 3) - first * bright)
    return interpolated(found.reshape(rows, columns, 12), height, width, TILE).reshape(height, width, 4, 3)


def convolved(values, layer):
    """A 3x3 convolution; outside all is 0."""
    kernel, biases = layer
    height, width = values.shape[:2]
    padded = np.pad(values, ((1, 1), (1, 1), (0, 0)))
    return biases + sum(padded[y:y + height, x:x + width] @ kernel[:, :, y, x].T for y in range(3) for x in range(3))


def pooled(values):
    """The greatest of blocks of 2x2 texels."""
    height, width = values.shape[:2]
    padded = np.pad(values, ((0, height % 2), (0, width % 2), (0, 0)))
    return padded.reshape((height + 1) // 2, 2, (width + 1) // 2, 2, -1).max((1, 3))


def network(blocks, layers):
    """The outputs of each block."""
    kept, values = [], blocks
    for level in range(LEVELS):
        values = half(np.maximum(convolved(pooled(values) if level else values, layers[f"e{level}"]), 0))
        kept.append(values)
    for number, below in enumerate(reversed(kept[:-1])):
        joined = np.concatenate((enlarged(values, *below.shape[:2]), below), -1)
        values = half(np.maximum(convolved(joined, layers[f"d{number}"]), 0))
    return half(convolved(values, layers["out"]))


def interpolated(values, height, width, size=2):
    """Blocks of so many pixels as pixels, linearly."""
    tables = []
    for pixels, blocks in zip((height, width), values.shape[:2]):
        table = np.zeros((pixels, blocks))
        for pixel, row in enumerate(table):
            place = (pixel + 0.5) / size - 0.5
            corner, fraction = int(np.floor(place)), place - np.floor(place)
            row[min(max(corner, 0), blocks - 1)] += 1 - fraction
            row[min(max(corner + 1, 0), blocks - 1)] += fraction
        tables.append(table)
    return np.einsum("yh,hwc,xw->yxc", tables[0], values, tables[1])


def guides(signal, surfaces, layers):
    """Features of each pixel; by level bandwidths, sharpnesses, shares of the regression on places and of other surfaces:
    glsl/denoising/guides.frag."""
    single, blocks = inputs(signal, surfaces)
    fine, fine_out = (layers[name][0][:, :, 0, 0].T for name in ("fine", "fine_out"))
    outputs = interpolated(network(blocks, layers), *single.shape[:2]) + half(np.maximum(single @ fine, 0)) @ fine_out
    features = half(outputs[..., :4])
    bandwidths, sharpnesses = (np.logaddexp(0, outputs[..., i:i + LEVELS]) for i in (4, 4 + LEVELS))
    trusts, others = (half(most / (1 + np.exp(-outputs[..., 4 + i * LEVELS:][..., :LEVELS])))
                      for i, most in ((2, 1), (3, MOST_OTHERS)))
    return features, half(bandwidths), half(np.maximum(sharpnesses, LEAST_SHARPNESS)), trusts, others


class Means:
    """Weighted means around each pixel: of light, and of the noise that is left. trust: share of the regression on places."""

    def __init__(self, light, noise, weigh, turned, offsets, trust):
        total = first = second = squares = weighted = np.zeros_like(noise)
        change, middle = np.zeros_like(light), np.zeros((*noise.shape, 2))
        spread, leans = np.zeros((*noise.shape, 2, 2)), np.zeros((*light.shape, 2))
        places = np.array(offsets) / np.max(offsets)
        for (x, y), place in zip(offsets, places):
            weight, moved_by = weigh(x, y)
            there, other_noise = moved(light, *moved_by) + turned(moved_by), moved(noise, *moved_by)
            other = there @ LUMINANCE
            total, first, second = total + weight, first + weight * other, second + weight * other ** 2
            squares, weighted = squares + weight ** 2, weighted + (weight * other_noise) ** 2
            change = change + weight[..., None] * (there - light)
            middle, spread = middle + weight[..., None] * place, spread + weight[..., None, None] * np.outer(place, place)
            leans = leans + (weight[..., None] * (there - light))[..., None] * place
        total = np.maximum(total, 1e-6)
        change, middle = change / total[..., None], middle / total[..., None]
        spread = spread / total[..., None, None] - middle[..., None] * middle[..., None, :] + PLACE_RIDGE * np.eye(2)
        lever = np.linalg.solve(spread, middle[..., None])[..., 0]
        farthest = (lever @ places.T).max(-1) - (lever * middle).sum(-1)
        trust = np.minimum(trust, 1 / np.maximum(farthest, 1e-6))  # so that no weight is negative
        expected = (leans @ lever[..., None])[..., 0] / total[..., None]
        self.change = change - trust[..., None] * (expected - (lever * middle).sum(-1, keepdims=True) * change)
        differing = squares * np.maximum(second / total - (first / total) ** 2, 0)
        self.noise = np.sqrt(np.where(noise > 0, weighted, differing)) / total


def denoise(signal, network_file, stored=lambda light, error: (light, error)):
    """Filtered light, (h, w, 3). stored: how textures hold light and its error between levels."""
    layers = read_network(network_file)
    surfaces = Surfaces(signal)
    features, bandwidths, sharpnesses, trusts, others = guides(signal, surfaces, layers)
    light, error = signal.light.astype(float), signal.error.astype(float)
    reach = RADIUS * np.clip(2 - 2 * surfaces.frames / LAST, 0, 1)
    bend = BEND * np.minimum(1 + np.maximum(surfaces.frames - 1, 0) / BEND_HALVED, MOST_BEND)
    slope, shape = slopes(signal, surfaces), surfaces.shapes()

    def turned(far):
        return ((shape - moved(shape, *far))[..., None] * slope).sum(-2)
    for level in range(LEVELS):
        step = 2 ** level
        offsets, kernel = (OFFSETS, KERNELS[0]) if level else (WIDE_OFFSETS, KERNELS[1])
        bright = light @ LUMINANCE
        noise = error * bright
        counts = np.stack((bandwidths[..., level], sharpnesses[..., level]), -1)

        def weigh(x, y, step=step, kernel=kernel, counts=counts, cross=others[..., level], light=light, bright=bright, noise=noise):
            far = x * step, y * step
            bandwidth, sharpness = np.moveaxis(np.maximum(counts, moved(counts, *far)), -1, 0)
            bandwidth = bandwidth * np.minimum(np.maximum(surfaces.frames, moved(surfaces.frames, *far)) / FEATURE_FRAMES, 1)
            least = np.maximum(np.minimum(surfaces.frames, moved(surfaces.frames, *far)), 1)
            sharpness = np.minimum(sharpness, SHARPNESS_PER_FRAME * np.maximum(least, FEWEST_FRAMES))
            sharpness = sharpness * np.clip(SHARP_FRAMES / least, LEAST_SHARE, 1)
            apart = ((moved(features, *far) - features) ** 2).sum(-1)
            both = np.sqrt(np.maximum(noise ** 2 + moved(noise, *far) ** 2, 1e-30))
            other = (moved(light, *far) + turned(far)) @ LUMINANCE
            deviations = np.where(noise > 0, np.abs(other - bright) / both, 0)
            weight = np.exp(-bandwidth * apart - sharpness * deviations)
            alike = surfaces.similarity(x, y, step, bend)
            alike = alike + np.minimum(cross, moved(cross, *far)) * (surfaces.exists * moved(surfaces.exists, *far) - alike)
            return kernel[abs(x)] * kernel[abs(y)] * alike * moved(surfaces.frames, *far) * weight, far
        means = Means(light, noise, weigh, turned, offsets, trusts[..., level])
        share = np.clip(2 * reach / step - 1, 0, 1)
        light = np.maximum(light + share[..., None] * means.change, 0)
        noise = noise + share * (means.noise - noise)
        light, error = stored(light, np.minimum(noise / np.maximum(light @ LUMINANCE, 1e-20), 1))
        light, error = light * surfaces.exists[..., None], error * surfaces.exists
    return light
