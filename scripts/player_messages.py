#!/usr/bin/env python3
"""Makes the C++ of Player's messages from src/wire/player/interfaces.def.

  scripts/player_messages.py           writes the two headers
  scripts/player_messages.py --check   says which of them is not up to date, exit status 1 if any

src/wire/player/messages.h holds them for our own code; player_interfaces.h is Player's C header.
"""

import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
TABLE = ROOT / "src/wire/player/interfaces.def"
MESSAGES = ROOT / "src/wire/player/messages.h"
C_HEADER = ROOT / "include/libplayerinterface/player_interfaces.h"

SCALARS = {
    "u8": "std::uint8_t", "u16": "std::uint16_t", "u32": "std::uint32_t", "i8": "std::int8_t",
    "i16": "std::int16_t", "i32": "std::int32_t", "i64": "std::int64_t", "f32": "double",
    "f64": "double",
}
C_SCALARS = {**SCALARS, "f32": "float"}
TYPES = {"data": 1, "cmd": 2, "req": 3, "synch": 5}
WARNING = "// Made by scripts/player_messages.py from src/wire/player/interfaces.def: edit that.\n"


class Field:
    def __init__(self, name, kind):
        self.name = name
        match = re.fullmatch(r"(\w+)(?:\[(<?)(\d*)\])?", kind)
        if not match:
            raise SystemExit(f"{TABLE}: cannot read the type '{kind}' of {name}")
        self.element, limit, number = match.groups()
        self.array = "[" in kind
        self.most = int(number) if limit else None  # counted, at most so many
        self.fixed = int(number) if self.array and not limit and number else None
        self.counted = self.array and self.fixed is None


class Table:
    def __init__(self):
        self.items = []  # ("struct", name, fields) | ("interface", name, code) | ...
        current = None
        for line in TABLE.read_text().splitlines():
            line = line.split("#")[0].rstrip()
            if not line:
                continue
            words = line.split()
            if line.startswith("  "):
                if current[0] == "struct" and words[0] != "@count":
                    current[2].append(Field(words[0], words[1]))
                elif current[0] == "struct":
                    current[2].append(("count", words[1]))
                else:
                    current[2].append(words[0])
                continue
            if words[0] in ("struct", "enum"):
                current = (words[0], words[1], [])
            elif words[0] == "interface":
                current = ("interface", words[1], int(words[2]))
            elif words[0] == "const":
                current = ("const", words[1], words[2])
            elif words[0] in TYPES:
                current = ("message", words[0], int(words[1]), words[2], words[3])
            else:
                raise SystemExit(f"{TABLE}: unknown word '{words[0]}'")
            self.items.append(current)


def camel(name):
    return "".join(part[0].upper() + part[1:] for part in name.lower().split("_"))


def cpp_type(field):
    if field.element == "chars":
        return "std::string"
    element = SCALARS.get(field.element, camel(field.element))
    if field.fixed is not None:
        return f"std::array<{element}, {field.fixed}>"
    return f"std::vector<{element}>" if field.array else element


def uses(table):
    """Struct -> what it is the body of, for its comment."""
    found = {}
    interface = None
    for item in table.items:
        if item[0] == "interface":
            interface = item
        elif item[0] == "message" and item[4] != "-":
            found.setdefault(item[4], []).append(f"{interface[1]} {item[1].upper()} {item[3]}")
    return found


def messages_h(table):
    out = ["#pragma once\n\n", WARNING, """
#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace ccmorse::wire::player {

// Each struct is the body of messages; Fields() hands its fields, in the order of the wire, to a
// writer or a reader (xdr.h). m, rad, s, V unless the interface says otherwise. What is a float on
// the wire is a double here.
// NOLINTBEGIN(readability-identifier-naming,readability-magic-numbers)

"""]
    bodies = uses(table)
    for item in table.items:
        if item[0] == "interface":
            out.append(f"// --- {item[1]}\n\n")
            out.append(f"inline constexpr std::uint16_t k{camel(item[1])} = {item[2]};\n\n")
            interface = item[1]
        elif item[0] == "message":
            name = f"k{camel(interface)}{camel(item[1])}{camel(item[3])}"
            out.append(f"inline constexpr std::uint8_t {name} = {item[2]};\n")
        elif item[0] == "struct":
            _, name, fields = item
            out.append(f"\n/// {', '.join(bodies[name])}.\n" if name in bodies else "\n")
            out.append(f"struct {camel(name)} {{\n")
            early = {field[1] for field in fields if isinstance(field, tuple)}
            lines = []
            for field in fields:
                if isinstance(field, tuple):
                    lines.append(f"xdr.Count(m.{field[1]});")
                    continue
                plain = not field.array and field.element in SCALARS
                initial = " = 0" if plain else "{}" if field.fixed is not None else ""
                out.append(f"  {cpp_type(field)} {field.name}{initial};\n")
                if field.counted and field.name not in early:
                    lines.append(f"xdr.Count(m.{field.name});")
                most = f", {field.most}" if field.most is not None else ""
                # Floats of the wire are doubles in memory, so that nothing is lost within a program.
                single = "Single" if field.element == "f32" else ""
                call = (single + "Items" if field.counted else single or "Value")
                lines.append(f"xdr.{call}(m.{field.name}{most});")
            out.append("\n  template <typename Self, typename Xdr>\n")
            out.append("  static void Fields(Self& m, Xdr& xdr) {\n")
            out.extend(f"    {line}\n" for line in lines)
            out.append("  }\n")
            out.append(f"  bool operator==(const {camel(name)}&) const = default;\n}};\n\n")
    out.append("""
// NOLINTEND(readability-identifier-naming,readability-magic-numbers)

/// PLAYER_MESSAGE(interface, code, type, subtype, name, body) for each message that has a body;
/// PLAYER_INTERFACE(name, code) for each interface.
""")
    rows = []
    names = []
    for item in table.items:
        if item[0] == "interface":
            interface, code = item[1], item[2]
            names.append(f"  PLAYER_INTERFACE({interface}, {code})")
        elif item[0] == "message" and item[4] != "-":
            rows.append(f"  PLAYER_MESSAGE({interface}, {code}, {TYPES[item[1]]}, {item[2]}, "
                        f"{item[3]}, {camel(item[4])})")
    out.append("// NOLINTBEGIN(cppcoreguidelines-macro-usage): lists for tables\n")
    out.append("#define CCMORSE_PLAYER_MESSAGES \\\n" + " \\\n".join(rows) + "\n\n")
    out.append("#define CCMORSE_PLAYER_INTERFACES \\\n" + " \\\n".join(names) + "\n")
    out.append("// NOLINTEND(cppcoreguidelines-macro-usage)\n\n")
    out.append("}  // namespace ccmorse::wire::player\n")
    return "".join(out)


def c_header(table):
    out = ["#pragma once\n\n", WARNING, """
// Player's structs and constants under their own names, for programs that use them (specs:
// player.md A.1). Counted arrays are a count and a pointer; whoever makes one owns what it points
// to. Units: m, rad, s, V, A, W unless an interface says otherwise.

#include <cstddef>
#include <cstdint>

// NOLINTBEGIN(modernize-use-using,cppcoreguidelines-macro-usage,modernize-macro-to-enum)

#define PLAYER_MSGTYPE_DATA 1
#define PLAYER_MSGTYPE_CMD 2
#define PLAYER_MSGTYPE_REQ 3
#define PLAYER_MSGTYPE_RESP_ACK 4
#define PLAYER_MSGTYPE_SYNCH 5
#define PLAYER_MSGTYPE_RESP_NACK 6

#define PLAYER_MAX_DRIVER_STRING_LEN 64
#define PLAYER_MAX_DEVICES 4096
#define PLAYER_KEYLEN 32

#define PLAYER_CAPABILTIES_REQ 255
#define PLAYER_GET_INTPROP_REQ 254
#define PLAYER_SET_INTPROP_REQ 253
#define PLAYER_GET_DBLPROP_REQ 252
#define PLAYER_SET_DBLPROP_REQ 251
#define PLAYER_GET_STRPROP_REQ 250
#define PLAYER_SET_STRPROP_REQ 249
#define PLAYER_GET_BOOLPROP_REQ 248
#define PLAYER_SET_BOOLPROP_REQ 247

"""]
    interface = ""
    for item in table.items:
        if item[0] == "interface":
            interface = item[1].upper()
            out.append(f"\n#define PLAYER_{interface}_CODE {item[2]}\n")
            out.append(f"#define PLAYER_{interface}_STRING \"{item[1]}\"\n")
        elif item[0] == "message":
            out.append(f"#define PLAYER_{interface}_{item[1].upper()}_{item[3]} {item[2]}\n")
        elif item[0] == "const":
            out.append(f"#define PLAYER_{item[1]} {item[2]}\n")
        elif item[0] == "enum":
            members = ",\n".join(f"  PLAYER_{name}" for name in item[2])
            out.append(f"\ntypedef enum player_{item[1]} {{\n{members}\n}} player_{item[1]}_t;\n")
        else:
            out.append(c_struct(item))
    out.append("\n// NOLINTEND(modernize-use-using,cppcoreguidelines-macro-usage,"
               "modernize-macro-to-enum)\n")
    return "".join(out)


def c_struct(item):
    _, name, fields = item
    out = [f"\ntypedef struct player_{name} {{\n"]
    early = {field[1] for field in fields if isinstance(field, tuple)}
    for field in fields:
        if isinstance(field, tuple):
            out.append(f"  std::uint32_t {field[1]}_count;\n")
            continue
        if field.element == "chars":
            kind = "char"
        else:
            kind = C_SCALARS.get(field.element, f"player_{field.element}_t")
        if field.counted and field.name not in early:
            out.append(f"  std::uint32_t {field.name}_count;\n")
        number = field.fixed if field.fixed is not None else field.most
        if number is not None:
            out.append(f"  {kind} {field.name}[{number}];\n")
        else:
            out.append(f"  {kind}{'* ' if field.array else ' '}{field.name};\n")
    out.append(f"}} player_{name}_t;\n")
    return "".join(out)


def formatted(text, path):
    return subprocess.run(["clang-format", f"--assume-filename={path}"], input=text,
                          capture_output=True, text=True, check=True, cwd=ROOT).stdout


def main():
    table = Table()
    stale = 0
    for path, text in ((MESSAGES, messages_h(table)), (C_HEADER, c_header(table))):
        text = formatted(text, path)
        if "--check" in sys.argv[1:]:
            if not path.exists() or path.read_text() != text:
                print(f"{path.relative_to(ROOT)} is not what scripts/player_messages.py makes")
                stale = 1
        else:
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text)
    return stale


if __name__ == "__main__":
    sys.exit(main())
