"""Where the user's script is, and what of it the simulation does without."""

import os
import sys

_HERE = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))  # of all of morse

notes = []  # of Note, in order


def is_ours(file):
    """Is a file of code part of this package?"""
    return os.path.abspath(file).startswith(_HERE + os.sep) or file.startswith("<frozen")


def user_place(of=None):
    """(file, line) that the user's code has come to; outside of the constructors of object `of`."""
    frame = sys._getframe(1)
    while frame is not None:
        file = frame.f_code.co_filename
        constructs = (of is not None and frame.f_code.co_name == "__init__" and
                      frame.f_locals.get("self") is of)
        if not constructs and not is_ours(file) and not file.startswith("<"):
            return os.path.abspath(file), frame.f_lineno
        frame = frame.f_back
    return "", 0


class Note:
    """Something that a script asks for and the run has not."""

    def __init__(self, place, text, matters=True):
        self.place = place
        self.text = text
        self.matters = matters  # else it is about how Blender looks

    def to_json(self):
        return {"file": self.place[0], "line": self.place[1], "text": self.text,
                "matters": self.matters}


def note(text, place=None, matters=True):
    """Remembers it, once a place."""
    place = place or user_place()
    if not any(known.place == place and known.text == text for known in notes):
        notes.append(Note(place, text, matters))
