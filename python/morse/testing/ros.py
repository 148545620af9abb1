"""Tests that want ROS, which the simulator does not speak."""

import unittest

from morse.testing.testing import MorseTestCase


class RosTestCase(MorseTestCase):
    """Is skipped: the simulator has services and streams over sockets only."""

    def setUpMw(self):
        raise unittest.SkipTest("ros is not there: socket is (docs/morse.md)")
