#include <denoise/file_remedies.hpp>

namespace quell::examples {

namespace {
/// The change that a file's user can make to mend a mistake, where there is one beside that of the host's code.
std::string in_the_map(Mistake mistake) {
    switch (mistake) {
    case Mistake::motion_sign:
        return "; for files, set \"points\" of \"motion\" in --map";
    case Mistake::motion_unit:
        return "; for files, set \"unit\" of \"motion\" in --map";
    case Mistake::motion_y:
        return "; for files, set \"y\" of \"motion\" in --map";
    case Mistake::depth_is_ray_length:
        return "; for files, set \"along\" of \"depth\" to \"ray\" in --map";
    case Mistake::depth_of_misses:
        return "; for files, set \"miss_from\" in --map";
    case Mistake::signal_demodulated:
        return "; for files, write \"irradiance\" in place of \"radiance\" in --map";
    case Mistake::signal_has_albedo:
        return "; for files, write \"radiance\" in place of \"irradiance\" in --map";
    default:
        return {};
    }
}
} // namespace

std::string remedy_for_files(Finding const& finding) {
    auto text = in_the_map(finding.mistake);
    if (finding.evidence.starts_with(detail::camera_is_not_set))
        text += "; files have it in the attributes quell:view and quell:projection";
    for (auto const mistake : finding.also) text += in_the_map(mistake);
    return text;
}

} // namespace quell::examples
