// Compiled for an older instruction set than the other units. As a host may, it declares some of quell's before including it.
#include <quell/core/instruction_set.hpp>

namespace quell::inline QUELL_INSTRUCTION_SET {
struct Extent;
template <class... Ps> struct Composite;
} // namespace quell::inline QUELL_INSTRUCTION_SET
namespace {
int width_of_image(quell::Extent const& size);
}

#include "two_units.hpp"

namespace host {
struct Lamps : quell::Channel<3> {
    static constexpr auto name = "lamps";
};
struct HalfSize {};
} // namespace host

// A host's specialisations name quell alone.
namespace quell {
template <> inline constexpr int fraction_of<host::HalfSize> = 2;
template <> struct detail::Share<host::Lamps> { using factor = Channels<Albedo>; };
} // namespace quell
static_assert(quell::fraction_of<host::HalfSize> == 2);
using Picture = quell::Composite<quell::Pipeline<host::Lamps>>;
static_assert(Picture::factors::has<quell::Albedo>);

namespace {
int width_of_image(quell::Extent const& size) { return size.width; }
} // namespace

Seen seen_by_older_unit() {
    auto seen = seen_here();
    seen.width = width_of_image(quell::Extent{9, 5});
    return seen;
}
