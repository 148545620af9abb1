"""MORSE's Python packages, as far as they make sense outside of Blender (docs/morse.md)."""

__version__ = "1.4"
