"""What components of one's own import from MORSE's helpers."""
