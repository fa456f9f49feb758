"""What the interface documents, by name: read from the tag file that doxygen writes."""
import re
import xml.etree.ElementTree as ElementTree


class Names:
    def __init__(self, tag_file, folder):
        self.places = {}  # address by name, without `quell::`
        self.kinds = {}
        root = ElementTree.parse(tag_file).getroot()
        for compound in root.findall("compound"):
            kind, name = compound.get("kind"), compound.findtext("name")
            if kind in ("struct", "class", "concept"):
                self._add(name, kind, f"{folder}/{compound.findtext('filename')}")
            for member in compound.findall("member"):
                if kind == "namespace" and member.get("kind") in ("function", "variable", "typedef", "enumeration"):
                    place = f"{folder}/{member.findtext('anchorfile')}#{member.findtext('anchor')}"
                    self._add(f"{name}::{member.findtext('name')}", member.get("kind"), place)

    def _add(self, name, kind, place):
        if "<" not in name:
            name = name.removeprefix("quell::")
            self.places.setdefault(name, place)
            self.kinds.setdefault(name, kind)

    def place_of(self, code):
        """Where a piece of code is documented that is a type, or a preset or a function that is called; None where it is neither."""
        found = re.fullmatch(r"(?:quell::)?([A-Za-z_][\w:]*)(<.*>)?(\{.*\}|\(.*\))?", code)
        if not found:
            return None
        name = found.group(1)
        is_type = name.split("::")[-1][:1].isupper()
        return self.places.get(name) if is_type or "::" in name or (found.group(3) or "").startswith("(") else None
