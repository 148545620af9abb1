#! /usr/bin/env python3
"""Scenes that cannot be, as MORSE's users test them."""

from morse.testing.testing import MorseBuilderFailureTestCase, main

try:
    from morse.builder import *
except ImportError:
    pass


class NoEnvironment(MorseBuilderFailureTestCase):
    def setUpEnv(self):
        robot = ATRV()
        env = Environment('i_do_not_exist')

    def test_initialization(self):
        pass


class NoName(MorseBuilderFailureTestCase):
    def setUpEnv(self):
        robot = ATRV('a.robot')
        env = Environment('empty')

    def test_initialization(self):
        pass


if __name__ == "__main__":
    main(NoEnvironment, NoName)
