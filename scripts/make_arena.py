#!/usr/bin/env python3
"""Writes worlds/syrotek/models/arena.json from a list of measured boxes.

The list is a JSON array with one object a box: id, cls (border, dock_separator, static,
dynamic_slab or dynamic_pillar), x, y, yaw_deg, size_x, size_y; metres and degrees. What a list of
boxes does not say - heights, colours, docks, lamps - is set below.

Usage: make_arena.py BOXES.json > worlds/syrotek/models/arena.json
"""

import json
import sys

# Height of all that stands in the arena: "about 16 cm" (thesis 4.1.1). Only the dock separators are
# known to be lower. Colours: brown, light grey and red, as the thesis says.
KINDS = {
    "border": {"height": 0.16, "color": "#7a4a1e"},
    "dock_separator": {"height": 0.13, "color": "#7a4a1e"},
    "static": {"height": 0.16, "color": "#a0a0a0"},
    "dynamic_slab": {"height": 0.16, "color": "#d62828", "dynamic": True, "raised": False},
    "dynamic_pillar": {"height": 0.16, "color": "#d62828", "dynamic": True, "raised": False},
}

# Thirteen bays along the top border, 0.18 m deep; a parked robot faces out of its bay.
DOCKS = [{"x": round(0.15 + 0.26 * k, 2), "y": 3.59, "yaw_deg": -90.0} for k in range(13)]

# Four spotlights and a sun that casts all shadows in one direction (thesis 4.1.1). Where the lamps
# hung is not written down: here one hangs above each quarter of the floor.
LIGHTS = [{"kind": "sun", "position": [-2.0, 3.0, 8.0], "energy": 1.0, "shadows": True}] + [
    {"kind": "spot", "position": [x, y, 2.5], "energy": 0.5, "shadows": False}
    for y in (0.93, 2.79)
    for x in (0.855, 2.565)
]


def box_line(box):
    yaw = f'"yaw_deg": {box["yaw_deg"]:g}, ' if box["yaw_deg"] else ""
    return (
        f'{{"id": {box["id"]}, "kind": "{box["cls"]}", "x": {box["x"]:g}, "y": {box["y"]:g}, '
        f'{yaw}"size": [{box["size_x"]:g}, {box["size_y"]:g}]}}'
    )


def listing(lines):
    return "[\n    " + ",\n    ".join(lines) + "\n  ]"


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    with open(sys.argv[1], encoding="utf-8") as file:
        boxes = sorted(json.load(file), key=lambda box: box["id"])
    kinds = ",\n    ".join(f'"{name}": {json.dumps(look)}' for name, look in KINDS.items())
    print(
        "{\n"
        '  "name": "syrotek",\n'
        '  "size": [3.42, 3.72],\n'
        '  "floor": "#ffffff",\n'
        f'  "kinds": {{\n    {kinds}\n  }},\n'
        f'  "boxes": {listing(map(box_line, boxes))},\n'
        f'  "docks": {listing(map(json.dumps, DOCKS))},\n'
        f'  "lights": {listing(map(json.dumps, LIGHTS))}\n'
        "}"
    )


if __name__ == "__main__":
    main()
