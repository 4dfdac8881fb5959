#!/usr/bin/env python3
"""Errors in time against the accuracy asked for, see scree/accuracy.py; accuracy.py -h."""
from scree.accuracy import main

main()
