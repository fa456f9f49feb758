// A host with a denoiser of its own, such as a network: quell accumulates light and guides over frames, and hands them to it.
#include <quell/quell.hpp>

#include <cmath>
#include <cstdio>
#include <random>
#include <vector>

constexpr auto accumulate = quell::presets::accumulated(quell::radiance, quell::Demodulate{});

/// What a denoiser behind quell gets: R, G, B of a pixel side by side, rows from the top, as networks want them.
struct Handed {
    int width, height;
    std::vector<float> colour, albedo, normal;
};

/// The pixels of any of quell's images.
std::vector<float> pixels_of(auto const& image) {
    std::vector<float> pixels;
    for (int y = 0; y < image.size.height; ++y)
        for (int x = 0; x < image.size.width; ++x)
            for (int c = 0; c < 3; ++c) pixels.push_back(image.get(c, x, y));
    return pixels;
}

/// Accumulates one more frame, and returns what `denoiser` makes of it.
/// @param denoiser takes a Handed and returns R, G, B of its pixels
std::vector<float> denoised(auto const& frame, auto& history, auto const& denoiser) {
    auto const colour = quell::run(accumulate, frame, history);
    return denoiser(Handed{frame.size.width, frame.size.height, pixels_of(colour), pixels_of(history[quell::mean_albedo]),
                           pixels_of(history[quell::mean_normal])});
}

/// Stands for a path tracer: a floor of two colours and a wall, in noisy light.
void render(auto& frame) {
    static std::mt19937 random(1);
    std::uniform_real_distribution<float> light(0.f, 2.f);
    for (int y = 0; y < frame.size.height; ++y)
        for (int x = 0; x < frame.size.width; ++x) {
            bool const is_floor = y > frame.size.height / 2;
            float const colour = is_floor && x / 8 % 2 == 0 ? 0.2f : 0.8f;
            frame[quell::radiance].set(x, y, glm::vec3(colour * light(random)));
            frame[quell::albedo].set(x, y, glm::vec3(colour));
            frame[quell::normal].set(x, y, is_floor ? glm::vec3(0, 1, 0) : glm::vec3(0, 0, 1));
            frame[quell::depth].set(x, y, 3.f);
            frame[quell::motion].set(x, y, {0, 0});
        }
}

/// Stands for the host's denoiser: the mean of the pixels around whose guides are alike. A call of OIDN's C interface goes here: its filter
/// "RT" with the images "color", "albedo" and "normal", and "hdr" set.
std::vector<float> own_denoiser(Handed const& in) {
    auto const at = [&](int x, int y) { return static_cast<std::size_t>(3 * (y * in.width + x)); };
    std::vector<float> out(in.colour.size());
    for (int y = 0; y < in.height; ++y)
        for (int x = 0; x < in.width; ++x) {
            float sum[3] = {}, weights = 0.f;
            for (int v = std::max(y - 3, 0); v <= std::min(y + 3, in.height - 1); ++v)
                for (int u = std::max(x - 3, 0); u <= std::min(x + 3, in.width - 1); ++u) {
                    float off = 0.f;
                    for (std::size_t c = 0; c < 3; ++c)
                        off += std::abs(in.albedo[at(u, v) + c] - in.albedo[at(x, y) + c]) +
                               std::abs(in.normal[at(u, v) + c] - in.normal[at(x, y) + c]);
                    float const weight = std::exp(-8.f * off);
                    for (std::size_t c = 0; c < 3; ++c) sum[c] += weight * in.colour[at(u, v) + c];
                    weights += weight;
                }
            for (std::size_t c = 0; c < 3; ++c) out[at(x, y) + c] = sum[c] / weights;
        }
    return out;
}

/// Root mean squared difference to the light that `render` draws from, which is 1.
float error_of(std::vector<float> const& picture, auto const& frame) {
    auto const albedo = pixels_of(frame[quell::albedo].view());
    float sum = 0.f;
    for (std::size_t i = 0; i < picture.size(); ++i) sum += (picture[i] - albedo[i]) * (picture[i] - albedo[i]);
    return std::sqrt(sum / static_cast<float>(picture.size()));
}

int main() {
    quell::Extent const size{96, 64};
    quell::Frame frame{size, accumulate};
    quell::History history{size, accumulate};
    std::vector<float> alone, behind;
    for (int i = 0; i < 8; ++i) {
        render(frame);
        alone = own_denoiser({size.width, size.height, pixels_of(frame[quell::radiance].view()), pixels_of(frame[quell::albedo].view()),
                              pixels_of(frame[quell::normal].view())});
        behind = denoised(frame, history, own_denoiser);
    }
    std::printf("error of the denoiser alone %.3f, behind quell %.3f\n", static_cast<double>(error_of(alone, frame)),
                static_cast<double>(error_of(behind, frame)));
}
