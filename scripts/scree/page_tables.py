"""Tables of Markdown, and their places on pages."""
import re


def markdown(head, lines):
    """A table of texts."""
    return "\n".join("| " + " | ".join(line) + " |" for line in (head, ["---"] * len(head), *lines))


def put(page, tables):
    """Puts tables, by name, between their marks on a page."""
    text = page.read_text()
    for name, table in tables.items():
        marked = rf"(<!-- generated: {name} -->\n).*?(<!-- end -->)"
        text = re.sub(marked, lambda match, table=table: f"{match[1]}{table}\n{match[2]}", text, flags=re.S)
    page.write_text(text)
