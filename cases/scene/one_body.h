// A scene of one body without loads, for tests, examples and quick looks.
#pragma once

#include "cases/scene/scene.h"

namespace mb {

Scene one_body(const Shape& shape, const Material& material, const Resolution& resolution);

}  // namespace mb
