#!/usr/bin/env python3
"""Draws the bin of Anand et al. (2008), see scree/silo_anand.py; plot_silo_anand.py -h."""
from scree.silo_anand import main

main()
