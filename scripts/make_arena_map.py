#!/usr/bin/env python3
"""Makes the course's map of the arena, courses/par/planning/maps/arena.txt, from the world file.

The boxes are those of worlds/syrotek/models/arena.json, with the dynamic ones up that the scenario
course_map raises; dock separators and box 25 are not drawn (specs: syrotek.md B). A cell is a wall
if its middle is no more than half a cell outside a box, seen along the box's own axes: a wall is
one cell wider on either side than what it covers whole. Walls are solid, where the course's own map
had them hollow. 171 x 186 cells of 0.02 m, the first row of the file is the top of the arena.
"""

import json
import math
import pathlib

ROOT = pathlib.Path(__file__).resolve().parent.parent
WIDTH, HEIGHT, CELL = 171, 186, 0.02


def drawn_boxes():
    world = json.loads((ROOT / "worlds/syrotek/models/arena.json").read_text())
    scenario = json.loads((ROOT / "worlds/syrotek/course_map.json").read_text())
    raised = set(scenario["obstacles"]["up"])
    for box in world["boxes"]:
        if box["kind"] == "dock_separator":
            continue
        if world["kinds"][box["kind"]].get("dynamic") and box["id"] not in raised:
            continue
        yield box


def is_wall(boxes, x, y):
    """Whether the cell in column x, row y from the bottom is a wall."""
    for box in boxes:
        yaw = math.radians(box.get("yaw_deg", 0))
        east = (x + 0.5) * CELL - box["x"]
        north = (y + 0.5) * CELL - box["y"]
        along = math.cos(yaw) * east + math.sin(yaw) * north
        across = math.cos(yaw) * north - math.sin(yaw) * east
        # A micrometre for roundings: most edges lie on the lines between cells.
        if (abs(along) <= (box["size"][0] + CELL) / 2 + 1e-6
                and abs(across) <= (box["size"][1] + CELL) / 2 + 1e-6):
            return True
    return False


def main():
    boxes = list(drawn_boxes())
    rows = ["".join("O" if is_wall(boxes, x, y) else "." for x in range(WIDTH))
            for y in reversed(range(HEIGHT))]
    target = ROOT / "courses/par/planning/maps/arena.txt"
    target.write_text(f"{HEIGHT}\n" + "\n".join(rows) + "\n")


main()
