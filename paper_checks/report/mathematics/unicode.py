"""LaTeX mathematics as one line of Unicode, for terminals. Readable, not complete."""

from __future__ import annotations

import re
import unicodedata

_COMMANDS = """
leqslant ≤ leq ≤ le ≤ geqslant ≥ geq ≥ ge ≥ neq ≠ ne ≠ approx ≈ sim ~ pm ± mp ∓ times × cdot · cdots ⋯ ldots … dots
… lceil ⌈ rceil ⌉ lfloor ⌊ rfloor ⌋ nu ν chi χ kappa κ Theta Θ to → rightarrow → mapsto ↦ Rightarrow ⇒ implies ⇒ iff
⇔ infty ∞ in ∈ notin ∉ cap ∩ cup ∪ subset ⊂ vee ∨ wedge ∧ emptyset ∅ forall ∀ exists ∃ int ∫ sum ∑ partial ∂ langle
⟨ rangle ⟩ lVert ‖ rVert ‖ Vert ‖ lvert | rvert | ell ℓ propto ∝ alpha α beta β gamma γ delta δ varepsilon ε epsilon
ε zeta ζ eta η theta θ lambda λ mu μ xi ξ pi π rho ρ sigma σ tau τ phi φ varphi φ psi ψ omega ω Delta Δ Lambda Λ
Gamma Γ Psi Ψ Pi Π Xi Ξ Phi Φ Omega Ω Sigma Σ
"""
_WORDS = dict(re.findall(r"(\w+)\s+(\S+)", _COMMANDS)) | {"quad": "  ", "qquad": "    "}
"""What commands stand for."""
_SUBSCRIPTS = str.maketrans("0123456789+-", "₀₁₂₃₄₅₆₇₈₉₊₋")
_SUPERSCRIPTS = str.maketrans("0123456789+-", "⁰¹²³⁴⁵⁶⁷⁸⁹⁺⁻")
_ACCENTS = {"dot": "\u0307", "ddot": "\u0308", "bar": "\u0304", "hat": "\u0302", "tilde": "\u0303", "dddot": "\u20db"}
_FUNCTIONS = "arcsin|arccos|arctan|sinh|cosh|sin|cos|tan|cot|exp|ln|log|max|min|lim"
_GROUP = r"\{([^{}]*)\}"


def spoken(latex: str) -> str:
    r"""Return LaTeX mathematics as Unicode text.

    >>> spoken(r"\ddot{x}_1 \leqslant \tfrac{b}{m_1+m_2}\sqrt{a}")
    'ẍ₁ ≤ b/(m₁+m₂) √a'
    """
    text = re.sub(r"\\(?:left|right|[bB]ig[lr]?|[bB]igg[lr]?|displaystyle|limits)(?![A-Za-z])\s*\.?", "", latex)
    text = re.sub(r"\\([{}|\\])", lambda match: {"{": "\ue000", "}": "\ue001", "|": "‖", "\\": "; "}[match[1]], text)
    text = re.sub(r"\\([A-Za-z]+)(\s(?=[-+=<>]))?\s*", _word, text)
    text = re.sub(rf"\\(?:({_FUNCTIONS})(?![A-Za-z])|operatorname\s*{_GROUP})\s*", _function, text)
    text = re.sub(r"\\[td]?frac\s*([^\W_])\s*([^\W_])", r"\\frac{\1}{\2}", text)
    text = re.sub(r"\\[td]?frac\s*([^\W_])\s*\{", r"\\frac{\1}{", text)
    text = re.sub(r"\\sqrt\s*([^\W_])", r"\\sqrt{\1}", text)
    previous = None
    while text != previous:
        previous = text
        text = _without_innermost_groups(text)
        if text == previous:
            text = _without_a_bare_group(text)
    text = re.sub(r"\\([A-Za-z]+)\s*", r"\1", text)
    text = re.sub(r"\\[,;:!]|\\ ", " ", text).replace("&", " ")
    text = re.sub(r"(?<=[^\W\d])\ue006", " ", text).replace("\ue006", "")
    text = re.sub(r"\ue004(?=[\w√(])|\ue005(?=[^\W²³¹⁰-₎]|√)", " ", text).replace("\ue004", "").replace("\ue005", "")
    for private, visible in (("\ue000", "{"), ("\ue001", "}"), ("\ue002", "_"), ("\ue003", "^")):
        text = text.replace(private, visible)
    return re.sub(r" ([≤≥≠≈→])(?=\S)", r" \1 ", " ".join(text.split()))


def _word(match: re.Match[str]) -> str:
    """Return what a command stands for, and the space between it and a sign."""
    return _WORDS[match[1]] + (match[2] or "") if match[1] in _WORDS else match[0]


def _without_innermost_groups(text: str) -> str:
    text = re.sub(rf"\\[td]?frac\s*{_GROUP}\s*{_GROUP}", lambda m: f"{_whole(m[1])}/{_alone(m[2])}\ue004", text)
    text = re.sub(rf"\\sqrt\s*{_GROUP}", lambda match: f"√{_alone(match[1])}", text)
    text = re.sub(rf"\\(dot|ddot|dddot|bar|hat|tilde)(?![A-Za-z])\s*(?:{_GROUP}|([^\W\d_]))", _accented, text)
    text = re.sub(
        rf"\\(?:mathrm|mathbf|mathbb|mathcal|mathit|text|operatorname)\s*(?:{_GROUP}|([A-Za-z]))", _named, text
    )
    text = re.sub(rf"([_^])(?:{_GROUP}|([0-9A-Za-z+*-]))", _raised_or_lowered, text)
    return re.sub(r"\\(?:begin|end)\{[a-z*]+\}", " ", text)


def _without_a_bare_group(text: str) -> str:
    """Open the first innermost group that is no argument."""
    for match in re.finditer(_GROUP, text):
        if not re.search(r"(?:\\[A-Za-z]+|[_^}])\s*$", text[: match.start()]):
            return text[: match.start()] + match[1] + text[match.end() :]
    return text


def _function(match: re.Match[str]) -> str:
    """Name a function; marks keep the name from the letter before it and from its argument."""
    return f"\ue006{match[1] or match[2]}\ue005"


def _whole(text: str) -> str:
    return text if re.fullmatch(r"[\w|]+", text) else f"({text})"


def _alone(text: str) -> str:
    """Put a denominator, or what is under a root, in parentheses, but for a number or one letter with its index."""
    return text if re.fullmatch(r"\d+|[^\W\d](?:_?\w)?", text) else f"({text})"


def _named(match: re.Match[str]) -> str:
    return match[1] if match[1] is not None else match[2]


def _accented(match: re.Match[str]) -> str:
    return unicodedata.normalize("NFC", (match[2] or match[3]) + _ACCENTS[match[1]])


def _raised_or_lowered(match: re.Match[str]) -> str:
    content = (match[2] if match[2] is not None else match[3]).strip("\ue005\ue006")
    if re.fullmatch(r"[0-9+-]+", content):
        return content.translate(_SUBSCRIPTS if match[1] == "_" else _SUPERSCRIPTS)
    if content and not content.strip("*"):
        return content
    mark = "\ue002" if match[1] == "_" else "\ue003"
    return mark + (content if re.fullmatch(r"\w+|.", content) else f"({content})")
