import pytest
import sympy as sp
from gallina import term

x, y = sp.symbols("x y", positive=True)
NAMES = {x: "x", y: "(f y)"}


@pytest.mark.parametrize(
    ("expression", "text"),
    [
        (x - 2, "((-2) + x)"),
        (x / y, "(x * (/ (f y)))"),
        (sp.sqrt(x) ** 3, "((sqrt x) ^ 3)"),
        (1 / sp.sqrt(x), "(/ (sqrt x))"),
        (sp.Rational(-1, 3) * sp.pi, "((-1 / 3) * PI)"),
        (sp.cot(x), "(cos x / sin x)"),
    ],
)
def test_terms_are_written_exactly(expression, text):
    assert term(expression, NAMES) == text


@pytest.mark.parametrize("expression", [sp.Symbol("z"), sp.asin(x), x ** sp.Rational(1, 3), x**y, sp.Float(0.5)])
def test_what_has_no_exact_form_is_refused(expression):
    with pytest.raises(TypeError, match="no Gallina"):
        term(expression, NAMES)
