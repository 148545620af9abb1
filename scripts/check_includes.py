#!/usr/bin/env python3
"""Checks that includes point only downwards (docs/architecture.md) and that heavy headers stay put.

Prints each include that breaks the layout as FILE:LINE and exits with 1 if there is any.
"""

import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent

# Folder of src/ -> the folders that it may include besides itself. What is not listed is forbidden.
MAY_INCLUDE = {
    "base": [],
    "wire": ["base"],
    "navigation": ["base"],
    "imr-h": ["base"],
    "client/core": ["wire", "base"],
    "client/morse": ["client/core", "wire", "base"],
    "client/player": ["client/morse", "client/core", "navigation", "wire", "base"],
    "assets": ["base"],
    "scene": ["assets", "base"],
    "sim": ["scene", "base"],
    "render": ["sim", "scene", "base"],
    "servers": ["sim", "scene", "navigation", "wire", "base"],
    "in_process": ["servers", "sim", "scene", "wire", "base"],
    # Grades what programs did, from the simulator's records; starts no process itself.
    "grade": ["servers", "sim", "scene", "base"],
    "tools": ["grade", "servers", "render", "sim", "scene", "assets", "wire", "base"],
    # Programs that `ccmorse bench` executes: they measure what it may not include, the client
    # library and Embree itself.
    "bench": ["sim", "base"],
}

# Public headers of the client library by layer (thesis 3.1): a header may include its own layer
# and those before it.
CLIENT_LAYERS = [
    {"MorseError", "Types", "MorseValue", "MorseClient", "MorseRobot", "MorseDevice",
     "Paint"},
    {"MorseSensor", "MorseActuator", "MorsePose", "MorseOdometry", "MorseMotionVW", "MorseLaser",
     "MorseWaypoint", "MorseProperties", "MorseTime", "MorsePen", "MorseArena", "MorseAnswers"},
    {"MorseProxy", "Position2dProxy", "LaserProxy", "GridMap", "WindowProxy", "MorseDriver",
     "SndDriver",
     "PlayerClient"},
    {"CCMorse"},
]

# Which layer of public headers a folder of the client may use.
CLIENT_FOLDER_LAYER = {"client/core": 0, "client/morse": 1, "client/player": 3, "bench": 3}

# Heavy headers and the only files that may include them.
HEAVY = {
    "boost/": r"src/(servers|in_process|client/core)/.*|src/tools/stop_signals\.(h|cpp)"
              r"|src/bench/view_bench\.cpp",
    "embree3/": r"src/sim/rays/embree_scene\.cpp|src/bench/embree_bench\.cpp",
    "btBullet": r"src/sim/physics/rigid_world\.cpp",
    "Bullet": r"src/sim/physics/rigid_world\.cpp",
    "LinearMath/": r"src/sim/physics/rigid_world\.cpp",
    "CLI/": r"src/tools/(main\.cpp|\w+_command\.cpp|(command_line|morse_options)\.(h|cpp))",
    "zip.h": r"src/tools/zip_archive\.cpp",
    "spdlog/": r"src/base/log\.cpp",
    "png.h": r"src/base/image\.cpp|src/assets/picture\.cpp|tests/assets/picture_test\.cpp",
    "jpeglib.h": r"src/assets/picture\.cpp|tests/assets/picture_test\.cpp",
    "zlib.h": r"src/wire/.*\.cpp|src/assets/(gzip|cache)\.cpp|src/bench/view_bench\.cpp",
    "pugixml": r"src/assets/collada\.cpp",
}

# Folders of include/; those of Player's names stand beneath libCCMorse.
PUBLIC = ("ccmorse/", "libCCMorse/", "libPlayer/", "imr-h/", "libplayerc++/", "libplayerc/", "libplayercommon/",
          "libplayercore/", "libplayerinterface/")

INCLUDE = re.compile(r'^\s*#\s*include\s*(["<])([^">]+)[">]')


def folder_of(path):
    """The key of MAY_INCLUDE that a path below src/ belongs to."""
    text = str(path)
    return next((f for f in MAY_INCLUDE if text.startswith(f + "/")), None)


def layer_of(header):
    name = pathlib.PurePath(header).stem
    return next((i for i, names in enumerate(CLIENT_LAYERS) if name in names), None)


def complaint(file, quoted, header):
    """Why `file` may not include `header`; None when it may."""
    relative = file.relative_to(ROOT)
    for heavy, allowed in HEAVY.items():
        if header.startswith(heavy) and not re.fullmatch(allowed, str(relative)):
            return f"{heavy} belongs only in {allowed}"
    if relative.parts[0] == "src":
        here = folder_of(relative.relative_to("src"))
        if here is None:
            return "this folder is not in the map of scripts/check_includes.py"
        there = folder_of(header)
        if there is not None and there != here and there not in MAY_INCLUDE[here]:
            return f"{here} may include only {', '.join(MAY_INCLUDE[here]) or 'itself'}"
        if header.startswith(("libCCMorse/", "libPlayer/")):
            if here not in CLIENT_FOLDER_LAYER:
                return "the simulator does not know the client library"
            if layer_of(header) is None or layer_of(header) > CLIENT_FOLDER_LAYER[here]:
                return f"{here} may not include a header of a layer above its own"
    if relative.parts[0] == "include":
        if quoted and not header.startswith(PUBLIC):
            return "public headers include only public headers"
        if not quoted and re.search(r"[/.]", header) and header != "unistd.h":
            return "public headers include only the standard library"
        if relative.parts[1] == "libCCMorse":
            here, there = layer_of(relative.name), layer_of(header)
            if here is None:
                return "this header is in no layer of scripts/check_includes.py"
            if there is not None and there > here:
                return "a header may not include one of a layer above its own"
    return None


def main():
    wrong = 0
    checked = 0
    for top in ("src", "include"):
        for file in sorted((ROOT / top).rglob("*")):
            if file.suffix not in (".h", ".cpp", ".cc"):
                continue
            checked += 1
            for number, line in enumerate(file.read_text().splitlines(), 1):
                match = INCLUDE.match(line)
                if not match:
                    continue
                why = complaint(file, match.group(1) == '"', match.group(2))
                if why:
                    wrong += 1
                    print(f"{file.relative_to(ROOT)}:{number}: {match.group(2)}: {why}")
    print(f"includes: {checked} files, {wrong} wrong")
    return 1 if wrong or checked == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
