#!/usr/bin/env python3
"""Figure 10: rate of discharge of 100 um particles against time, with and without air."""
import paper_figures

RUNS = {"fine_vacuum": "without air", "fine_air": "with air"}


def draw(given, directories):
    return paper_figures.draw_rates({label: paper_figures.Discharge(directories[name]) for name, label in RUNS.items()})


if __name__ == "__main__":
    paper_figures.produce("figure_10", __doc__, draw, RUNS)
