#!/usr/bin/env python3
"""Draws the floor plans of this folder, hall.png, cave.pbm and maze.pgm, and localize.png, the map
of localize.world. They are kept beside it."""

import math
import pathlib
import struct
import zlib

HERE = pathlib.Path(__file__).resolve().parent


def plan(width, height, walls):
    """Rows of 1 (wall) and 0 from rectangles (x, y, width, height) of pixels, row 0 at the top."""
    rows = [[0] * width for _ in range(height)]
    for x, y, w, h in walls:
        for j in range(y, y + h):
            rows[j][x:x + w] = [1] * w
    return rows


def border(width, height):
    return [(0, 0, width, 1), (0, height - 1, width, 1), (0, 0, 1, height), (width - 1, 0, 1, height)]


def png(path, rows):
    raw = b"".join(b"\0" + bytes(0 if cell else 255 for cell in row) for row in rows)
    header = struct.pack(">IIBBBBB", len(rows[0]), len(rows), 8, 0, 0, 0, 0)
    with open(path, "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n")
        for kind, data in ((b"IHDR", header), (b"IDAT", zlib.compress(raw, 9)), (b"IEND", b"")):
            crc = struct.pack(">I", zlib.crc32(kind + data))
            file.write(struct.pack(">I", len(data)) + kind + data + crc)


def map_of(width, height, scale, boxes):
    """Rows of 1 where a pixel's middle is in one of the boxes (x, y, heading, length, thickness),
    m and degrees, about the middle of the picture."""
    def inside(px, py, x, y, heading, length, thickness):
        turn = math.radians(heading)
        ahead = (px - x) * math.cos(turn) + (py - y) * math.sin(turn)
        aside = (py - y) * math.cos(turn) - (px - x) * math.sin(turn)
        return abs(ahead) <= length / 2 and abs(aside) <= thickness / 2

    return [[int(any(inside((i + 0.5 - width / 2) * scale, (height / 2 - j - 0.5) * scale, *box)
                     for box in boxes)) for i in range(width)] for j in range(height)]


def main():
    # Two rooms and a door.
    png(HERE / "hall.png", plan(80, 60, border(80, 60) + [(40, 0, 2, 22), (40, 34, 2, 26)]))
    cave = plan(40, 40, border(40, 40) + [(10, 10, 5, 5), (12, 12, 8, 3), (28, 25, 3, 9)])
    with open(HERE / "cave.pbm", "w") as file:
        file.write("P1\n# a cave\n40 40\n")
        file.writelines("".join(map(str, row)) + "\n" for row in cave)
    maze = plan(24, 24, border(24, 24) + [(6, 0, 1, 16), (12, 8, 1, 16), (18, 0, 1, 16)])
    with open(HERE / "maze.pgm", "wb") as file:
        file.write(b"P5\n24 24\n255\n" + bytes(20 if c else 230 for row in maze for c in row))
    # Of 0.025 m a pixel; the walls are those of localize.world.
    png(HERE / "localize.png",
        map_of(138, 150, 0.025,
               [(0, -1.85, 0, 3.4, 0.05), (0, 1.85, 0, 3.4, 0.05), (-1.7, 0, 90, 3.7, 0.05),
                (1.7, 0, 90, 3.7, 0.05), (0.4, 0.3, 20, 0.9, 0.05), (-0.7, 1.2, -60, 0.6, 0.05),
                (0.6, -1.0, 75, 0.5, 0.05)]))


if __name__ == "__main__":
    main()
