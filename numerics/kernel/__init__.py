"""The binary64 and double-double kernels: plain functions, run as they stand or compiled by numba, with equal bits."""
