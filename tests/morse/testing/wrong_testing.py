#! /usr/bin/env python3
"""Tests that fail, so that their failure is seen to be told."""

from morse.testing.testing import MorseBuilderFailureTestCase, MorseTestCase, main

try:
    from morse.builder import *
except ImportError:
    pass


class WrongPlace(MorseTestCase):
    def setUpEnv(self):
        robot = ATRV()
        env = Environment('empty', fastmode=True)

    def test_wrong(self):
        self.assertEqual(1, 2)


class GoodScene(MorseBuilderFailureTestCase):
    def setUpEnv(self):
        robot = ATRV()
        env = Environment('empty', fastmode=True)

    def test_initialization(self):
        pass


class BadScene(MorseTestCase):
    def setUpEnv(self):
        robot = ATRV()
        env = Environment('i_do_not_exist')

    def test_nothing(self):
        pass


if __name__ == "__main__":
    main(WrongPlace, GoodScene, BadScene)
