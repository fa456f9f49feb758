#include <gauntlet/measures.hpp>
#include <gauntlet/references.hpp>

namespace quell::gauntlet {

namespace {

/// A shot with all as it should be that leaves its picture as it is.
Shot picture_of(Shot const& shot) {
    Shot plain{.world = shot.world, .path = shot.path};
    plain.is_held = shot.is_held, plain.is_transparent = shot.is_transparent, plain.part = shot.part;
    plain.spread = shot.spread == Spread::filtered ? Spread::none : shot.spread;
    return plain;
}

Reference made(Shot const& shot, Making const& making, int frame) {
    auto const rendered = reference(shot, making, frame);
    Reference result{{rendered.size, {}}, {}};
    metrics::Mask broken;
    for (auto const& pixel : rendered.pixels) {
        result.picture.pixels.emplace_back(pixel.combined());
        broken.push_back(pixel.broken > 0 ? 1 : 0);
    }
    if (shot.part != Part::all) result.right = away_from(broken, rendered.size, around_broken);
    return result;
}

} // namespace

Reference const& References::of(Shot const& shot, Making const& making, int frame) {
    auto const plain = picture_of(shot);
    std::scoped_lock const lock(mutex);
    for (auto& each : all)
        if (each.shot == plain) {
            if (!each.frames.contains(frame)) each.frames.emplace(frame, made(plain, making, frame));
            return each.frames.at(frame);
        }
    return all.emplace_back(OfShot{plain, {{frame, made(plain, making, frame)}}}).frames.at(frame);
}

} // namespace quell::gauntlet
