"""Tests of scenes, as MORSE's users write them (docs/morse.md). Importing this package also lets
pymorse run with today's Python."""

from morse.testing import pymorse_shim

pymorse_shim.install()
