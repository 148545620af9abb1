#!/usr/bin/env python3
"""Makes a test of methods.txt: generate.py methods.txt OUT.cpp

Each method is looked up with exactly the type that its line has, which fails to compile where the library
has another or none, and called once.
"""

import pathlib
import re
import sys

CLASSES, METHODS = 44, 524  # of player.md A.4

# What an argument of a type is, where its zero is not enough.
VALUES = {
    "char*": "text.data()", "const char*": '"name"', "bool*": "&flag", "int32_t*": "&integer",
    "double*": "&number", "char**": "&given", "double&": "number", "void*": "buffer.data()",
    "size_t": "4", "uint8_t*": "buffer.data()", "int8_t*": "cells.data()",
    "player_point_2d_t[]": "points2.data()", "player_point_3d_t[]": "points3.data()",
    "double[3]": "numbers.data()", "double[6]": "numbers.data()",
    "player_opaque_data_t*": "&opaque", "player_audio_seq_t*": "&tones",
    "player_audio_mixer_channel_list_t*": "&levels", "const player_blackboard_entry_t&": "entry",
    "std::string": '"/tmp"', "const std::string": "prefix",
    "void(*)(playerc_blackboard_t*,player_blackboard_entry_t)": "nullptr",
    "player_graphics3d_draw_mode_t": "PLAYER_DRAW_POINTS", "std::vector<float>": "{1.0F}",
    "PlayerClient*": "&client",
}


# Interfaces that are not called as their proxies.
INTERFACES = {"LinuxjoystickProxy": "joystick", "SpeechRecognitionProxy": "speech_recognition"}


def parse(signature):
    """(return type, name, argument types, const) of a method."""
    if "on_blackboard_event" in signature:
        handler = "void(*)(playerc_blackboard_t*,player_blackboard_entry_t)"
        return "void", "SetEventHandler", [handler], False
    text = re.sub(r"operator ?\[\]", "operator_index", signature)
    match = re.fullmatch(r"(?:(.*?)[ ]?)??([\w]+) ?\((.*)\)( const)?", text)
    result, name, arguments, const = match.groups()
    types = []
    for argument in filter(None, (part.strip() for part in arguments.split(","))):
        argument = argument.split("=")[0].strip()
        if argument == "void":
            continue
        pieces = re.fullmatch(r"(.*?)\s*(\w+)?(\[\d*\])?", argument)
        kind, last, array = pieces.groups()
        if not kind:  # a type without a name
            kind = last
        types.append(re.sub(r"\s*([*&])\s*", r"\1", kind.strip()) + (array or ""))
    result = re.sub(r"\s*([*&])\s*", r"\1", (result or "").strip())
    return result, name.replace("operator_index", "operator[]"), types, bool(const)


def value(kind):
    if kind in VALUES:
        return VALUES[kind]
    return f"{kind}{{}}" if re.fullmatch(r"\w+", kind) else "{}"


def main():
    table, out = map(pathlib.Path, sys.argv[1:])
    classes, current = [], None
    for line in table.read_text().splitlines():
        if line.startswith("class "):
            _, name, count = line.split()
            current = (name, int(count), [])
            classes.append(current)
        elif line.startswith("  "):
            current[2].append(line.strip())
    total = sum(len(signatures) for _, _, signatures in classes)
    if (len(classes), total) != (CLASSES, METHODS):
        sys.exit(f"{table}: {len(classes)} classes, {total} methods, not {CLASSES} and {METHODS}")
    text = ["// Made by tests/client/playerc/generate.py of methods.txt: edit those.", "",
            '#include "tests/client/playerc/calls.h"', "",
            "namespace ccmorse::test {", ""]
    for name, count, signatures in classes:
        if len(signatures) != count:
            sys.exit(f"{table}: class {name} has {len(signatures)} methods, not {count}")
        proxy = name.endswith("Proxy") and name != "ClientProxy"
        text += [f"TEST_F(PlayerMethods, {name}) {{"]
        if proxy:
            text += [f"  static_assert(std::is_base_of_v<ClientProxy, {name}>);",
                     f"  auto object = std::make_unique<{name}>(&client, 0U);",
                     f'  EXPECT_EQ(object->GetInterfaceStr(), "{INTERFACES.get(name, name[:-5].lower())}");']
        elif name == "ClientProxy":
            text += ["  auto object = std::unique_ptr<ClientProxy>(new LaserProxy(&client));"]
        elif name == "PlayerClient":
            text += ["  auto object = std::make_unique<PlayerClient>(\"localhost\", server.port());",
                     "  object->SetDataMode(PLAYER_DATAMODE_PULL);"]
        else:
            text += ['  auto object = std::make_unique<PlayerError>("fun", "text", 7);']
        calls = 0
        for signature in signatures:
            calls += 1
            if "ConnectReadSignal(T" in signature:
                text += ["  Call([&] { return object->ConnectReadSignal([] {}); });"]
                continue
            result, method, types, const = parse(signature)
            arguments = ", ".join(value(kind) for kind in types)
            if method == name:  # a constructor
                if name == "PlayerClient":
                    arguments = '"localhost", server.port(), PLAYERC_TRANSPORT_TCP'
                text += [f"  Call([&] {{ const {name} made({arguments}); }});"]
                continue
            plain = [re.sub(r"^const (std::string)$", r"\1", kind) for kind in types]
            pointer = f"{result} ({name}::*)({', '.join(k.replace('[]', '*').replace('[3]', '*').replace('[6]', '*') for k in plain)}){' const' if const else ''}"
            text += [f"  {{ [[maybe_unused]] constexpr auto kMethod = static_cast<{pointer}>(&{name}::{method}); }}"]
            if name == "PlayerClient" and method == "Run":
                text += ["  Call([&] { RunAndStop(*object); });"]
                continue
            if name == "PlayerClient" and method == "Read":
                text += ["  Feed();"]
            if name == "PlayerClient":
                arguments = arguments.replace("uint32_t{}", "5U")
            text += [f"  Call([&] {{ return (*object).{method}({arguments}); }});"]
        text += [f"  EXPECT_EQ(called, {count});", "}", ""]
        assert calls == count
    text += ["}  // namespace ccmorse::test"]
    out.write_text("\n".join(text) + "\n")


if __name__ == "__main__":
    main()
