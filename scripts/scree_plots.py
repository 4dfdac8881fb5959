"""What the plot scripts share: their look, their arguments, where pictures go."""
import argparse

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

import scree_output

STYLE = {
    "font.size": 12,
    "axes.labelsize": 13,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "legend.frameon": False,
    "lines.linewidth": 1.8,
    "figure.dpi": 100,
    "savefig.dpi": 180,
    "savefig.bbox": "tight",
    "figure.constrained_layout.use": True,
}


def arguments(text, *more):
    """Parses OUT_DIR ... and the options `more`, pairs (name, keywords of add_argument); sets the style of the plots."""
    parser = argparse.ArgumentParser(description=text, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("directories", nargs="+", metavar="OUT_DIR", help="output directory of a run")
    for name, keywords in more:
        parser.add_argument(name, **keywords)
    found = parser.parse_args()
    for directory in found.directories:
        if not scree_output.field_files(directory):
            parser.error(f"{directory} holds no fields of a run")
    plt.rcParams.update(STYLE)
    return found


def save(figure, directory, name):
    """Writes directory/plots/name."""
    (directory / "plots").mkdir(exist_ok=True)
    figure.savefig(directory / "plots" / name)
    plt.close(figure)
