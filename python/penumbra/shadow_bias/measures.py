# SPDX-FileCopyrightText: Penumbra authors
# SPDX-License-Identifier: BSD-3-Clause
"""How far the mask of a shadow map is from the true one: acne, and light that leaks in at edges."""
from dataclasses import dataclass

import numpy as np
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components
from scipy.spatial import cKDTree

# A gap that nineteen twentieths of the edges stay below: a single stray pixel is none.
PERCENTILE = 0.95
# Two pixels of one surface, or of two that touch, are no farther apart than each is from its next
# neighbour, together; the rest is for the bend of curved surfaces.
SLACK = 1.5
# From one pixel to the next, the spacing of a surface grows by less than this, up to its silhouette.
BREAK = 4
# Texels beside a true edge that count neither as acne nor as a leak; the filter's radius comes on top.
EDGE_BAND = 1.5


@dataclass
class View:
    """One light in one view: arrays of shape (height, width), top row first; places have a third axis."""
    surface: np.ndarray   # where there is any
    receiver: np.ndarray  # where it is turned to the light
    light: np.ndarray     # how bright the light makes it, 0 to 1: errors weigh as much
    truth: np.ndarray     # share of the light that arrives, 0 or 1, by rays
    place: np.ndarray     # world coordinates, read where there is a surface
    across: np.ndarray    # place across the light, in texels of its map

    def neighbors(self):
        """Pairs of neighbouring pixels with a surface, right and below, as flat indices, and whether the two surfaces
        are one, or touch."""
        flat = np.arange(self.surface.size).reshape(self.surface.shape)
        firsts, seconds, touch = [], [], []
        for axis in (1, 0):
            first, second = (np.moveaxis(flat, axis, 0)[part].ravel() for part in (slice(-1), slice(1, None)))
            both = self.surface.flat[first] & self.surface.flat[second]
            firsts.append(first[both])
            seconds.append(second[both])
            touch.append(self._touches(axis).ravel()[both])
        return np.concatenate(firsts), np.concatenate(seconds), np.concatenate(touch)

    def _touches(self, axis):
        """Whether each pixel touches the next one along an axis, which comes first in the result."""
        place = np.moveaxis(np.where(self.surface[..., None], self.place, np.nan), axis, 0)
        steps = np.linalg.norm(np.diff(place, axis=0), axis=2)
        around = np.pad(steps, ((2, 2), (0, 0)), constant_values=np.nan)

        def spacing(near, far):
            """From a pixel to its next; 0 where that is of another surface, whose own steps are far shorter."""
            return np.where(np.isnan(near) | (near > BREAK * far), 0, near)

        before, behind = spacing(around[1:-3], around[:-4]), spacing(around[3:-1], around[4:])
        return steps <= SLACK * (before + behind)


def pixel_width(view):
    """Width of a pixel in texels, the median over neighbouring receivers; 0 without any."""
    first, second, touch = view.neighbors()
    beside = touch & (second == first + 1) & view.receiver.flat[first] & view.receiver.flat[second]
    across = view.across.reshape(-1, 3)
    widths = np.linalg.norm(across[first[beside]] - across[second[beside]], axis=1)
    return float(np.sort(widths)[len(widths) // 2]) if len(widths) else 0.0


def _percentile(values, weights):
    """The value below which that share of all weight lies."""
    order = np.argsort(values)
    below = np.cumsum(weights[order])
    reached = np.flatnonzero(below >= PERCENTILE * below[-1]) if len(below) else []
    return float(values[order][reached[0]]) if len(reached) else 0.0


class Judge:
    """Finds the true shadow's edges once, then measures any number of masks against it.

    unbiased: the map's mask without any bias. What it lights of the true shadow is finer than its texels, and counts
    for nothing but `lost`, its share. band: texels beside true edges that are left out.
    """

    def __init__(self, view, unbiased, band=EDGE_BAND):
        self.view = view
        self._first, self._second, self._touch = view.neighbors()
        self._place, self._across = view.place.reshape(-1, 3), view.across.reshape(-1, 3)
        self._light = view.light.ravel()
        truly_dark = (view.receiver & (view.truth < 0.5)).ravel()
        self._dark = truly_dark & (np.ravel(unbiased) < 0.5)
        self.lost = float((truly_dark & ~self._dark).sum() / max(1, truly_dark.sum()))
        self._find_edges()
        self._counts = view.receiver.ravel() & (truly_dark == self._dark)
        self._leave_out_edges(truly_dark, band)
        lit, dark = self._counts & ~self._dark, self._counts & self._dark
        self.lit_pixels, self.dark_pixels = int(lit.sum()), int(dark.sum())
        self._light_on_lit = float(self._light[lit].sum()) or 1.0
        self._light_on_dark = float(self._light[dark].sum()) or 1.0

    def _between(self, points, pairs):
        return (points[self._first[pairs]] + points[self._second[pairs]]) / 2

    def _find_edges(self):
        """Between neighbours of which one is truly dark. The other is lit: an outline; or it is turned away from the
        light: there what casts the shadow stands on what receives it, if the two touch."""
        first, second = self._first, self._second
        edges = (self._dark[first] != self._dark[second]) & self._touch
        receiver = self.view.receiver.ravel()
        self._contact = ~(receiver[first] & receiver[second])[edges]
        self._edge_pixel = np.where(self._dark[first], first, second)[edges]  # the dark one
        self._edge_place, self._edge_across = self._between(self._place, edges), self._between(self._across, edges)
        self.contact_points = int(self._contact.sum())
        self.outline_points = int((~self._contact).sum())

    def _leave_out_edges(self, truly_dark, band):
        differ = truly_dark[self._first] != truly_dark[self._second]
        bordering = np.unique([self._first[differ], self._second[differ]])
        self._counts[bordering] = False
        left = np.flatnonzero(self._counts)
        if len(bordering) and len(left):
            distance, _ = cKDTree(self._across[bordering]).query(self._across[left])
            self._counts[left[distance <= band]] = False

    def error(self, mask):
        """The light that a mask wrongly takes from each pixel (positive: acne) or gives to it (negative: a leak); 0 near
        edges, and where there is no receiver."""
        return np.where(self._counts, self.view.truth.ravel() - np.ravel(mask), 0.0).reshape(mask.shape)

    def measure(self, mask):
        """The errors of a mask, by the names that docs/techniques/shadow-bias.md gives them."""
        error = self._light * self.error(mask).ravel()
        texels, world = self._gaps(np.ravel(mask))
        gaps = {}
        for name, chosen in (("contact-gap", self._contact), ("outline-gap", ~self._contact)):
            weights = self._light[self._edge_pixel[chosen]]
            gaps[name] = {"texels": _percentile(texels[chosen], weights), "world": _percentile(world[chosen], weights)}
        return {"acne": float(np.maximum(error, 0).sum() / self._light_on_lit),
                "leak": float(np.maximum(-error, 0).sum() / self._light_on_dark),
                "gap": max(gap["texels"] for gap in gaps.values()), **gaps}

    def _gaps(self, mask):
        """From each edge to where the map's shadow begins, in texels and in the world; where a whole patch of the shadow
        is gone, across all that it was."""
        leaks = self._dark & (mask > 0.5)
        first, second = self._first[self._touch], self._second[self._touch]
        inside = leaks[first] & leaks[second]
        graph = coo_matrix((np.ones(inside.sum()), (first[inside], second[inside])), shape=2 * (len(mask),))
        _, patch = connected_components(graph, directed=False)
        texels, world = np.zeros(len(self._edge_pixel)), np.zeros(len(self._edge_pixel))
        gaping = np.flatnonzero(leaks[self._edge_pixel])
        if not len(gaping):
            return texels, world
        patch_of_edge = patch[self._edge_pixel[gaping]]
        # Shores lie between the leaks and the dark. A fourth coordinate keeps patches apart.
        shore = self._touch & self._dark[self._first] & self._dark[self._second] \
            & (leaks[self._first] != leaks[self._second])
        far = 1 + 2 * np.linalg.norm(np.ptp(self._place[self._dark], axis=0))
        places, across = self._between(self._place, shore), self._between(self._across, shore)
        patch_of_shore = patch[np.where(leaks[self._first], self._first, self._second)[shore]]
        begun = np.isin(patch_of_edge, patch_of_shore)
        some = gaping[begun]
        if len(some):
            tree = cKDTree(np.column_stack([places, far * patch_of_shore]))
            _, nearest = tree.query(np.column_stack([self._edge_place[some], far * patch_of_edge[begun]]))
            texels[some] = np.linalg.norm(self._edge_across[some] - across[nearest], axis=1)
            world[some] = np.linalg.norm(self._edge_place[some] - places[nearest], axis=1)
        for gone in np.unique(patch_of_edge[~begun]):
            pixels, edges = leaks & (patch == gone), gaping[patch_of_edge == gone]
            texels[edges] = np.linalg.norm(np.ptp(self._across[pixels], axis=0))
            world[edges] = np.linalg.norm(np.ptp(self._place[pixels], axis=0))
        return texels, world
