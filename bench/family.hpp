#pragma once

#include "timed.hpp"

#include <memory>
#include <string>
#include <vector>

namespace quell::bench {

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

protected:
    std::vector<Seconds> taken;

private:
    std::size_t at = 0;
};

/// A preset with a storage for its history: what generated files instantiate. All else is common code.
struct Family {
    std::string preset;
    std::size_t order = 0; ///< the preset's place in quell::named_presets
    std::string storage;
    bool has_serial = false;
    std::vector<std::string> passes;
    std::unique_ptr<Workload> (*make)(Extent) = nullptr;
};

/// All presets with each storage, in the order of quell::named_presets. Without the tracer, only those that read what Input has.
std::vector<Family> families();
/// Every `units`-th of them from number `unit` on, with one storage: in a generated file.
template <class Storage, std::size_t unit, std::size_t units> std::vector<Family> families_of_unit();

/// A warm workload. Only the last one asked for is kept: at 1920x1080 they are large.
Workload& workload(Family const& family, Extent size);

} // namespace quell::bench
