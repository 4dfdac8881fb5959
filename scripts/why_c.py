#!/usr/bin/env python3
"""Changes the model of the 1 mm bin step by step, see scree/why_c.py; why_c.py -h."""
from scree.why_c import main

main()
