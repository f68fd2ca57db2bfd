// One thread, whatever the libraries would like: OpenBLAS by its own switch; CHOLMOD asks OpenMP for four threads in
// every factorisation, which OMP_NUM_THREADS does not forbid and which on two cores cost half as much time again.
#pragma once

namespace mb {

void on_one_thread();  // of this process, from now on

}  // namespace mb
