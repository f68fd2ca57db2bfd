// By how much errors fall at least from one mesh to a finer one, where they are of order p in the size h of the cells:
//
//   q = (h_c/h_f)^p (n_f/n_c)^(2 p)      degree n, which counts twice (Babuska and Suri 1987)
//
// of all bodies and directions in which the two differ the least. What is off along the others, and by cells of uneven
// sizes that are as uneven in both, they do not tell.
#pragma once

#include "cases/scene/scene.h"

namespace mb {

// [-] q of scenes' meshes; 1 where a body's are the same. Whether it is above 1 is the same of every order > 0.
double fall_of_errors(const Resolution& finer, const Resolution& coarser, double order);
// Of one body's meshes.
double fall_of_body(const Resolution& finer, const Resolution& coarser, double order);

}  // namespace mb
