// quell-gauntlet: small sequences, in each of which one assumption of a denoiser does not hold, each beside one in which all do.
//   quell-gauntlet [--scene sky-turns ...] [--samples 4,16] [--out out/gauntlet] [--check]
//   quell-gauntlet --smallest --check
#include <gauntlet/options.hpp>
#include <gauntlet/page.hpp>

#include <quell/core/error.hpp>
#include <support/output_folder.hpp>
#include <support/program.hpp>
#include <support/progress.hpp>

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <mutex>

using namespace quell::gauntlet;

namespace {

/// Rows that are wanted.
struct Wanted {
    Situation const* situation;
    int samples;
    std::filesystem::path sequence{}; ///< of files; empty: rendered
};

void check_names(std::vector<Situation> const& all, std::vector<std::string> const& names) {
    for (auto const& name : names)
        if (std::ranges::none_of(all, [&](auto const& each) { return each.name == name; }))
            throw quell::Error("--scene", "there is no situation " + name, "take one that --list names");
}

std::vector<Wanted> wanted_rows(std::vector<Situation> const& all, GauntletOptions const& options) {
    check_names(all, options.names);
    std::vector<Wanted> rows;
    for (auto const& each : all) {
        bool const is_named = std::ranges::find(options.names, each.name) != options.names.end();
        if (options.names.empty() ? options.smallest && !each.is_small : !is_named) continue;
        auto const samples = !options.samples.empty() ? options.samples : options.smallest ? std::vector{4} : each.samples;
        for (int const count : samples)
            if (is_named || std::ranges::find(each.samples, count) != each.samples.end()) rows.push_back({&each, count});
    }
    return rows;
}

/// Sequences of files as situations of their own, named by their folders.
std::vector<Situation> of_files(std::vector<std::filesystem::path> const& sequences) {
    std::vector<Situation> list;
    for (auto const& each : sequences) {
        auto const folder = std::filesystem::absolute(each / ".").lexically_normal().parent_path();
        int const samples = std::atoi(folder.filename().string().c_str());
        list.push_back({.name = folder.parent_path().filename().string(),
                        .about = "as files have it",
                        .shot = {},
                        .twin = "files",
                        .samples = {samples}});
    }
    return list;
}

Row run_one(Wanted const& wanted, GauntletOptions const& options, References& references) {
    auto making = options.making;
    making.samples = wanted.samples;
    auto const folder = options.out / "frames" / (wanted.situation->name + "." + std::to_string(wanted.samples));
    auto row = wanted.sequence.empty() ? run_row(*wanted.situation, making, references, options.denoise, folder)
                                       : run_sequence(*wanted.situation, wanted.sequence, options.denoise, folder);
    if (!options.keep) std::filesystem::remove_all(folder);
    return row;
}

/// All rows, several at once.
std::vector<Row> run_rows(std::vector<Wanted> const& wanted, GauntletOptions const& options) {
    std::vector<Row> rows(wanted.size());
    References references;
    quell::examples::Progress progress("quell-gauntlet", static_cast<long long>(wanted.size()), !options.quiet);
    std::mutex mutex;
    long long begun = 0;
    auto const work = [&](std::size_t i) {
        {
            std::scoped_lock const lock(mutex);
            progress.show(begun++, wanted[i].situation->name);
        }
        rows[i] = run_one(wanted[i], options, references);
    };
    tbb::task_arena arena(options.threads > 0 ? options.threads : tbb::task_arena::automatic);
    arena.execute([&] { tbb::parallel_for(std::size_t{0}, wanted.size(), work, tbb::simple_partitioner()); });
    return rows;
}

void store(std::vector<Row> const& rows, GauntletOptions const& options) {
    StoredFigures figures;
    for (auto const& row : rows)
        for (auto const& frame : row.frames)
            figures.add(
                row.situation->name, row.samples, frame.frame,
                {frame.error[by_none], frame.error[by_quick], frame.error[by_default], frame.right[by_default], frame.windows[by_quick]});
    figures.write(options.store, options.making);
}

int run(GauntletOptions const& options) {
    auto const all = situations();
    if (options.list) {
        for (auto const& each : all) std::cout << each.name << '\n';
        return 0;
    }
    quell::examples::make_output_folder(options.out);
    auto const before = StoredFigures::read(options.stored, options.making);
    if (before.is_empty())
        std::cerr << "quell-gauntlet: " << options.stored.string() << " has no figures of such frames: --quick is this program's\n";
    auto const files = of_files(options.sequences);
    std::vector<Wanted> wanted;
    for (std::size_t i = 0; i < files.size(); ++i) wanted.push_back({&files[i], files[i].samples.front(), options.sequences[i]});
    auto const rows = run_rows(files.empty() ? wanted_rows(all, options) : wanted, options);
    std::vector<Verdict> verdicts;
    std::cout << row_columns << '\n';
    for (auto const& row : rows) std::cout << line_of(row, verdicts.emplace_back(verdict_on(row, before))) << '\n';
    write_tables(rows, verdicts, options.out), write_page(rows, verdicts, options.out);
    if (!options.store.empty()) store(rows, options);
    bool held = std::ranges::all_of(verdicts, [](auto const& verdict) { return verdict.broken.empty(); });
    for (std::size_t i = 0; i < rows.size(); ++i)
        for (auto const& line : verdicts[i].broken) std::cerr << rows[i].name() << ": " << line << '\n';
    for (auto const& line : broken_together(rows, verdicts)) std::cerr << line << '\n', held = false;
    return options.check && !held ? 1 : 0;
}

} // namespace

int main(int argc, char** argv) {
    int code = 0;
    int const failed = quell::examples::exit_code_of("quell-gauntlet", [&] {
        if (auto const options = gauntlet_options(argc, argv)) code = run(*options);
    });
    return failed != 0 ? failed : code;
}
