# SPDX-FileCopyrightText: Penumbra authors
# SPDX-License-Identifier: BSD-3-Clause
"""Counts and prints OpenGL's errors by debug output, even if no code calls glGetError."""
import ctypes
import os
import sys
import traceback

_OUTPUT, _SYNCHRONOUS, _TYPE_ERROR = 0x92E0, 0x8242, 0x824C
_CALLBACK = ctypes.CFUNCTYPE(None, ctypes.c_uint, ctypes.c_uint, ctypes.c_uint, ctypes.c_uint, ctypes.c_int,
                             ctypes.c_char_p, ctypes.c_void_p)

_gl = ctypes.CDLL("libGL.so.1")
_gl.glXGetProcAddressARB.restype = ctypes.c_void_p
_gl.glXGetProcAddressARB.argtypes = [ctypes.c_char_p]

count = 0


def _function(name, *types):
    return ctypes.CFUNCTYPE(None, *types)(_gl.glXGetProcAddressARB(name))


_listen = _function(b"glDebugMessageCallback", _CALLBACK, ctypes.c_void_p)
_enable = _function(b"glEnable", ctypes.c_uint)


@_CALLBACK
def _report(_source, kind, _id, _severity, _length, message, _user):
    global count
    if kind != _TYPE_ERROR:
        return
    count += 1
    print("GL error:", message.decode(), flush=True)
    traceback.print_stack(file=sys.stdout)
    if os.environ.get("PENUMBRA_FUZZ_STACKS"):
        libc = ctypes.CDLL(None)
        frames = (ctypes.c_void_p * 64)()
        libc.backtrace_symbols_fd(frames, libc.backtrace(frames, 64), 1)
    sys.stdout.flush()


def watch():
    """Report errors of the current context from now on. Repeated calls change nothing."""
    _listen(_report, None)
    _enable(_OUTPUT)
    _enable(_SYNCHRONOUS)
