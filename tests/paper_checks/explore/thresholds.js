// The thresholds u/b that the page tells, at each of POINTS (ratio, zeta, omega).
return POINTS.map(([ratio, zeta, omega]) => {
  const { stuck, slipping } = inertialPair.thresholds({ q: ratio / (1 + ratio), r: 1 / (1 + ratio), zeta }, omega);
  return [stuck, slipping];
});
