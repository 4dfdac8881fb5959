#!/usr/bin/env python3
"""Reference data of bins by discrete elements, see scree/discrete_elements.py; discrete_elements.py -h."""
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from scree.discrete_elements import main  # noqa: E402

main()
