"""The report of a run: what stands in it, that it needs nothing else, and what a browser makes of it."""
import base64
import io
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import made_up
import numpy as np
from PIL import Image

import scree
from scree import report, report_figures

SCRIPTS = Path(__file__).resolve().parents[2] / "scripts"
CHROMIUM = shutil.which("chromium")
FLAGS = ["--headless", "--no-sandbox", "--disable-gpu", "--disable-background-networking", "--disable-sync",
         "--no-first-run", "--hide-scrollbars", "--virtual-time-budget=10000"]


def report_of(directory, *arguments):
    """Makes the report by its command; the process."""
    words = [sys.executable, str(SCRIPTS / "scree-report"), str(directory), *map(str, arguments)]
    return subprocess.run(words, capture_output=True, text=True)


def decoded(uri):
    """The picture of a data URI."""
    return Image.open(io.BytesIO(base64.b64decode(uri.split(",")[1])))


class Place(unittest.TestCase):
    def setUp(self):
        place = tempfile.TemporaryDirectory(ignore_cleanup_errors=True)  # a browser may still write its profile
        self.addCleanup(place.cleanup)
        self.place = Path(place.name)

    def page(self, **more):
        """The report of a made-up run."""
        return report.write(made_up.write_run(self.place / "made_up", **more)).read_text()


class Content(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        with tempfile.TemporaryDirectory() as place:
            cls.text = report.write(made_up.write_run(Path(place) / "made_up")).read_text()

    def says(self, text, pattern):
        """Without the whole page in the message."""
        self.assertTrue(re.search(pattern, text), f"nowhere in the page: {pattern}")

    def test_all_sections_are_there(self):
        self.assertEqual(re.findall(r"<h2>(.*?)</h2>", self.text), list(report.SECTIONS))

    def test_it_is_one_file(self):
        text = self.text
        links = re.findall(r"""(?:src|href)=['"]?([^'" >]+)""", text)
        self.assertTrue(links)
        self.assertEqual([link for link in links if not link.startswith(("data:", "#"))], [])
        self.assertEqual(re.findall(r"@import|url\((?!#)|fetch\(|https?://(?!www\.w3\.org)", text), [])

    def test_it_tells_how_the_run_ended_and_what_it_took(self):
        text = self.text
        self.says(text, "The run reached its end time.")
        self.says(text, "It simulated 0.4 s of 0.4 s")
        self.says(text, r"That took 2 s on 1\s+rank, 1.9 CPU seconds")
        self.says(text, r"steps rejected: local error above the accuracy</td><td class=number>1<")
        self.says(text, r"<td>0.2</td><td class=number>1</td><td>local error above the accuracy")
        self.says(text, r"Newton iterations of a step, mean</td><td class=number>3<")

    def test_quantities_have_their_range_and_mean(self):
        # discharge_rate = 2 t: 0.8 at the end, 0.6 as the mean of 0.2 s to 0.4 s
        self.says(self.text, r"<td>discharge rate</td><td>kg/s</td><td class=number>0.8</td>"
                                      r"<td class=number>0</td><td class=number>0.8</td><td class=number>0.6</td>")

    def test_remarks_are_what_the_program_said_beside_its_progress(self):
        remarks = self.text.split("<h2>Remarks and warnings</h2>")[1].split("</section>")[0]
        self.assertIn("friction_model &lt;none&gt;", remarks)
        self.assertIn("solver multigrid from here on", remarks)
        self.assertNotIn("step 4", remarks)

    def test_sampled_lines_are_drawn(self):
        self.says(self.text, "<h3>axis of bin: solids fraction</h3><svg")

    def test_the_case_is_in_it(self):
        self.says(self.text, "plate_floor_openings: &quot;0, 0.02&quot;")

    def test_phases_add_up(self):
        # Clocked by the wall, 2 s; 1.9 s of it were ours: 0.95 (0.4 + 0.5 + 0.3). The negative part counts as none.
        self.says(self.text, r"everything else</td><td class=number>0.76<")
        self.says(self.text, r"solution of the linear systems</td><td class=number>0<")


class OtherRuns(Place):
    def test_a_run_that_was_killed_has_a_report(self):
        text = self.page(ended=False)
        self.assertEqual(text.count("The run has not ended"), 1)
        self.assertEqual(text.count("<section"), len(report.SECTIONS))

    def test_other_dimensions(self):
        self.assertEqual(self.page(dimension=1).count("<img"), 0)
        shutil.rmtree(self.place / "made_up")
        self.assertEqual(self.page(dimension=3).count("half way along z"), 1)

    def test_the_command_writes_it_where_it_is_told(self):
        process = report_of(made_up.write_run(self.place / "made_up", dimension=1), "-o", self.place / "page.html")
        self.assertEqual((process.returncode, process.stdout), (0, f"Report: {self.place / 'page.html'}\n"))
        self.assertTrue((self.place / "page.html").exists())

    def test_no_run_is_one_line(self):
        process = report_of(self.place)
        self.assertEqual((process.returncode, process.stderr.count("\n")), (1, 1))
        self.assertIn("holds no run", process.stderr)


class Frames(Place):
    def test_long_runs_show_some_of_their_times(self):
        run = scree.open(made_up.write_run(self.place / "made_up", times=np.linspace(0, 0.4, 101)))
        text = report.fields_in_time(run)
        self.assertEqual(text.count("<img"), report_figures.FRAMES * 3)
        times = re.search(r"data-times='(.*?)'", text)[1].split()
        self.assertEqual((len(times), times[0], times[-1]), (report_figures.FRAMES, "0", "0.4"))

    def test_a_frame_has_the_colours_of_its_cells(self):
        run = scree.open(made_up.write_run(self.place / "made_up"))
        shown = report_figures.animation(run, "solids_fraction", run.times)
        image = decoded(shown.frames[1])
        self.assertEqual(max(image.size), report_figures.PIXELS)
        # Cells along x: 1/6, 2/6 and 3/6 of the width; 254 shades from 0 to solids_fraction_max.
        for place, x in ((0.02, 0.005), (0.3, 0.02), (0.45, 0.02), (0.55, 0.045), (0.98, 0.045)):
            shade = image.getpixel((int(place * image.width), 100))
            self.assertEqual(shade, round(254 * made_up.solids_fraction(x, 0.2) / 0.63))

    def test_cells_without_particles_are_transparent(self):
        picture = report_figures.png(np.array([[0.5, np.nan]]), report_figures.Normalize(0, 1),
                                     report_figures.plt.get_cmap("viridis"))
        alpha = np.asarray(decoded(picture).convert("RGBA"))[0, :, 3]
        self.assertEqual(list(alpha), [255, 0])


@unittest.skipUnless(CHROMIUM, "no chromium")
class InABrowser(Place):
    def browse(self, *flags):
        words = [CHROMIUM, *FLAGS, f"--user-data-dir={self.place / 'profile'}", "--enable-logging=stderr", *flags,
                 (self.place / "made_up" / "report.html").as_uri()]
        return subprocess.run(words, capture_output=True, text=True, timeout=1200)

    def test_all_frames_are_decoded_and_one_of_each_field_is_shown(self):
        self.page()
        done = self.browse("--dump-dom")
        self.assertIn('data-frames="9"', done.stdout)  # 3 fields at 3 times
        self.assertEqual(len(re.findall(r'<img [^>]*class="shown"', done.stdout)), 3)
        self.assertEqual(re.findall(r'id="shown_time">(.*?)<', done.stdout), ["t = 0.4 s"])
        self.assertEqual([line for line in done.stderr.splitlines() if "CONSOLE" in line], [])

    def test_the_picture_is_not_empty_in_light_and_dark(self):
        self.page()
        brightness = {}
        for name, flags in (("light", []), ("dark", ["--blink-settings=preferredColorScheme=0"])):
            file = self.place / f"{name}.png"
            self.browse(f"--screenshot={file}", "--window-size=1200,3000", *flags)
            pixels = np.asarray(Image.open(file).convert("L"), dtype=float)
            brightness[name] = np.median(pixels)
            self.assertGreater(len(np.unique(pixels)), 50)
        self.assertGreater(brightness["light"], 200)
        self.assertLess(brightness["dark"], 60)


if __name__ == "__main__":
    unittest.main()
