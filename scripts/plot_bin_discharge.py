#!/usr/bin/env python3
"""Draws the bin discharge, see scree/bin_discharge.py; plot_bin_discharge.py -h."""
from scree.bin_discharge import main

main()
