#!/usr/bin/env python3
"""Draws the rising bubble, see scree/bubble_rise.py; plot_bubble_rise.py -h."""
from scree.bubble_rise import main

main()
