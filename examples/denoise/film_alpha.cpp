#include <denoise/denoised_frame.hpp>
#include <denoise/film_alpha.hpp>

#include <quell/core/real.hpp>
#include <quell/io/frame_image.hpp>
#include <quell/motion/invert_motion.hpp>

#include <algorithm>
#include <cmath>

namespace quell::examples {

namespace {

/// The least or the greatest within `radius` pixels, by rows and then by columns. What is not finite counts as 0.
std::vector<float> extreme_within(std::vector<float> values, Extent size, int radius, auto const& better) {
    for (auto& value : values) value = is_finite(value) ? value : 0.f;
    auto const along = [&](int length, int lines, auto const& index) {
        auto const from = values;
        for (int line = 0; line < lines; ++line)
            for (int i = 0; i < length; ++i)
                for (int j = std::max(i - radius, 0); j <= std::min(i + radius, length - 1); ++j)
                    values[index(line, i)] = better(values[index(line, i)], from[index(line, j)]);
    };
    along(size.width, size.height, [&](int y, int x) { return index_of(size, x, y); });
    along(size.height, size.width, [&](int x, int y) { return index_of(size, x, y); });
    return values;
}

/// What the 3x3 around each pixel shows.
FilmContents shown_around(FilmContents const& here, Extent size) {
    FilmContents around(here.size(), 0);
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x)
            for (int j = std::max(y - 1, 0); j <= std::min(y + 1, size.height - 1); ++j)
                for (int i = std::max(x - 1, 0); i <= std::min(x + 1, size.width - 1); ++i)
                    around[index_of(size, x, y)] |= here[index_of(size, i, j)];
    return around;
}

/// What those of the four pixels around a place show from which it is interpolated.
FilmContent shown_at(FilmContents const& there, Extent size, glm::vec2 const& place) {
    unsigned char shown = 0;
    if (!is_finite(place.x) || !is_finite(place.y)) return shown;
    float const left = std::floor(place.x - 0.5f), top = std::floor(place.y - 0.5f);
    float const right = place.x - 0.5f > left ? left + 1.f : left, bottom = place.y - 0.5f > top ? top + 1.f : top;
    for (float const y : {top, bottom})
        for (float const x : {left, right}) {
            bool const inside = x >= 0.f && y >= 0.f && x < static_cast<float>(size.width) && y < static_cast<float>(size.height);
            if (inside) shown |= there[index_of(size, static_cast<int>(x), static_cast<int>(y))];
        }
    return shown;
}

/// The same for each pixel, where its vector leads.
template <class View> FilmContents shown_where(FilmContents const& there, Extent size, View const& vectors) {
    FilmContents shown;
    shown.reserve(there.size());
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            glm::vec2 const here{static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f};
            shown.push_back(shown_at(there, size, here + glm::vec2(vectors.get(0, x, y), vectors.get(1, x, y))));
        }
    return shown;
}

FilmContents everything(std::size_t pixels) { return FilmContents(pixels, shows_light | shows_alpha); }
FilmContents contents_of(SeenFrame const& seen) { return seen.film.empty() ? everything(seen.image.pixels()) : seen.film; }

/// What a frame's pixels find in the next one, by the vectors that a denoiser of later frames goes by.
FilmContents shown_next(FilmContents const& there, SeenFrame& seen, SeenFrame& next, io::ChannelNames const& names) {
    if (auto const vectors = seen.guide(motion_next, names)) return shown_where(there, seen.image.size, vectors->view(motion_next));
    auto const back = next.guide(motion, names), depths = next.guide(depth, names);
    if (!back || !depths) return FilmContents(there.size(), 0);
    ImageOf<Planar<>, MotionNext> const vectors(seen.image.size);
    invert_motion(vectors.view(), back->view(motion), depths->view(depth));
    return shown_where(there, seen.image.size, vectors.view());
}

} // namespace

void limit_alpha(std::vector<float>& denoised, std::vector<float> const& alpha, Extent size) {
    constexpr int radius = 3;
    auto const least = extreme_within(alpha, size, radius, [](float a, float b) { return std::min(a, b); });
    auto const most = extreme_within(alpha, size, radius, [](float a, float b) { return std::max(a, b); });
    for (std::size_t i = 0; i < denoised.size(); ++i) denoised[i] = std::clamp(denoised[i], least[i], most[i]);
}

FilmContents film_contents(LinearView const& colours, std::vector<float> const& alpha) {
    FilmContents contents;
    contents.reserve(alpha.size());
    auto const is_something = [](float a) { return a != 0.f && is_finite(a); };
    for (std::size_t i = 0; i < alpha.size(); ++i) {
        auto const c = colours[i];
        contents.push_back(static_cast<FilmContent>((is_something(c.x) || is_something(c.y) || is_something(c.z) ? shows_light : 0) |
                                                    (is_something(alpha[i]) ? shows_alpha : 0)));
    }
    return contents;
}

FilmContents shown_from_now_on(std::deque<SeenFrame>& window, int later, io::ChannelNames const& names) {
    auto const& seen = window.front();
    auto shown = shown_around(contents_of(seen), seen.image.size);
    FilmContents ahead(shown.size(), 0); // in the frames after the k-th
    for (auto k = std::min(window.size() - 1, static_cast<std::size_t>(later)); k > 0; --k) {
        auto const there = contents_of(window[k]);
        for (std::size_t i = 0; i < ahead.size(); ++i) ahead[i] |= there[i];
        ahead = shown_next(ahead, window[k - 1], window[k], names);
    }
    for (std::size_t i = 0; i < shown.size(); ++i) shown[i] |= ahead[i];
    return shown;
}

void FilmAlpha::clear_empty(DenoisedFrame& frame, FilmContents const& shown, LoadedChannelPointer const& vectors) {
    if (!(size == frame.picture.size)) past.clear();
    size = frame.picture.size;
    if (!vectors) past.clear();
    if (!shown.empty()) {
        auto const before = past.empty() ? FilmContents(shown.size(), 0) : shown_where(past, size, vectors->view(motion));
        for (std::size_t i = 0; i < shown.size(); ++i) {
            auto const any = shown[i] | before[i];
            if ((any & shows_alpha) == 0) frame.alpha[i] = 0.f;
            if (any != 0) continue;
            frame.picture[i] = glm::vec3(0.f);
            for (auto& signal : frame.signals) signal[i] = glm::vec3(0.f);
        }
    }
    past = film_contents(frame.picture, frame.alpha);
}

} // namespace quell::examples
