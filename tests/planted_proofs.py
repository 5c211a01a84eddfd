"""False statements and definitions next to the true ones: (file, true text, false text, what is false in words).

White space in the true text matches any white space. Where a changed statement merely breaks its proof it is not here:
each is false, or makes a theorem above it false.
"""

FREE = [
    ("Stick", "(m1 + m2) ^ 2 / (2 * a2 * m2 ^ 2).", "(m1 + m2) ^ 2 / (a2 * m2 ^ 2).", "the critical energy, twice"),
    ("Pair", "t - r <= 2 * sqrt (2 * E r * m2) / b.", "t - r <= sqrt (2 * E r * m2) / b.", "half the longest stay"),
    ("Pair", "v1 t < v2 t -> rderiv s t (-1);", "v1 t < v2 t -> rderiv s t 1;", "friction that pushes"),
    ("Rate", "(fun n => INR n * y n) (4 / (9 * r)).", "(fun n => INR n * y n) (4 / (8 * r)).", "the map's rate"),
    ("Rate", "depth p <= 3 / 2 * hh p ^ 2.", "depth p <= 14 / 10 * hh p ^ 2.", "the depth's bound"),
    ("Critical", "79263163272865 / 100000000000000", "79263163272965 / 100000000000000", "a decimal"),
    ("Limit", "l <= Ecr m1 m2 a2 b.", "l < Ecr m1 m2 a2 b.", "a limit below E_cr"),
    ("Sharp", "Definition rate := 4 * PI / 9", "Definition rate := 4 * PI / 8", "the sharp constant"),
    ("Cycle", "(m2 * o1) * (u - o1 * t).", "(m2 * o1) * (u + o1 * t).", "body 2 driven on"),
    ("Cycle", "r * depth p ^ 2)). Proof.", "r * depth p ^ 3)). Proof.", "an exponent of the return map"),
    ("Orbit", "<= 6 * sqrt q * hh p. Proof", "<= 2 * sqrt q * hh p. Proof", "the cycle time too sharp"),
    ("Orbit", "depth p <= 2. Proof", "depth p <= 1. Proof", "half the depth"),
    ("Law", "let K := 9 / 4 * (m2 / m1) in 0 < w0", "let K := 9 / 4 * (m1 / m2) in 0 < w0", "the masses exchanged"),
    ("Law", "E / Ecr - 1 < 4 * q / (9 * r).", "E / Ecr - 1 < 5 * q / (9 * r).", "a level that is not small"),
    (
        "Slip",
        "-> g t = 1) /\\ (V1 t < V2 t -> g t = -1) }",
        "-> g t = -1) /\\ (V1 t < V2 t -> g t = 1) }",
        "an arc's friction",
    ),
    ("Paper", "tau n - te n) (PI * sqrt ((m1 + m2) / a2))", "tau n - te n) (PI * sqrt (m1 / a2))", "the stay on S0"),
    (
        "Merge",
        "<-> m2 / (m1 + m2) * depth p ^ 2 < hh p ^ 2)",
        "<-> m2 / (m1 + m2) * depth p ^ 2 <= hh p ^ 2)",
        "equality does not stay above E_cr",
    ),
]

FORCED = [
    ("Forced", "m1 * v1 r + b * s r - U r) t", "m1 * v1 r + b * s r + U r) t", "the sign of the force"),
    ("Forced", "v1 t < v2 t -> rderiv s t (-1);", "v1 t < v2 t -> rderiv s t 1;", "friction that pushes"),
    ("Forced", "<= b / m2 / 4 * (T ^ 2", "<= b / m2 / 5 * (T ^ 2", "the reach"),
    ("Forced", "v2 T = 0 -> 2 * sqrt (m2 *", "v2 T = 0 -> 21 / 10 * sqrt (m2 *", "the least time"),
    ("Forced", "N t <= N r + (J t - J r) / sqrt m1.", "N t <= N r + (J t - J r) / sqrt (2 * m1).", "input to state"),
    ("Forced", "(u * v1 t - a1 * v1 t ^ 2", "(u * v2 t - a1 * v1 t ^ 2", "the power of the force"),
    (
        "Forced",
        "forall p q, 0 <= p <= q -> Rabs (v q - v p) <= b / m2 * (q - p).",
        "forall p q, 0 <= p <= q -> Rabs (v q - v p) <= 2 * b / m2 * (q - p).",
        "following twice as fast",
    ),
    ("Entrain", "b / m2 * sqrt Z / om ^ 2.", "b / m2 * sqrt Z / om.", "F*"),
    ("Entrain", "stuck_for_ever x v1 v2 s : 0 < a1 ->", "stuck_for_ever x v1 v2 s : 0 <= a1 ->", "without damping"),
    ("Entrain", "F = 2 / sqrt 3 * Fstar", "F = 12 / 10 * Fstar", "the third harmonic's factor"),
    ("Response", "d <= c / 4 -> d < b / m2 * (c / (8 * K)) ->", "d <= c / 4 ->", "a crossing for nothing"),
    ("Bounded", "(Hm2 : 0 < m2) (Ha1 : 0 < a1)", "(Hm2 : 0 < m2) (Ha1 : 0 <= a1)", "bounded without damping"),
    ("Bounded", "c * (g ^ 2 / a2) - c / 3 * W t.", "c * (g ^ 2 / a2) - 3 * c * W t.", "decay nine times as fast"),
    ("ForcedExistence", "0 < a2 -> 0 < b -> cont U ->", "0 < a2 -> 0 < b ->", "a force without an impulse"),
    ("Periodic", "U (P + t) - U P = U t - U 0)", "U (P + t) - U P = U 0 - U t)", "an antiperiodic force"),
    ("Sync", "synchronises x v1 v2 s : F < Fstar", "synchronises x v1 v2 s : F <= Fstar", "finite time at F*"),
    ("Sync", "(Hm2 : 0 < m2) (Ha1 : 0 < a1)", "(Hm2 : 0 < m2) (Ha1 : 0 <= a1)", "entrained without damping"),
    ("Sync", "T + Rabs (w T) / (kap * g) <= t", "T + Rabs (w T) / (2 * kap * g) <= t", "caught twice as fast"),
]

PAST = [
    (
        "Levels",
        "- cos (2 * ps) < m1 / m2 -> forall p d,",
        "m1 / m2 < - cos (2 * ps) -> forall p d,",
        "light drivers' levels",
    ),
    ("Return", "* (depth p * (depth p + 2 * d)). Proof", "* (depth p * (depth p + d)). Proof", "the loss of a slip"),
    (
        "Return",
        "Rabs (x u - x t) <= sqrt (2 * e / m1)",
        "Rabs (x u - x t) <= sqrt (e / m1)",
        "body 1 slower than it is",
    ),
    (
        "Heavy",
        "- cos (2 * ps) < m1 / m2 -> forall x v1 v2 s t0,",
        "m1 / m2 < - cos (2 * ps) -> forall x v1 v2 s t0,",
        "light drivers that never merge",
    ),
    ("Merging", "<-> El <= energy", "<-> El < energy", "the merging interval without its end"),
    ("Surface", "< t + T -> 0 < x t * (v2 u - v1 u).", "< t + T -> 0 < x t * (v1 u - v2 u).", "the sign of a slip"),
    ("Surface", "- L < y < L <-> normal_rate", "- L <= y <= L <-> normal_rate", "transversality on an edge"),
    ("Surface", "(x t = L -> v1 t <= 0)", "(x t = L -> v1 t <= 1)", "sticking on an exit ray"),
    (
        "Surface",
        "energy m1 m2 a2 x0 v0 v0 <= Ecr. Proof. split",
        "energy m1 m2 a2 x0 v0 v0 < Ecr. Proof. split",
        "no critical ellipse",
    ),
    ("Example", "x 0 = 6 / 1000 ->", "x 0 = 5 / 1000 ->", "slipping from 5 mm"),
    ("Example", "- (5 / 1000) <= x 0 <= 5 / 1000 ->", "- (6 / 1000) <= x 0 <= 6 / 1000 ->", "sticking from 6 mm"),
    ("Time", "<= 27 / 2 * sqrt q * hh p ^ 3. Proof", "<= 27 / 2 * sqrt q * hh p ^ 4. Proof", "the cycle time's order"),
    (
        "Consequences",
        "(x t1 < - L m1 m2 a2 b /\\ exists T",
        "(L m1 m2 a2 b < x t1 /\\ exists T",
        "crossing on the wrong side",
    ),
    ("Ends", "(forall n, Rabs (x (tau n)) = L)", "(forall n, Rabs (x (te n)) = L)", "entries at the ends"),
    ("Perpetual", "te n <= t <= tau n -> v1 t = v2 t)", "te n <= t <= te (S n) -> v1 t = v2 t)", "no slip at all"),
    ("Uniform", "<= Ecr * (1 + e). Proof", "< Ecr. Proof", "a motion that never merges, below E_cr"),
    ("Uniform", "/ Ecr - 1 <= c / t. Proof", "/ Ecr - 1 <= c / t ^ 2. Proof", "an upper bound of the wrong order"),
    ("Limit", "Ecr m1 m2 a2 b < l -> 0 <= T -> E T <= e", "0 < l -> 0 <= T -> E T <= e", "a toll below E_cr"),
    ("Return", "t <= t0 + (INR n + 1) * (2 * PI / o1)", "t <= t0 + INR n * (2 * PI / o1)", "one slip forgotten"),
    ("Consequences", "C * exp (- (k * t)) <= energy", "C * exp (k * t) <= energy", "faster than exponential"),
]

CONTROL = [
    (
        "Arcs",
        "x T = - x 0 -> v1 T = - v1 0 -> v2 T = - v2 0 ->",
        "x T = - x 0 -> v1 T = - v1 0 ->",
        "body 2 forgotten in a motion that changes sign",
    ),
    ("Nonstop", "(h' - PI / (2 * m2 * om)).", "(h' - PI / (m2 * om)).", "U**: the whole period for its half"),
    ("Nonstop", "b * ((m1 + m2) / m2 - a2 * h", "b * (m1 / m2 - a2 * h", "U** below the load that breaks adhesion"),
    ("Undamped", "(2 * om)) + PI * m1 / (2 * m2)) ^ 2", "(2 * om)) - PI * m1 / (2 * m2)) ^ 2", "a sign in U**"),
    ("Undamped", "0 <= F -> a2 < m1 * om ^ 2 ->", "0 <= F -> m1 * om ^ 2 < a2 ->", "U** alone below resonance"),
    ("Damped", "- (sinh (fade * (PI / om)) - fade", "- (sinh (fade * (PI / om)) + fade", "a sign in the damped turn"),
    (
        "Damped",
        "s' : 0 < m1 -> 0 < m2 -> 0 < a1 ->",
        "s' : 0 < m1 -> 0 < m2 -> 0 <= a1 ->",
        "attracting without damping",
    ),
    ("TwoStop", "W (PI / om) = - V 0 -> (forall", "W (PI / om) = V 0 -> (forall", "a stop whose speed does not turn"),
    ("TwoStop", "a2 * x 0 = (m1 + m2) * (b / m2)", "a2 * x 0 = m1 * (b / m2)", "an exit below the load b"),
    (
        "Transfer",
        "a2 * D / 2 <= F /\\ a2 * D <= F",
        "a2 * D / 3 <= F /\\ a2 * D <= F",
        "a smaller push before the middle",
    ),
    ("Transfer", "-> b + be * tau / g tau <= F.", "-> 2 * b + be * tau / g tau <= F.", "more than the least amplitude"),
    ("Arrival", "in th <= PI / 2 ->", "in th <= PI ->", "the least amplitude beyond a quarter swing"),
    (
        "Arrival",
        "<-> b + b / m2 * half_time m2 b D / g (half_time m2 b D) <= F. Proof",
        "<-> b + b / m2 * half_time m2 b D / g (half_time m2 b D) < F. Proof",
        "the least amplitude not enough",
    ),
    (
        "Varying",
        "In p pieces -> 0 < fst p /\\ 0 <= snd p.",
        "In p pieces -> 0 <= snd p.",
        "pieces without friction, or worse",
    ),
    ("Mode", "Rabs (load t0) < b -> exists d", "Rabs (load t0) <= b -> exists d", "a tie that always sticks"),
    ("Mode", "b < k * load t0 -> exists d", "b <= k * load t0 -> exists d", "a tie that always slips"),
    ("Mode", "(0 < P n t0 -> exists d", "(0 <= P n t0 -> exists d", "a tie decided by a derivative that is 0"),
    (
        "Mode",
        "beyond k t <= beyond k r) -> exists d",
        "beyond k r <= beyond k t) -> exists d",
        "sticking under a rising load",
    ),
    (
        "Zeno",
        "piecewise_analytic u -> 0 <= T -> finitely_many_modes v1 v2 0 T. Proof. intros Hm1 Hm2 Ha1 Ha2 Hb H",
        "0 <= T -> finitely_many_modes v1 v2 0 T. Proof. intros Hm1 Hm2 Ha1 Ha2 Hb H",
        "any force, without accumulation",
    ),
    (
        "Analytic",
        "<= C * K ^ i * INR (fact i). (** From",
        "<= C * K ^ i * INR (fact i) ^ 2. (** From",
        "flat functions",
    ),
    (
        "Before",
        "(forall t, d < t < T -> 0 < p t) -> False.",
        "(forall t, d < t < T -> 0 <= p t) -> False.",
        "no marginal stick",
    ),
    ("Rule", "(load t - k * b)).", "(load t + k * b)).", "friction that drives the slip"),
    ("Rule", "Rabs (load t) <= b. Proof", "Rabs (load t) < b. Proof", "no stick at the edge"),
    (
        "Rule",
        "(forall n, Derive_n",
        "(forall n, (n < 3)%nat -> Derive_n",
        "a tie called marginal after three derivatives",
    ),
    (
        "Drift",
        "U (T + t) - U T = - (U t - U 0)) ->",
        "U (T + t) - U T = U t - U 0) ->",
        "no drift under any periodic force",
    ),
    ("Ring", "<= e <-> T <= t)) /\\", "<= e <-> T < t)) /\\", "a tube without its edge"),
    (
        "Ring",
        "<= sqrt (2 * ((m1 + m2) / (m1 * m2)) * e). Proof. intros H",
        "<= sqrt (((m1 + m2) / (m1 * m2)) * e). Proof. intros H",
        "half the ring",
    ),
]

PLANTED = FREE + FORCED + PAST + CONTROL
QUICK = {"half the longest stay", "a decimal", "slipping from 5 mm"}
