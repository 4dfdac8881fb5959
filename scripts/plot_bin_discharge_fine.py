#!/usr/bin/env python3
"""Draws the discharge of fine particles, see scree/bin_discharge_fine.py; plot_bin_discharge_fine.py -h."""
from scree.bin_discharge_fine import main

main()
