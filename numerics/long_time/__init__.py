"""Energy and number of excursions at any time, 1e100 s included, without stepping there."""
