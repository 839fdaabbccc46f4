"""Tests that every source text is translated and that translations keep placeholders, names and keys."""
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ElementTree

FOLDER = pathlib.Path(os.environ["TERRATACT_SOURCE_DIR"]) / "resources" / "translations"
# Placeholders of values, a progress bar's percentage, keys in texts, and commands to type.
KEPT = re.compile(r"%[1-9]|%p|sudo \w+ \w+|\((?:A|M|N|R|S|W|Esc|Space|F12)\)|F1\b|ATEM|STOP")
SPACE = {"cs": "(mezerník)", "de": "(Leertaste)"}  # as on the keyboards of the language
STOPS = {"stop": "STOP", "release stop": "release STOP", "atem": "ATEM"}  # operator actions in session records
# STOP is a software stop. No text may promise an emergency stop that cuts the power.
EMERGENCY = re.compile(r"nouzov.*(zastav|stop)|\bnot-?(aus|halt|stopp)|\be-?stop|emergency stop", re.IGNORECASE)
# A bin has one word in each language. These are words for other things.
OTHER_BINS = re.compile(r"\babschnitt|\búse(?:k|cích)", re.IGNORECASE)


def keeps(source, text, language):
    """Returns true if a translation keeps what must stay, and names the space bar in its language."""
    named = source.replace("(Space)", SPACE[language])
    return (sorted(KEPT.findall(named)) == sorted(KEPT.findall(text))
            and named.count(SPACE[language]) == text.count(SPACE[language]))


def trouble(file):
    for context in ElementTree.parse(file).getroot().iter("context"):
        for message in context.iter("message"):
            source = message.find("source").text
            translation = message.find("translation")
            where = f"{file.name}, {context.find('name').text}: {source!r}"
            if EMERGENCY.search(source) or EMERGENCY.search(translation.text or ""):
                yield f"{where}: {translation.text!r} calls STOP an emergency stop"
            if re.search(r"\bbins?\b", source) and OTHER_BINS.search(translation.text or ""):
                yield f"{where}: {translation.text!r} has another word for a bin"
            if translation.get("type") == "unfinished" or not translation.text:
                yield f"{where} is not translated"
            elif not keeps(STOPS.get(source, source), translation.text, file.stem[-2:]):
                yield f"{where}: {translation.text!r} does not keep its places, keys, commands, ATEM or STOP"


def main():
    with tempfile.TemporaryDirectory() as folder:
        update = subprocess.run([FOLDER / "update.sh", folder], check=False)
        if update.returncode == 77:
            return 77
        update.check_returncode()
        files = sorted(pathlib.Path(folder).glob("*.ts"))
        assert [f.name for f in files] == ["terratact_cs.ts", "terratact_de.ts"], files
        found = [line for file in files for line in trouble(file)]
    print("\n".join(found))
    print(f"{len(found)} texts to look at; resources/translations/update.sh, then fill them in")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
