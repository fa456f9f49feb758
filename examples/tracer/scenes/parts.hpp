#pragma once

// What scenes are made of.

#include "../patterns.hpp"
#include "../shapes.hpp"
#include "interior.hpp"
#include "outdoors.hpp"
#include "scenes.hpp"
#include "turn.hpp"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <vector>
