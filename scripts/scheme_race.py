#!/usr/bin/env python3
"""The time schemes against each other, see scree/scheme_race.py; scheme_race.py -h."""
from scree.scheme_race import main

main()
