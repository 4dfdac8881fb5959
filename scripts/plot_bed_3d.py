#!/usr/bin/env python3
"""Draws the fluidised bed in three dimensions, see scree/bed_3d.py; plot_bed_3d.py -h."""
from scree.bed_3d import main

main()
