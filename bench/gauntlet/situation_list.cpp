#include <gauntlet/situation_list.hpp>

#include <quell/core/error.hpp>

#include <algorithm>

namespace quell::gauntlet {

Shot SituationList::with(std::string const& name, Change const& change) const {
    auto const found = std::ranges::find(all, name, &Situation::name);
    if (found == all.end()) throw Error("situations", "there is no " + name, "list it before what is made from it");
    auto shot = found->shot;
    change(shot);
    return shot;
}

void SituationList::add_right(std::string const& name, std::string const& about, Shot shot, bool is_small) {
    all.push_back({.name = name, .about = "nothing: " + about, .shot = std::move(shot), .is_small = is_small});
}

void SituationList::add(std::string const& name, std::string const& about, std::string const& stage, std::string const& twin,
                        Change const& change, bool is_small) {
    all.push_back({name, about, stage, with(twin, change), twin, is_small});
}

} // namespace quell::gauntlet
