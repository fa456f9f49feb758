#pragma once

// What scenes are made of.

#include "../patterns.hpp"
#include "../shapes.hpp"
#include "interior.hpp"
#include "outdoors.hpp"
#include "scenes.hpp"
#include "turn.hpp"

#include <algorithm>
#include <tuple>
#include <vector>
