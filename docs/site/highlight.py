"""Colours code: what its parts are becomes a class, by which the style sheets go."""
import html
import re

CPP = """alignas auto bool break case catch char class concept const consteval constexpr constinit continue default delete do double else enum
explicit export extern false final float for friend if inline int long mutable namespace new noexcept nullptr operator override private
protected public requires return short signed sizeof static static_assert static_cast struct switch template this throw true try typename
union unsigned using virtual void volatile while"""
PYTHON = """and as assert async await break class continue def del elif else except False finally for from if import in is lambda None
nonlocal not or pass raise return True try while with yield"""
SHELL = "case do done elif else esac export fi for function if in then while"
CMAKE = "PRIVATE PUBLIC INTERFACE REQUIRED CONFIG COMPONENTS PRESET LANGUAGE"


def _rules(keywords, comment, line_start=None):
    parts = [f"(?P<comment>{comment})", r"(?P<string>\"(?:\\.|[^\"\\\n])*\"|'(?:\\.|[^'\\\n])*')"]
    if line_start:
        parts.append(f"(?P<line>{line_start})")
    parts += [r"(?P<keyword>\b(?:" + "|".join(keywords.split()) + r")\b)", r"(?P<number>\b\d[\w.']*)"]
    return re.compile("|".join(parts), re.MULTILINE)


_OF = {
    "cpp": _rules(CPP, r"//[^\n]*|/\*.*?\*/", r"^[ \t]*#[ \t]*\w+"),
    "python": _rules(PYTHON, r"#[^\n]*", r"^[ \t]*@\w+"),
    "sh": _rules(SHELL, r"(?:^|(?<=\s))#[^\n]*"),
    "cmake": _rules(CMAKE, r"#[^\n]*", r"^[ \t]*\w+(?=\()"),
    "json": _rules("true false null", r"(?!)"),
}
_OF |= {"c": _OF["cpp"], "c++": _OF["cpp"], "hpp": _OF["cpp"], "py": _OF["python"], "bash": _OF["sh"], "console": _OF["sh"]}


def highlighted(code, language):
    """HTML of the code. A language that it doesn't know stays as it is."""
    rules = _OF.get(language)
    if not rules:
        return html.escape(code, quote=False)
    made, done = [], 0
    for found in rules.finditer(code):
        made += [html.escape(code[done : found.start()], quote=False)]
        made += [f'<span class="{found.lastgroup}">{html.escape(found.group(), quote=False)}</span>']
        done = found.end()
    return "".join(made) + html.escape(code[done:], quote=False)
