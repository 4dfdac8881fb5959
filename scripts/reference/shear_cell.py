#!/usr/bin/env python3
"""Reference data of the friction of spheres, see scree/shear_cell.py; shear_cell.py -h."""
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from scree.shear_cell import main  # noqa: E402

main()
