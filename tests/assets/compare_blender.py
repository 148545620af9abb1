#!/usr/bin/env python3
"""Reads MORSE's .blend files independently of CCMorse and writes what they hold as facts.

    python3 compare_blender.py /usr/share/morse/data > morse_data_expected.json

Shapes are read by Blender itself (3.4, Debian's package `blender`), run headless on each file;
what Blender 3.4 no longer knows, physics and game properties, by a reader of a few lines below,
which shares nothing with src/assets. tests/assets/morse_data_test.cpp compares ours with the result.
"""

import gzip
import json
import pathlib
import struct
import subprocess
import sys
import tempfile

IN_BLENDER = """
import bpy, json, sys
facts = {}
for o in bpy.data.objects:
    if o.library is not None:
        continue
    fact = {"type": o.type}
    if o.type == "MESH" and o.data is not None and o.data.library is None:
        points = [o.matrix_world @ v.co for v in o.data.vertices]
        fact["vertices"] = len(points)
        fact["faces"] = len(o.data.polygons)
        if points:
            fact["low"] = [round(min(p[i] for p in points), 4) for i in range(3)]
            fact["high"] = [round(max(p[i] for p in points), 4) for i in range(3)]
    facts[o.name] = fact
with open(sys.argv[-1], "w") as out:
    json.dump(facts, out)
"""


def shapes(path):
    with tempfile.TemporaryDirectory() as folder:
        script = pathlib.Path(folder, "facts.py")
        script.write_text(IN_BLENDER)
        out = pathlib.Path(folder, "facts.json")
        subprocess.run(["blender", "-b", "--factory-startup", "-noaudio", str(path), "--python",
                        str(script), "--", str(out)], check=True, stdout=subprocess.DEVNULL,
                       stderr=subprocess.DEVNULL)
        return json.loads(out.read_text())


class Blend:
    """Just enough of the format: blocks, and members of structs by name."""

    def __init__(self, path):
        data = path.read_bytes()
        self.data = data = gzip.decompress(data) if data[:2] == b"\x1f\x8b" else data
        self.wide = data[7:8] == b"-"
        self.order = "<" if data[8:9] == b"v" else ">"
        head = self.order + ("4siQii" if self.wide else "4siIii")
        at = 12
        self.blocks = []
        while True:
            code, size, address, kind, count = struct.unpack_from(head, data, at)
            at += struct.calcsize(head)
            if code == b"ENDB":
                break
            if code == b"DNA1":
                self.describe(data[at:at + size])
            self.blocks.append((code.rstrip(b"\0"), address, kind, at, size))
            at += size

    def describe(self, dna):
        at = 8

        def number(form):
            nonlocal at
            value, = struct.unpack_from(self.order + form, dna, at)
            at += struct.calcsize(form)
            return value

        def texts():
            nonlocal at
            found = []
            for _ in range(number("i")):
                end = dna.index(b"\0", at)
                found.append(dna[at:end].decode())
                at = end + 1
            at = (at + 3) // 4 * 4 + 4
            return found

        names, types = texts(), texts()
        lengths = [number("H") for _ in types]
        at = (at + 3) // 4 * 4 + 4
        self.structs = []
        for _ in range(number("i")):
            kind, count = number("H"), number("H")
            members, offset = {}, 0
            for _ in range(count):
                member, name = number("H"), names[number("H")]
                size = (8 if self.wide else 4) if name[0] in "*(" else lengths[member]
                plain, _, rest = name.lstrip("*").partition("[")
                members[plain] = (offset, types[member] if name[0] != "*" else "*")
                for part in rest.rstrip("]").split("]["):
                    size *= int(part) if part else 1
                offset += size
            self.structs.append((types[kind], members))

    def value(self, kind, base, *path):
        """A number of the struct at `base`, through nested structs."""
        for name in path:
            if name not in self.structs[kind][1]:
                return None
            offset, member = self.structs[kind][1][name]
            base += offset
            form = {"int": "i", "short": "h", "char": "b", "float": "f",
                    "*": "Q" if self.wide else "I"}.get(member)
            if form:
                return struct.unpack_from(self.order + form, self.data, base)[0]
            kind = next(i for i, s in enumerate(self.structs) if s[0] == member)
        return base

    def text(self, at):
        return self.data[at:self.data.index(b"\0", at)].decode("utf-8", "replace")


def physics(path):
    blend = Blend(path)
    facts = {}
    for i, (code, _, kind, at, _) in enumerate(blend.blocks):
        if code != b"OB" or blend.structs[kind][0] != "Object":
            continue
        def get(*path):
            return blend.value(kind, at, *path)
        flags = get("gameflag")
        if not flags >> 16 & 1:
            shape = "OCCLUDER" if flags >> 18 & 1 else "NO_COLLISION"
        elif flags >> 22 & 1:
            shape = "CHARACTER"
        elif flags >> 19 & 1:
            shape = "SENSOR"
        elif flags >> 20 & 1:
            shape = "NAVMESH"
        elif not flags & 1:
            shape = "STATIC"
        elif flags >> 17 & 1:
            shape = "SOFT_BODY"
        else:
            shape = "RIGID_BODY" if flags >> 10 & 1 else "DYNAMIC"
        bounds = get("collision_boundtype")
        if bounds is None:
            bounds = get("boundtype")
        here = {}
        for code2, address, kind2, at2, _ in blend.blocks[i + 1:]:
            if code2 != b"DATA":
                break
            here[address] = (kind2, at2)
        properties = []
        prop = get("prop", "first")
        while prop:
            kind2, at2 = here[prop]
            properties.append(blend.text(at2 + blend.structs[kind2][1]["name"][0]))
            prop = blend.value(kind2, at2, "next")
        name = blend.text(at + blend.structs[kind][1]["id"][0] + next(
            s for s in blend.structs if s[0] == "ID")[1]["name"][0])[2:]
        facts[name] = {"physics": shape, "mass": round(get("mass"), 4),
                       "radius": round(get("inertia"), 4), "bounds": bounds if flags >> 11 & 1
                       else -1, "properties": properties}
    return facts


def main():
    root = pathlib.Path(sys.argv[1])
    lines = []
    for path in sorted(root.rglob("*.blend")):
        print(path, file=sys.stderr)
        seen, known = shapes(path), physics(path)
        objects = []
        for name in sorted(known):
            shape, body = seen.get(name, {"type": "?"}), known[name]
            objects.append([name, shape["type"], shape.get("vertices", 0), shape.get("faces", 0),
                            shape.get("low", []), shape.get("high", []), body["physics"],
                            body["mass"], body["radius"], body["bounds"], body["properties"]])
        extra = sorted(set(seen) - set(known))
        if extra:
            print("  only in Blender:", extra, file=sys.stderr)
        lines.append(json.dumps(str(path.relative_to(root))) + ": [\n" +
                     ",\n".join(json.dumps(o, separators=(",", ":")) for o in objects) + "]")
    print("{\n" + ",\n".join(lines) + "\n}")


if __name__ == "__main__":
    main()
