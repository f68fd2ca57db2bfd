// By how much errors fall at least from one mesh to a finer one, where they are of order p in the size h of the cells
// and of order s in their degree n:
//
//   q = (h_c/h_f)^p (n_f/n_c)^s
//
// s = 2 p where what is singular sits at corners of cells (Babuska and Suri 1987), p where it crosses them. q is that
// of all bodies and directions in which the two differ the least. What is off along the others, and by cells of uneven
// sizes that are as uneven in both, they do not tell.
#pragma once

#include "cases/scene/scene.h"

namespace mb {

struct Order {
  double in_size, in_degree;  // [-] p, s > 0
  Order(double p, double s) : in_size(p), in_degree(s) {}
  Order(double p) : Order(p, 2 * p) {}
};

// [-] q of scenes' meshes; 1 where a body's are the same. Whether it is above 1 is the same of every order.
double fall_of_errors(const Resolution& finer, const Resolution& coarser, const Order& order);
// Of one body's meshes.
double fall_of_body(const Resolution& finer, const Resolution& coarser, const Order& order);

}  // namespace mb
