# SPDX-FileCopyrightText: Penumbra authors
# SPDX-License-Identifier: BSD-3-Clause
"""Renders pictures without a screen."""
import pathlib

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import vtkRenderer, vtkRenderWindow, vtkWindowToImageFilter

from .vtkRenderingGI import vtkGIPass, vtkHeadlessRenderWindow


def window(*renderers, size=(800, 600), multisamples=8):
    """Create an offscreen window with renderers."""
    made = vtkRenderWindow()
    made.SetOffScreenRendering(1)
    made.SetMultiSamples(multisamples)
    made.SetSize(*size)
    for renderer in renderers:
        made.AddRenderer(renderer)
    return made


def _capture(target, frames, alpha, alone=False):
    if isinstance(target, vtkRenderer):
        target = target.GetRenderWindow()
        if target is None:
            raise ValueError("the renderer has no window: put it in one with penumbra.window(renderer)")
    if not isinstance(target, vtkRenderWindow):
        raise TypeError(f"expected a vtkRenderWindow or a vtkRenderer, not {type(target).__name__}")
    if frames < 1:
        raise ValueError(f"frames is {frames}: at least one frame must be drawn")
    for renderer in target.GetRenderers():
        if alone and isinstance(renderer.GetPass(), vtkGIPass):
            renderer.GetPass().Restart()
    for _ in range(frames):
        target.Render()
    if isinstance(target, vtkHeadlessRenderWindow) and target.GetContextError():
        raise RuntimeError(target.GetContextError())
    for renderer in target.GetRenderers():
        if isinstance(renderer.GetPass(), vtkGIPass) and renderer.GetPass().GetLastError():
            raise RuntimeError(renderer.GetPass().GetLastError())
    capture = vtkWindowToImageFilter()
    capture.SetInput(target)
    capture.ReadFrontBufferOff()
    capture.ShouldRerenderOff()
    if alpha:
        capture.SetInputBufferTypeToRGBA()
    capture.Update()
    return capture.GetOutput()


def render(target, frames=1, alpha=False):
    """Draw a window (or a renderer's window) and return the picture as an array.

    The array of bytes has the shape (height, width, 3), or (height, width, 4) with alpha, top row first. If
    anti-aliasing accumulates, still frames are averaged: more frames give smoother edges.
    """
    image = _capture(target, frames, alpha)
    width, height, _ = image.GetDimensions()
    return vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, -1)[::-1].copy()


def _make_straight(pixels, renderer):
    """Divide colours by their alpha, in place. VTK blends over the background's colour even where its alpha is 0."""
    alpha = pixels[:, 3:] / 255.0
    behind = numpy.zeros(3) if renderer.GetGradientBackground() else 255.0 * numpy.array(renderer.GetBackground())
    straight = (pixels[:, :3] - (1 - alpha) * behind) / numpy.maximum(alpha, 1 / 255.0)
    pixels[:, :3] = numpy.rint(numpy.clip(straight, 0, 255))


def save_png(target, path, frames=1, alpha=False):
    """Draw a window (or a renderer's window) and write the picture to a PNG file.

    alpha: the file has straight alpha; for a transparent background set SetBackgroundAlpha(0) on the renderer, and
    SetAlphaBitPlanes(1) on the window before it draws. The picture uses nothing from previous frames (see vtkGIPass.Restart()), so each picture of a film depends only on
    the scene at its time.
    """
    image = _capture(target, frames, alpha, alone=True)
    if alpha:
        window = target.GetRenderWindow() if isinstance(target, vtkRenderer) else target
        _make_straight(vtk_to_numpy(image.GetPointData().GetScalars()), window.GetRenderers().GetFirstRenderer())
    path = pathlib.Path(path)
    try:
        path.open("wb").close()
    except OSError as error:
        raise OSError(f"cannot write {path}: {error.strerror}") from None
    writer = vtkPNGWriter()
    writer.SetFileName(str(path))
    writer.SetInputData(image)
    writer.Write()
    if writer.GetErrorCode():
        raise OSError(f"cannot write {path}: is the disk full?")


def radiance(gi, renderer):
    """Return the linear radiance of the last frame, a float array of shape (height, width, 4), top row first.

    The fourth number is 1 where there is a surface. Needs gi.KeepRadianceOn() before rendering.
    """
    image = vtkImageData()
    if not gi.GetRadiance(renderer, image):
        raise RuntimeError("no radiance was kept: call KeepRadianceOn() on the pass, then render")
    width, height, _ = image.GetDimensions()
    return vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, -1)[::-1].copy()


def relative_squares(picture, truth):
    """The squares whose mean is relMSE, see relative_error(): an array of the shape of both pictures."""
    picture, truth = numpy.asarray(picture, float), numpy.asarray(truth, float)
    if picture.shape != truth.shape:
        raise ValueError(f"the picture has shape {picture.shape}, the truth {truth.shape}: draw both at one size")
    epsilon = 0.01 * truth.mean() ** 2 if truth.size else 0.0
    if not epsilon > 0:
        raise ValueError("the truth is dark or empty: there is nothing to compare with")
    return (picture - truth) ** 2 / (truth ** 2 + epsilon)


def relative_error(picture, truth, where=None):
    """Compare linear radiance with the truth, an array of the same shape. Returns relMSE and the signed mean error.

    relMSE is the mean of (picture - truth)^2 / (truth^2 + epsilon). epsilon is 0.01 of the squared mean of the truth,
    so that dark pixels do not count more than they are visible. The signed mean error is a fraction of the truth's
    mean. where: a mask of the pixels to compare, all by default; epsilon is always that of the whole picture.
    """
    squares = relative_squares(picture, truth)
    picture, truth = numpy.asarray(picture, float), numpy.asarray(truth, float)
    if where is not None:
        squares, picture, truth = squares[where], picture[where], truth[where]
    if not truth.size or not truth.mean() > 0:
        raise ValueError("the truth is dark or empty: there is nothing to compare with")
    return float(squares.mean()), float(picture.mean() / truth.mean() - 1)
