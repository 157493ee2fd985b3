"""Where the tests run under the address sanitizer, it sees what it is there for."""

import os
import subprocess
import sys

import pytest


@pytest.mark.skipif("asan" not in os.environ.get("LD_PRELOAD", ""), reason="not under the address sanitizer")
def test_a_byte_behind_a_block_is_seen():
    script = """import ctypes
c = ctypes.CDLL(None)
c.malloc.restype = ctypes.c_void_p
c.memset(ctypes.c_void_p(c.malloc(8)), 0, {})"""
    for size, seen in [(8, False), (9, True)]:
        run = subprocess.run([sys.executable, "-c", script.format(size)], capture_output=True, text=True)
        assert ("heap-buffer-overflow" in run.stderr) is seen, run.stderr
        assert (run.returncode != 0) is seen
