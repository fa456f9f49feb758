#include "all_stages.hpp"
#include "recorded_presets.hpp"

#include <quell/shader/record.hpp>

namespace quell::shaders {

std::vector<RecordedPreset> recorded_stages() {
    std::vector<RecordedPreset> made;
    quell_library::for_each_stage([&]<class Named>(Named const& named) {
        made.push_back({named.name, [name = named.name](RecordOptions const& options, float samples) {
                            return record(decltype(Named::make){}(StandsBehind{.samples = samples}), name, options);
                        }});
    });
    return made;
}

} // namespace quell::shaders
