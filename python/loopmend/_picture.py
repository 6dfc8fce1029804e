# SPDX-License-Identifier: GPL-3.0-or-later
"""Pictures of meshes by NumPy alone: they need neither a graphics driver nor another package."""
from __future__ import annotations

import struct
import zlib
from typing import Optional, Sequence, Tuple

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
SCAN, PATCH = (203, 205, 208), (232, 136, 32)


def _normals(corners: Array) -> Array:
    """(m, 3), as long as twice the area."""
    normals = np.asarray(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), dtype=np.float64)
    return normals


def view_of(vertices: Array, faces: NDArray[np.int32], new: NDArray[np.bool_]) -> Array:
    """(3,): from where the new faces are seen best; without any, the whole surface."""
    normals = _normals(vertices[faces]) if len(faces) else np.zeros((0, 3))
    for chosen in (normals[new], normals):
        total = chosen.sum(axis=0)
        if len(chosen) and np.linalg.norm(total) > 0.2 * np.linalg.norm(chosen, axis=1).sum():
            return np.asarray(total / np.linalg.norm(total), np.float64)
    return np.asarray(np.array([1, -1.5, 0.8]) / np.linalg.norm([1, -1.5, 0.8]), np.float64)


def _axes(direction: Array) -> Array:
    """(3, 3): to the right, up, to the eye."""
    up = np.array([0.0, 0, 1]) if abs(direction[2]) < 0.9 else np.array([0.0, 1, 0])
    right = np.cross(up, direction)
    right /= np.linalg.norm(right)
    return np.array([right, np.cross(direction, right), direction])


def _nearest_faces(corners: Array, width: int, height: int) -> NDArray[np.int64]:
    """Per pixel the face nearest to the eye; −1: none. corners: (m, 3, 3) in pixels, the third number to the eye."""
    depth = np.full(width * height, -np.inf)
    face = np.full(width * height, -1, np.int64)
    extent = (corners[:, :, :2].max(axis=1) - corners[:, :, :2].min(axis=1)).max(axis=1)
    parts = np.ceil(np.maximum(2 * extent, 1)).astype(np.int64)  # samples lie half a pixel apart
    parts = np.where(parts > 16, -(-parts // 8) * 8, parts)  # few different numbers of them
    for count in np.unique(parts):
        i, j = np.nonzero(np.add.outer(np.arange(count + 1), np.arange(count + 1)) <= count)
        weights = np.column_stack([i, j, count - i - j]) / count
        chosen = np.flatnonzero(parts == count)
        for part in np.array_split(chosen, max(1, len(chosen) * len(weights) // 2_000_000)):
            points = (weights @ corners[part]).reshape(-1, 3)
            pixel = points[:, 1].astype(np.int64) * width + points[:, 0].astype(np.int64)
            z, of = points[:, 2], np.repeat(part, len(weights))
            nearer = z > depth[pixel]
            pixel, z, of = pixel[nearer], z[nearer], of[nearer]
            np.maximum.at(depth, pixel, z)
            nearest = z == depth[pixel]
            face[pixel[nearest]] = of[nearest]
    return face


def picture(vertices: Array, faces: NDArray[np.int32], new: NDArray[np.bool_], colors: Optional[NDArray[np.uint8]],
            size: Tuple[int, int], direction: Optional[Sequence[float]]) -> NDArray[np.uint8]:
    """(height, width, 3): the mesh from far away; new faces are orange."""
    width, height = 2 * size[0], 2 * size[1]  # each pixel is the mean of four
    image = np.full((height * width, 3), 255.0)
    if len(faces):
        towards = view_of(vertices, faces, new) if direction is None else np.asarray(direction, float)
        towards = towards / np.linalg.norm(towards)
        seen = (vertices[faces] @ _axes(towards).T) * [1, -1, 1]
        low, high = seen.min(axis=(0, 1)), seen.max(axis=(0, 1))
        scale = min(0.94 * width / max(high[0] - low[0], 1e-300), 0.94 * height / max(high[1] - low[1], 1e-300))
        at = (seen - (low + high) / 2) * scale + [width / 2, height / 2, 0]
        normals = _normals(vertices[faces])
        normals /= np.maximum(np.linalg.norm(normals, axis=1), 1e-300)[:, None]
        light = towards + 0.35 * _axes(towards)[1] - 0.35 * _axes(towards)[0]
        shade = 0.3 + 0.7 * np.abs(normals @ (light / np.linalg.norm(light)))
        tint = np.where(new[:, None], PATCH, SCAN) if colors is None else colors[faces][:, :, :3].mean(axis=1)
        face = _nearest_faces(at, width, height)
        image[face >= 0] = (tint * shade[:, None])[face[face >= 0]]
    return np.asarray(image.reshape(size[1], 2, size[0], 2, 3).mean(axis=(1, 3)).round().astype(np.uint8))


def png(image: NDArray[np.uint8]) -> bytes:
    """The picture as a PNG file."""
    height, width, _ = image.shape
    rows = np.hstack([np.zeros((height, 1), np.uint8), image.reshape(height, -1)]).tobytes()

    def chunk(kind: bytes, data: bytes) -> bytes:
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)) +
            chunk(b"IDAT", zlib.compress(rows, 6)) + chunk(b"IEND", b""))
