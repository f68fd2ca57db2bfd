"""Eigenvalues nearest to a shift by SciPy's eigsh (ARPACK with SuperLU), timed.

scipy_eigsh.py FOLDER COUNT SIGMA TOLERANCE

Reads K and M as the comparison wrote them to FOLDER. Prints the seconds of one run, factor included, then the
eigenvalues, one a line.
"""
import sys
import time

import numpy as np
from scipy.sparse import csc_matrix
from scipy.sparse.linalg import eigsh


def matrix(folder, name):
    data, indices, indptr = (np.load(f"{folder}/{name}-{part}.npy") for part in ("data", "indices", "indptr"))
    n = len(indptr) - 1
    return csc_matrix((data, indices, indptr), shape=(n, n))


def main():
    folder, count, sigma, tolerance = sys.argv[1], int(sys.argv[2]), float(sys.argv[3]), float(sys.argv[4])
    K, M = matrix(folder, "K"), matrix(folder, "M")
    start = time.perf_counter()
    values, _ = eigsh(K, count, M, sigma=sigma, tol=tolerance)
    print(repr(time.perf_counter() - start))
    for value in sorted(values):
        print(repr(float(value)))


main()
