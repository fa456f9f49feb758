#pragma once

#include "timed.hpp"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace quell::bench {

/// What families on a GPU have in a storage's place.
inline constexpr auto cuda_storage = "cuda";
/// The storage that all is compared with.
inline constexpr auto reference_storage = "planar-float";

/// A preset with a history of its own, ready to run frame after frame.
class Workload {
public:
    virtual ~Workload() = default;
    /// @param frame of the sequence
    virtual void run(std::size_t frame, How how) = 0;
    [[nodiscard]] virtual double bytes_per_pixel() const = 0;
    /// What the passes of the last frame took.
    [[nodiscard]] std::vector<Seconds> const& passes() const { return taken; }

    /// The next frame of the sequence. Returns the whole frame's time.
    Seconds next(How how);
    /// Until histories are long.
    void warm_up();
    std::unique_ptr<Workload> serial; ///< the same, one pixel after the other, where there is that

protected:
    std::vector<Seconds> taken;

private:
    std::size_t at = 0;
};

/// A preset with a storage for its history. All else is common code.
struct Family {
    std::string preset;
    std::string storage;
    std::vector<std::string> passes;
    /// In packs; null where generated code has one pixel after the other alone.
    std::function<std::unique_ptr<Workload>(Extent)> make{};
    std::unique_ptr<Workload> (*make_serial)(Extent) = nullptr; ///< one pixel after the other; null where it is not compiled

    [[nodiscard]] bool has_serial() const { return make_serial != nullptr; }
};

/// The names under which passes are reported: no spaces, and several of one name numbered.
std::vector<std::string> pass_names(std::vector<std::string> const& passes);

/// All presets with each storage, in the order of quell::all_presets.
std::vector<Family> families();
/// Those with the reference storage, in packs: compiled presets.
std::vector<Family> compiled_families();
/// Those that run on a GPU. Their storage is called cuda.
/// @throws Error where the program was built without CUDA
std::vector<Family> cuda_families();
/// A share of those with another storage, or one pixel after the other, number `unit` of `units`: in a generated file.
template <class Storage, std::size_t unit, std::size_t units> std::vector<Family> families_of_unit();

/// A warm workload. Only the last one asked for is kept: at 1920x1080 they are large.
Workload& workload(Family const& family, Extent size);

} // namespace quell::bench
