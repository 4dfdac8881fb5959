"""The package installs from the checkout with Debian's pip and no network, and brings its commands."""
import importlib.util
import os
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import made_up

SCRIPTS = Path(__file__).resolve().parents[2] / "scripts"
WANTED = ("pip", "setuptools", "wheel")


@unittest.skipUnless(all(map(importlib.util.find_spec, WANTED)), "no pip, setuptools or wheel")
class Install(unittest.TestCase):
    def test_the_installed_package_makes_a_report(self):
        with tempfile.TemporaryDirectory() as place:
            place = Path(place)
            source, target = place / "scripts", place / "installed"
            shutil.copytree(SCRIPTS, source)  # pip leaves files beside the source
            words = [sys.executable, "-m", "pip", "install", "--no-build-isolation", "--no-index", "--no-deps",
                     "--target", str(target), str(source)]
            process = subprocess.run(words, capture_output=True, text=True)
            self.assertEqual(process.returncode, 0, process.stdout + process.stderr)
            run = made_up.write_run(place / "made_up")
            environment = {**os.environ, "PYTHONPATH": str(target)}
            subprocess.run([target / "bin" / "scree-report", run], env=environment, check=True, stdout=subprocess.DEVNULL)
            self.assertTrue((run / "report.html").exists())
            said = subprocess.run([target / "bin" / "scree-sweep", "-h"], env=environment, capture_output=True, text=True)
            self.assertIn("scree-sweep CASE", said.stdout)


if __name__ == "__main__":
    unittest.main()
