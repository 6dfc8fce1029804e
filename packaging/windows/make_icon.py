#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes the icon of the programs for Windows out of pictures, which it takes as they are.

Usage: packaging/windows/make_icon.py ICON.ico PICTURE.png...
"""
import pathlib
import struct
import sys


def icon(pictures):
    entries, at = b"", 6 + 16 * len(pictures)
    for png in pictures:
        width, height = struct.unpack(">II", png[16:24])
        entries += struct.pack("<BBBBHHII", width % 256, height % 256, 0, 0, 1, 32, len(png), at)
        at += len(png)
    return struct.pack("<HHH", 0, 1, len(pictures)) + entries + b"".join(pictures)


if __name__ == "__main__":
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    pathlib.Path(sys.argv[1]).write_bytes(icon([pathlib.Path(name).read_bytes() for name in sys.argv[2:]]))
