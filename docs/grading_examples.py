"""Make the table of examples in grading.md by grading them: ``python docs/grading_examples.py [--check]``."""  # noqa: INP001

import sys
from functools import partial
from pathlib import Path

from sim2reason.grading import choice, formula, number, parts

PAGE = Path(__file__).with_name("grading.md")
BEGIN, END = "<!-- examples: made by grading_examples.py -->\n", "<!-- end of examples -->\n"
FALL, ATWOOD = r"\sqrt{2gh}", r"\frac{m_1-m_2}{m_1+m_2}g"

NUMBERS: list[tuple[str, float, str | None]] = [
    (r"\boxed{9.8}", 9.8, "m/s^2"),
    (r"\boxed{a = 2\times4.9 = 9.8\ \mathrm{m\,s^{-2}}}", 9.8, "m/s^2"),
    (r"\boxed{\frac{49}{5}}", 9.8, "m/s^2"),
    (r"\boxed{980\text{ cm/s}^2}", 9.8, "m/s^2"),
    (r"\boxed{9.8\text{ km/s}^2}", 9.8, "m/s^2"),
    (r"\boxed{9.8\text{ kg}}", 9.8, "m/s^2"),
    (r"\boxed{-9.8}", 9.8, "m/s^2"),
    (r"\boxed{10.2}", 9.8, "m/s^2"),
    (r"\boxed{10.4}", 9.8, "m/s^2"),
    (r"\boxed{9.8 \pm 5}", 9.8, "m/s^2"),
    (r"\boxed{9.8 \text{ or } 12}", 9.8, "m/s^2"),
    (r"\boxed{12,345.6}", 12345.6, "J"),
    (r"\boxed{1.2 x 10^3}", 1200.0, "N"),
    (r"\boxed{1.2×10⁻³}", 0.0012, "N"),
    (r"\boxed{1.13e-07}", 1.13e-7, "m"),
    (r"\boxed{0}", 0.04, "m"),
    (r"\boxed{1/0}", 0.04, "m"),
    (r"\boxed{50\%}", 0.5, ""),
    (r"\boxed{0.5\text{ m}}", 0.5, ""),
    (r"\boxed{0.5\text{ m}}", 0.5, None),
    (r"\boxed{30^\circ}", 0.5236, "rad"),
    (r"\boxed{\arctan\frac{1}{\sqrt3}}", 30.0, "deg"),
    (r"\boxed{10\text{ s}^{-1}}", 10.0, "rad/s"),
    (r"\boxed{10\text{ Hz}}", 10.0, "rad/s"),
    (r"\boxed{9\frac{4}{5}}", 9.8, "m"),
    (r"\boxed{__import__('os').system('ls')}", 9.8, "m"),
    (r"\boxed{v^2 = 10.24 \Rightarrow v = 3.2}", 3.2, "m/s"),
    (r"\boxed{\text{Speed of A: } 3.2\text{ m/s (11.5 km/h)}}", 3.2, "m/s"),
    (r"\boxed{4.9 = 9.8}", 9.8, "m"),
    (r"\boxed{x_1 = 4.9,\ x_2 = 9.8}", 9.8, "m"),
    (r"\boxed{x = 4.9\text{ so }y = 9.8}", 9.8, "m"),
    (r"\boxed{2x = 9.8}", 9.8, "m"),
    (r"\boxed{x \text{ is not } = 9.8}", 9.8, "m"),
    (r"\boxed{1\text{ m/s at }t = 2}", 2.0, "m/s"),
    (r"\boxed{4.9\color{white}\cdot 2}", 9.8, "m"),
    (r"\boxed{3.2\text{ m/s, up the slope}}", 3.2, "m/s"),
    (r"\boxed{3.2\text{ m/s downward}}", -3.2, "m/s"),
    (r"\boxed{9.8\text{ apples}}", 9.8, "m"),
    (r"\boxed{\qty{9.8}{\meter\per\second\squared}}", 9.8, "m/s^2"),
    (r"\boxed{3.2\,\mathrm{ms^{-1}}}", 3.2, "m/s"),
    (r"\boxed{95.5\text{ rpm}}", 10.0, "rad/s"),
    (r"\boxed{21.5\text{ mph}}", 9.61, "m/s"),
    (r"\boxed{1\text{ h }5\text{ min }20\text{ s}}", 3920.0, "s"),
    (r"\boxed{26^\circ 30'}", 26.5, "deg"),
    (r"\boxed{2.4\,\hat{i}\text{ m/s}}", 2.4, "m/s"),
    (r"\boxed{2.4\,\hat{i} + 3.2\,\hat{j}}", 2.4, "m/s"),
    (r"\boxed{\frac{a}{g} = 9.8}", 9.8, "m/s^2"),
    (r"<think>\boxed{9.8}</think> Done.", 9.8, "m"),
    (r"[THINK]\boxed{9.8}[/THINK] Done.", 9.8, "m"),
    (r"\boxed{4.9} \phantom{\boxed{9.8}}", 9.8, "m"),
    (r"It is not \boxed{9.8}.", 9.8, "m"),
    (r"\boxed{9.8} (instead of \boxed{ })", 9.8, "m"),
    (r"The answer is 9.8 m.", 9.8, "m"),
]
FORMULAS = [
    (r"\boxed{v = \sqrt{2}\,(gh)^{1/2}\ \text{m/s}}", FALL),
    (r"\boxed{sqrt(2*g*h)}", FALL),
    (r"\boxed{1.41\sqrt{gh}}", FALL),
    (r"\boxed{v = \sqrt{2gh} \approx 1.41\sqrt{gh}}", FALL),
    (r"\boxed{\sqrt{2gh}\ \text{(downward)}}", FALL),
    (r"\boxed{\sqrt{gh} = \sqrt{2gh}}", FALL),
    (r"\boxed{\sqrt{2gH}}", FALL),
    (r"\boxed{4.43}", FALL),
    (r"\boxed{g-\frac{2m_{2}g}{m_{1}+m_{2}}}", ATWOOD),
    (r"\boxed{(m_1-m_2)g/m_1+m_2}", ATWOOD),
    (r"\boxed{(m_1-m_2)/(m_1+m_2)g}", ATWOOD),
    (r"\boxed{A\cos\omega t}", r"A\cos(\omega t)"),
    (r"\boxed{v_0\mathrm{e}^{-kt}}", r"\frac{v_0}{\exp(kt)}"),
    (r"\boxed{0.5}", r"\sin 30^\circ"),
]
PARTS: list[tuple[float, str]] = [(2.1, "m/s"), (-34.0, "N")]
LABELLED = [
    r"\boxed{(a) 2.1; (b) -34}",
    r"\boxed{\text{(b) }-34\text{ N, (a) }2.1\text{ m/s}}",
    r"\boxed{(a) 2.1; (b) 34}",
    r"\boxed{(a) 2.1}",
    r"\boxed{2.1; -34}",
    r"\boxed{(a) 2.1; (a) 3; (b) -34}",
]
OPTIONS = (4.5, 9.0, -4.5, 13.0)
LETTERED = [
    r"\boxed{B}",
    r"\boxed{\text{(B) }9.0\text{ m/s}}",
    r"\boxed{9.0}",
    r"\boxed{A}",
    r"\boxed{A. 9.0}",
    r"\boxed{A or B}",
]


def code(text: str) -> str:
    """Text as code inside a table."""
    return f"`{text}`".replace("|", "\\|")


def table() -> str:
    """The examples, their verdicts and reasons as the grader gives them."""
    lines = ["| response | the answer | outcome | why |", "| --- | --- | --- | --- |"]
    for response, reference, unit in NUMBERS:
        score = number(response, reference, unit)
        known = {None: "unit unknown", "": "a pure number"}.get(unit, unit)
        lines.append(f"| {code(response)} | {reference:g}, {known} | {score.outcome} | {score.why} |")
    for response, truth in FORMULAS:
        score = formula(response, truth)
        lines.append(f"| {code(response)} | {code(truth)} | {score.outcome} | {score.why} |")
    for response in LABELLED:
        score = parts(response, [partial(number, reference=value, unit=unit) for value, unit in PARTS])
        told = "; ".join(f"({name}) {value:g}, {unit}" for name, (value, unit) in zip("ab", PARTS, strict=True))
        lines.append(f"| {code(response)} | {told} | {score.outcome} | {score.why} |")
    for response in LETTERED:
        score = choice(response, "B", "ABCD", OPTIONS, "m/s")
        told = "B of " + ", ".join(f"{name}. {value:g}" for name, value in zip("ABCD", OPTIONS, strict=True))
        lines.append(f"| {code(response)} | {told}, m/s | {score.outcome} | {score.why} |")
    return "\n".join(lines) + "\n"


def main(arguments: list[str]) -> int:
    """Write the page; with --check only say whether it is current."""
    page = PAGE.read_text(encoding="utf-8")
    before, _, rest = page.partition(BEGIN)
    _, _, after = rest.partition(END)
    made = f"{before}{BEGIN}\n{table()}\n{END}{after}"
    if "--check" in arguments:
        return int(made != page)
    PAGE.write_text(made, encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
