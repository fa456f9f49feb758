// What quell includes is not ours: it comes before the macros, as where a host's own headers have it already.
#include "dependencies.hpp"
#include "macros_of_hosts.hpp"
#include "two_units.hpp"

Seen seen_by_other_unit() { return seen_here(); }
