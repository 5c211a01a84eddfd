"""The binary64 kernels: plain functions of floats, run as they stand or compiled by numba, with equal bits."""
