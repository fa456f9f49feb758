#include "two_units.hpp"

Seen seen_by_other_unit() { return seen_here(); }
