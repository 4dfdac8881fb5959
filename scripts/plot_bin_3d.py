#!/usr/bin/env python3
"""Draws the bin in three dimensions, see scree/bin_3d.py; plot_bin_3d.py -h."""
from scree.bin_3d import main

main()
