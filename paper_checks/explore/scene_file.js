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

/* The same of a pair on a surface; a force that stays where it is has no sine. */
function surfaceFile({ ratio, zeta, X, V1, V2, until, size: most, angle, omega }) {
  const list = (values) => `[${values.map((one) => `"${written(one)}"`).join(", ")}]`;
  const sines = (axis) => `sines = [{ amplitude = "${written(most)}", omega = "${written(omega)}", phase = "${written(angle + (axis === "x" ? Math.PI / 2 : 0))}" }]`;
  const steady = (axis) => `polynomial = ["${written(most * (axis === "x" ? Math.cos(angle) : Math.sin(angle)))}"]`;
  const acting = (axis) => ["[[force]]", `axis = "${axis}"`, omega === 0 ? steady(axis) : sines(axis)];
  return [
    "[pair]",
    `m1 = "${written(ratio)}"`,
    "m2 = 1",
    `a1 = "${written(2 * zeta * (1 + ratio))}"`,
    `a2 = "${written(1 + ratio)}"`,
    "b = 1",
    'shape = "ellipsoid"',
    "[initial]",
    ...["x1", "x2"].map((name) => `${name} = ${list(X)}`),
    `v1 = ${list(V1)}`,
    `v2 = ${list(V2)}`,
    "[run]",
    `until = "${written(until)}"`,
    ...(most ? [...acting("x"), ...acting("y")] : []),
    "",
  ].join("\n");
}
