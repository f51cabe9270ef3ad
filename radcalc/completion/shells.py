"""Completion in bash, zsh and fish: their scripts, the line they send, the words they get.

`_RADCALC_COMPLETE=bash_source radcalc` prints the script, which a shell evaluates once.  At a Tab
it calls `_RADCALC_COMPLETE=bash_complete radcalc` with the line up to the cursor, with quotes, in
`COMP_LINE`, without which radcalc reports an error.
"""

import os

from radcalc import terminal
from radcalc.completion import completions
from radcalc.completion.words import Completion, files
from radcalc.errors import RadcalcError, UsageError, quote

TYPE_CHECKING = False  # typing is slow to import
if TYPE_CHECKING:
    from collections.abc import Callable

VARIABLE = "_RADCALC_COMPLETE"
LINE, BREAKS = "COMP_LINE", "COMP_WORDBREAKS"
SAFE = "_-./:=@%+,~^"  # characters that mean themselves in bash, like letters and digits
# A completion that ends its word includes the blank after it, which every bash can do.
BASH = """\
_radcalc_completion() {
    local line
    COMPREPLY=()
    while IFS= read -r line; do
        COMPREPLY+=("$line")
    done < <(_RADCALC_COMPLETE=bash_complete COMP_LINE="${COMP_LINE:0:COMP_POINT}" \\
        COMP_WORDBREAKS="$COMP_WORDBREAKS" "${1/#\\~\\//$HOME/}" 2>/dev/null)
}
complete -o nospace -o nosort -F _radcalc_completion radcalc 2>/dev/null ||
    complete -o nospace -F _radcalc_completion radcalc
"""
ZSH = """\
#compdef radcalc
_radcalc_completion() {
    local -a closed shown open shown_open
    local line
    for line in "${(@f)$(_RADCALC_COMPLETE=zsh_complete \\
        COMP_LINE="${(j: :)words[1,CURRENT-1]} $QIPREFIX$PREFIX" ${~words[1]} 2>/dev/null)}"; do
        case $line in
            (' '*) closed+=("${${line# }%%$'\t'*}") shown+=("${line#*$'\t'}") ;;
            (?*) open+=("${line%%$'\t'*}") shown_open+=("${line#*$'\t'}") ;;
        esac
    done
    compadd -V radcalc -ld shown -a closed
    compadd -V radcalc -S '' -ld shown_open -a open
}
if [[ $zsh_eval_context[-1] == loadautofunc ]]; then
    _radcalc_completion "$@"
else
    compdef _radcalc_completion radcalc
fi
"""
FISH = """\
function __radcalc_complete
    set -l program (string replace -r '^~/' $HOME/ -- (commandline -opc)[1])
    env _RADCALC_COMPLETE=fish_complete COMP_LINE=(commandline -pc | string collect) \\
        $program 2>/dev/null
end
complete --command radcalc --no-files --keep-order --arguments '(__radcalc_complete)'
"""
SCRIPTS = {"bash": BASH, "zsh": ZSH, "fish": FISH}


def answer_shell(request: str) -> int:
    """Write the answer to a shell, and return the exit status."""
    shell, _, wanted = request.partition("_")
    if shell in SCRIPTS and wanted == "source":
        return _write(SCRIPTS[shell].encode())
    if shell in SCRIPTS and wanted == "complete" and LINE in os.environ:
        lines = WRITERS[shell](Typed(os.environ[LINE], os.environ.get(BREAKS, "")))
        return _write("".join([f"{line}\n" for line in lines]).encode("utf-8", "surrogateescape"))
    problem = f"{VARIABLE}={quote(request)} is not a known request for completion"
    hint = "bash_source, zsh_source or fish_source there, or without it"
    return terminal.complain(UsageError(problem, hint))


def _write(data: bytes) -> int:
    try:
        terminal.pour(data)
    except BrokenPipeError:
        return terminal.ANSWERED
    except RadcalcError as error:
        return terminal.complain(error)
    return terminal.ANSWERED


class Typed:
    """A line up to the cursor: its words, and the word being typed.

    `quote` is an open quotation mark; `cut` is the start of the part of the last word that readline
    replaces: after one of its `breaks`, or an open quotation mark.
    """

    def __init__(self, line: str, breaks: str) -> None:
        self.words: list[str] = []
        self.word, self.quote, self.cut = "", "", 0
        self.is_redirected = False  # the word is a file after < or >
        is_word = False
        letters = iter(line)
        for letter in letters:
            if self.quote:
                if letter == self.quote:
                    self.quote = ""
                    self.cut = len(self.word) if letter in breaks else self.cut
                elif letter == "\\" and self.quote == '"':
                    after = next(letters, "")
                    self.word += after if after in '"\\$`' else letter + after
                else:
                    self.word += letter
            elif letter.isspace() or letter in "<>":
                if is_word and not (letter in "<>" and self.word.isdigit()):
                    self._end()
                is_word, self.word, self.cut = False, "", 0
                self.is_redirected = self.is_redirected or letter in "<>"
            else:
                is_word = True
                if letter in "'\"":
                    self.quote, self.cut = letter, len(self.word)
                else:
                    self.word += next(letters, "") if letter == "\\" else letter
                    self.cut = len(self.word) if letter in breaks else self.cut
        while self.words and "=" in self.words[0]:  # VARIABLE=VALUE radcalc
            del self.words[0]

    def _end(self) -> None:
        if not self.is_redirected:
            self.words.append(self.word)
        self.is_redirected = False

    def completions(self) -> list[Completion]:
        """Return completions of the last word, except files whose names have several lines."""
        if self.is_redirected:
            candidates = files(("",), self.word)
        else:
            candidates = completions(self.words[1:], self.word)
        return [
            candidate for candidate in candidates if not {"\n", "\r", "\t"} & set(candidate.text)
        ]


def _bash(typed: Typed) -> list[str]:
    lines = []
    for candidate in typed.completions():
        text = candidate.text[typed.cut :]
        if typed.quote:
            lines.append(text if typed.quote == "'" else _escaped(text, lambda c: c not in '"\\$`'))
        else:
            text = _escaped(text, lambda c: c.isalnum() or c in SAFE or not c.isascii())
            lines.append(text + " " if candidate.closes else text)
    return lines


def _escaped(text: str, is_plain: "Callable[[str], bool]") -> str:
    return "".join([letter if is_plain(letter) else "\\" + letter for letter in text])


def _zsh(typed: Typed) -> list[str]:
    """Return the word and its description; a blank precedes one that ends its word."""
    candidates = typed.completions()
    width = max((len(candidate.text) for candidate in candidates), default=0)
    return [
        f"{' ' * candidate.closes}{candidate.text}\t{_with_description(candidate, width)}"
        for candidate in candidates
    ]


def _with_description(candidate: Completion, width: int) -> str:
    return (
        f"{candidate.text:{width}}  -- {candidate.description}"
        if candidate.description
        else candidate.text
    )


def _fish(typed: Typed) -> list[str]:
    return [f"{candidate.text}\t{candidate.description}" for candidate in typed.completions()]


WRITERS: "dict[str, Callable[[Typed], list[str]]]" = {"bash": _bash, "zsh": _zsh, "fish": _fish}
