#!/usr/bin/env python3
"""Draws fields of any plane run at several times, see scree/guide.py; plot_guide.py -h."""
from scree.guide import main

main()
