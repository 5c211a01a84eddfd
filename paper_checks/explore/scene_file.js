/* The scene as a file for `python -m numerics solve`: with m2 = 1, b = 1 and a2 = m1 + m2 all units are 1. */

const written = (value) => String(Number(value.toPrecision(15)));

function sceneFile({ ratio, zeta, X, V1, V2, until, constant, amplitude, omega, literal }) {
  const acting = amplitude !== 0
    ? `sines = [{ amplitude = "${written(amplitude)}", omega = "${written(omega)}" }]`
    : `polynomial = ["${written(constant)}"]`;
  return [
    "[pair]",
    `m1 = "${written(ratio)}"`,
    "m2 = 1",
    `a1 = "${written(2 * zeta * (1 + ratio))}"`,
    `a2 = "${written(1 + ratio)}"`,
    "b = 1",
    "[initial]",
    `x1 = "${written(X)}"`,
    `v1 = "${written(V1)}"`,
    `v2 = "${written(V2)}"`,
    "[run]",
    `law = "${literal ? "three-valued-sgn" : "filippov"}"`,
    `until = "${written(until)}"`,
    ...(constant || amplitude ? ["[[force]]", "from = 0", acting] : []),
    "",
  ].join("\n");
}
