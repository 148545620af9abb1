"""What builder scripts and tests import from MORSE's core."""
