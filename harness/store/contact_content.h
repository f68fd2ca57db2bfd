// A contact history within a trajectory file: bodyK_contact_force, _impulse [3, n_t], _energy [2, n_t] (stored, lost),
// bodyK_energy [1, n_t], bodyK_momentum [6, n_t] (linear, angular; not in files of older versions), bodyK_touch_times
// [3, n] (start, end, peak), _touch_peaks [1, n], _touch_impulses [3, n].
#pragma once

#include <map>
#include <string>

#include "cases/contract/method.h"
#include "harness/store/hdf5.h"

namespace mb {

// Nothing of bodies without contact. key: "body0". Throws std::invalid_argument where sizes differ from n_t, and where
// a value is not finite but for the end of a last touch that lasts.
std::map<std::string, Hdf5Matrix> contact_content(const std::string& key, const BodyTrajectory& body, Index n_t);

// Into a body read from the same content; throws std::runtime_error where sizes do not fit, values are not finite or
// touches are not in order of time.
void read_contact(const std::map<std::string, Hdf5Matrix>& content, const std::string& key, Index n_t,
                  BodyTrajectory& body);

}  // namespace mb
