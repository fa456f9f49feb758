#pragma once

#include <quell/execute/queue_executor.hpp>
#include <quell/image/memory.hpp>
#include <quell/resolve/evidence.hpp>
#include <quell/resolve/mean_brightness.hpp>

#include <limits>
#include <memory>

namespace quell::inline QUELL_INSTRUCTION_SET {

namespace detail {
/// Copies a channel, without the samples that leave_out() takes out.
template <class From, class To> struct CopyAllBut {
    static constexpr auto name = "copy";
    From from;
    To to;
    int left_out;

    template <class Real> QUELL_KERNEL void operator()(AtOnce<Real>, int x, int y, int count) const {
        store_pixels<Real>(to, x, y, load_pixels<Real>(from, x, y), count);
        if (left_out < 0) return;
        for (int i = x + (x + y + left_out) % 2; i < x + count; i += 2)
            for (int c = 0; c < To::components; ++c) to.set(c, i, y, std::numeric_limits<float>::quiet_NaN());
    }
};

/// Numbers in planes of an image's size, row by row. The fourth one is there for a rule with doubt alone.
struct NumberPlanes {
    double* planes[4];
    Extent size;

    QUELL_KERNEL double* row(int plane, int y) const {
        return planes[plane] + static_cast<std::ptrdiff_t>(y) * static_cast<std::ptrdiff_t>(size.width);
    }
};

/// What the samples of one half of the checkerboard say.
template <class Samples, class A, class B, class BWith> struct EvidenceJob {
    static constexpr auto name = "evidence";
    Evidence rule;
    int left_out;
    Samples samples;
    A a;
    B b;
    BWith b_with;
    double const* mean; ///< of the picture's luminance
    NumberPlanes to;

    template <class Real> QUELL_KERNEL void operator()(AtOnce<Real>, int x, int y, int count) const {
        auto const bright = static_cast<float>(*mean);
        for (int i = x + (x + y + left_out) % 2; i < x + count; i += 2) {
            auto const said =
                evidence_of(rule, bright, colour_at(samples, i, y), colour_at(a, i, y), colour_at(b, i, y), colour_at(b_with, i, y));
            to.row(0, y)[i] = said.product, to.row(1, y)[i] = said.square, to.row(2, y)[i] = said.noise;
            if (rule.doubt > 0.f) to.row(3, y)[i] = said.own;
        }
    }
};
/// Each number becomes the sum of those to its left and itself, in all rows of the planes, one row after the other.
struct SumAlongRows {
    static constexpr auto name = "evidence, rows";
    NumberPlanes of;

    template <class Real> QUELL_KERNEL void operator()(AtOnce<Real>, int, int y, int) const {
        auto* const row = of.row(y / of.size.height, y % of.size.height);
        double sum = 0.;
        for (int x = 0; x < of.size.width; ++x) row[x] = sum += row[x];
    }
};
/// Sums over windows of rows, and of all rows above: from the first plane to the second. A pixel of its region, which is a row or a column
/// of pixels, is so many columns.
struct SumDownColumns {
    static constexpr auto name = "evidence, columns";
    NumberPlanes of;
    int radius, columns;

    template <class Real> QUELL_KERNEL void operator()(AtOnce<Real>, int x_group, int y_group, int) const {
        int const width = of.size.width, first = (x_group + y_group) * columns, end = first + columns < width ? first + columns : width;
        for (int y = 0; y < of.size.height; ++y)
            for (int x = first; x < end; ++x) {
                auto const* const row = of.row(0, y);
                double const before = x - radius > 0 ? row[x - radius - 1] : 0.;
                double const here = row[x + radius < width ? x + radius : width - 1] - before;
                of.row(1, y)[x] = (y > 0 ? of.row(1, y - 1)[x] : 0.) + here;
            }
    }
};
/// Puts both estimates together. Alpha is that of the first.
template <class A, class B, class To> struct MixByEvidence {
    static constexpr auto name = "mix by evidence";
    Evidence rule;
    NumberPlanes sums;
    A a;
    B b;
    To to;

    template <class Real> QUELL_KERNEL void operator()(AtOnce<Real>, int x, int y, int count) const {
        for (int i = x; i < x + count; ++i) {
            double const own = rule.doubt > 0.f ? around(3, i, y) : 0.;
            float const part = part_of_first(rule, {around(0, i, y), around(1, i, y), around(2, i, y), own});
            for (int c = 0; c < To::components; ++c) {
                float const first = a.get(c, i, y), second = b.get(c, i, y);
                to.set(c, i, y, c < 3 ? second + (first - second) * part : first);
            }
        }
    }

private:
    QUELL_KERNEL double around(int plane, int x, int y) const {
        int const last = sums.size.height - 1;
        double const before = y - rule.radius > 0 ? sums.row(plane, y - rule.radius - 1)[x] : 0.;
        return sums.row(plane, y + rule.radius < last ? y + rule.radius : last)[x] - before;
    }
};
} // namespace detail

/// Puts two estimates of a picture together by Evidence, in passes of an executor. For hosts with estimates of their own; that of a
/// pipeline with its history and without is a ByEvidence.
///
///     EvidenceMix<> mix;
///     for (int const left_out : {0, 1}) { /* make a and b without the samples that leave_out() takes out */
///         mix.judge(rule, executor, left_out, samples, a, b, b_with); }
///     mix.mix(rule, executor, a_with, b_with, to);
///
/// Views have one component, three, or four of which the last is alpha: it is not judged, and stays that of the first estimate. Memory is
/// taken by the first frame, and where their size changes: 32 bytes a pixel, 40 for a rule with doubt. The result does not depend on the
/// executor's threads.
/// @tparam Memory where sums lie
template <ImageMemory Memory = HostMemory> class EvidenceMix {
    struct Release {
        void operator()(double* numbers) const { Memory::release(numbers); }
    };
    std::unique_ptr<double[], Release> numbers;
    Extent size{0, 0};
    int sums = 3; ///< that the rule wants; one plane more is there, to write to

public:
    /// Looks at the samples of one half of the checkerboard. Both halves have to be looked at before mix().
    /// @param rule     how terms weigh
    /// @param executor runs the pass
    /// @param left_out pixels whose x + y is even (0) or odd (1), which the estimates were made without
    /// @param samples  a view of all samples
    /// @param a        a view of the first estimate, without these
    /// @param b        of the second one
    /// @param b_with   of the second one, made of all samples
    /// @throws Error where sizes differ, std::bad_alloc
    template <Executor E>
    void judge(Evidence const& rule, E const& executor, int left_out, ImageView auto const& samples, ImageView auto const& a,
               ImageView auto const& b, ImageView auto const& b_with) {
        take(samples.size, sums_of(rule));
        check("the first estimate without samples", a.size);
        check("the second estimate without samples", b.size);
        check("the second estimate", b_with.size);
        detail::EvidenceJob<std::remove_cvref_t<decltype(samples)>, std::remove_cvref_t<decltype(a)>, std::remove_cvref_t<decltype(b)>,
                            std::remove_cvref_t<decltype(b_with)>> const job{rule, left_out, samples, a, b, b_with, plane(sums), planes(0)};
        // The plane that mix() writes to is free.
        detail::run_or_enqueue(executor, Region{0, 0, 1, size.height},
                               detail::BrightnessOfRows<std::remove_cvref_t<decltype(b_with)>>{b_with, plane(sums)});
        detail::run_or_enqueue(executor, Region{0, 0, 1, 1}, detail::MeanBrightness{plane(sums), size});
        detail::run_or_enqueue(executor, Region{0, 0, size.width, size.height}, job);
    }
    /// Writes the picture that the samples speak for.
    /// @param rule     how
    /// @param executor runs the passes
    /// @param a        a view of the first estimate, made of all samples
    /// @param b        of the second one
    /// @param to       a view to write; it may be that of an estimate
    /// @throws Error where sizes differ from those of the samples, or where the rule has doubt and that of judge() had none
    template <Executor E>
    void mix(Evidence const& rule, E const& executor, ImageView auto const& a, ImageView auto const& b, ImageView auto const& to) {
        check("the first estimate", a.size);
        check("the second estimate", b.size);
        check("the target", to.size);
        if (sums < sums_of(rule))
            raise_error("EvidenceMix: the rule", "it has doubt, and samples were looked at by one without", "give judge() the same rule");
        detail::run_or_enqueue(executor, Region{0, 0, 1, sums * size.height}, detail::SumAlongRows{planes(0)});
        // Many columns at once are few lines of the cache; a device wants many threads, and neighbours in a row of them.
        constexpr bool on_device = QueueExecutor<E>;
        int const columns = on_device ? 1 : 32, groups = (size.width + columns - 1) / columns;
        Region const all_columns{0, 0, on_device ? groups : 1, on_device ? 1 : groups};
        // A plane that was read is where the next one goes.
        for (int plane = 0; plane < sums; ++plane)
            detail::run_or_enqueue(executor, all_columns, detail::SumDownColumns{from_to(plane), rule.radius, columns});
        detail::MixByEvidence<std::remove_cvref_t<decltype(a)>, std::remove_cvref_t<decltype(b)>, std::remove_cvref_t<decltype(to)>> const
            job{rule, planes(sums), a, b, to};
        detail::run_or_enqueue(executor, Region{0, 0, size.width, size.height}, job);
        detail::submit_queue(executor);
    }
    /// Gives its memory back.
    void release() { numbers.reset(), size = {0, 0}; }
    /// What it takes.
    [[nodiscard]] std::size_t bytes() const { return numbers ? bytes_of(size, sums) : 0; }

private:
    static int sums_of(Evidence const& rule) { return rule.doubt > 0.f ? 4 : 3; }
    static std::size_t bytes_of(Extent size, int sums) {
        return (static_cast<std::size_t>(sums) + 1) * sizeof(double) * static_cast<std::size_t>(size.pixels());
    }
    void take(Extent wanted, int wanted_sums) {
        if (wanted == size && wanted_sums == sums) return;
        release();
        numbers.reset(static_cast<double*>(Memory::allocate(bytes_of(wanted, wanted_sums))));
        size = wanted, sums = wanted_sums;
    }
    void check(char const* what, Extent its) const {
        if (!(its == size))
            raise_error(std::string("EvidenceMix: ") + what, to_string(its) + " beside samples of " + to_string(size),
                        "give it the samples' size");
    }
    [[nodiscard]] double* plane(int which) const { return numbers.get() + static_cast<std::ptrdiff_t>(which % (sums + 1)) * size.pixels(); }
    /// All sums from that plane on.
    [[nodiscard]] detail::NumberPlanes planes(int first) const {
        return {{plane(first), plane(first + 1), plane(first + 2), plane(first + 3)}, size};
    }
    /// A plane that is read, and that before it, which has been read.
    [[nodiscard]] detail::NumberPlanes from_to(int which) const { return {{plane(which), plane(which + sums), nullptr, nullptr}, size}; }
};

} // namespace quell::inline QUELL_INSTRUCTION_SET
