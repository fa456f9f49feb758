#include "../io/files.hpp"

#include <library/name_list.hpp>
#include <support/csv.hpp>
#include <support/frame_pattern.hpp>
#include <support/output_folder.hpp>
#include <support/program.hpp>
#include <support/size_in.hpp>

#include <CLI/CLI.hpp>

#include <cstdio>
#include <fcntl.h>
#include <new>
#include <unistd.h>

using namespace quell;
using namespace quell::tests;
using quell::examples::FramePattern;

namespace {
/// What something writes on stderr.
std::string said_by(auto const& something) {
    Folder const folder;
    std::fflush(stderr);
    int const usual = ::dup(STDERR_FILENO), file = ::open((folder / "err").c_str(), O_WRONLY | O_CREAT, 0600);
    ::dup2(file, STDERR_FILENO);
    something();
    std::fflush(stderr);
    ::dup2(usual, STDERR_FILENO);
    ::close(file), ::close(usual);
    return bytes_of(folder / "err");
}

int threads_in(std::string const& text) {
    CLI::App app;
    int threads = 3;
    quell::examples::add_threads(app, threads);
    std::vector<char const*> const words{"program", "--threads", text.c_str()};
    static_cast<void>(quell::examples::parse(app, static_cast<int>(words.size()), words.data()));
    return threads;
}
} // namespace

TEST_CASE("a frame's number stands where the pattern says") {
    CHECK(FramePattern("a/b.%04d.exr").path(7) == "a/b.0007.exr");
    CHECK(FramePattern("b%d").path(123) == "b123");
    CHECK(FramePattern("%03d.exr").path(12345) == "12345.exr");
    CHECK(FramePattern("f_%04d_x.exr").path(-5) == "f_-005_x.exr");
    CHECK(FramePattern("a/b.####.exr").path(7) == "a/b.0007.exr");
    CHECK(FramePattern("f_####_x.exr").path(-5) == "f_-005_x.exr");
    CHECK(FramePattern("b#").path(123) == "b123");
    CHECK(FramePattern("take #2.%03d.exr").path(7) == "take #2.007.exr");
    CHECK(FramePattern("a#b/c.###").path(7) == "a#b/c.007");
}

TEST_CASE("patterns without one place for the number are refused") {
    for (auto const* const pattern : {"frame.exr", "a%d/frame.exr", "f.%d.%d.exr", "f.%s.exr", "f.%4d.exr", "f.%%04d.exr", "", "%",
                                      "f.%0d.exr", "a####/frame.exr", "f.##.##.exr", "f.%.####.exr"}) {
        INFO(pattern);
        check_error([&] { FramePattern const p(pattern); }, {pattern, "write %04d or #### once"});
    }
}

TEST_CASE("a pattern of any length has its place found") {
    std::string const many(100'000, 'f');
    CHECK(FramePattern(many + "%03d" + many).path(5) == many + "005" + many);
    check_error([&] { FramePattern const p(many); }, {"write %04d or #### once"});
}

TEST_CASE("results that would take the place of another pattern's files are refused") {
    using quell::examples::check_keeps;
    Folder const folder;
    std::filesystem::create_directories(folder / "in/more");
    std::filesystem::create_directory_symlink(folder / "in", folder / "link");
    write_bytes(folder / "in/more/aside.10.exr", "x");
    std::filesystem::create_symlink(folder / "in/more/aside.10.exr", folder / "in/f.0010.exr");
    FramePattern const kept((folder / "in/f.%04d.exr").string());
    auto const check = [&](std::string const& out, std::vector<long long> const& numbers) {
        return message_of([&] { check_keeps(kept, "the frames", FramePattern((folder / out).string()), numbers); });
    };
    CHECK(check("in/g.%04d.exr", {1, 2}).empty());
    CHECK(check("f.%04d.exr", {1, 2}).empty());
    CHECK(check("in/f.%02d.exr", {1, 99}).empty());
    CHECK(contains(check("in/f.%02d.exr", {1, 99, 1000}), "f.1000.exr would take the place of one of the frames"));
    CHECK(contains(check("in/f.%04d.exr", {1}), "f.0001.exr"));
    CHECK(contains(check("in/f.00%d.exr", {1, 10}), "f.0010.exr"));
    CHECK(contains(check("link/more/../f.%04d.exr", {1}), "f.0001.exr"));
    CHECK(check("in/more/aside.%d.exr", {9, 11}).empty());
    CHECK(contains(check("in/more/aside.%d.exr", {9, 10, 11}), "aside.10.exr"));
}

TEST_CASE("the frames on disk are those that the pattern itself would name") {
    Folder const folder;
    for (auto const* const name : {"f.0003.exr", "f.0001.exr", "f.12345.exr", "f.1.exr", "f.00007.exr", "f.0002.exr.123.partial",
                                   "g.0004.exr", "f.x.exr", "f..exr", "f.-001.exr"})
        write_bytes(folder / name, "x");
    CHECK(FramePattern((folder / "f.%04d.exr").string()).on_disk() == std::vector<long long>{-1, 1, 3, 12345});
    CHECK(FramePattern((folder / "f.####.exr").string()).on_disk() == std::vector<long long>{-1, 1, 3, 12345});
    CHECK(FramePattern((folder / "h.%04d.exr").string()).on_disk().empty());
    CHECK(FramePattern((folder / "nowhere/h.%04d.exr").string()).on_disk().empty());
}

TEST_CASE("a cell of a table is quoted where its text would break the row") {
    using quell::examples::csv_cell;
    for (auto const* const plain : {"", "room", "a b.glb", "-1.5e3", "it's"}) CHECK(csv_cell(plain) == plain);
    CHECK(csv_cell("a,b.glb") == "\"a,b.glb\"");
    CHECK(csv_cell("the \"best\"") == "\"the \"\"best\"\"\"");
    CHECK(csv_cell("two\nlines") == "\"two\nlines\"");
    CHECK(csv_cell("two\r\nlines") == "\"two\r\nlines\"");
}

TEST_CASE("what a program throws decides its exit code") {
    using quell::examples::exit_code_of;
    CHECK(exit_code_of("test", [] {}) == 0);
    CHECK(exit_code_of("test (this line is meant to be here)", [] { throw Error("a", "b", "c"); }) == 2);
    CHECK(exit_code_of("test (this line is meant to be here)", [] { throw Failure("a", "b", "c"); }) == 1);
    CHECK(exit_code_of("test (this line is meant to be here)", [] { throw std::runtime_error("two\nlines"); }) == 1);
    CHECK(exit_code_of("test (this line is meant to be here)", [] { throw 7; }) == 1);
}

TEST_CASE("memory that runs out is told in words") {
    using quell::examples::exit_code_of;
    int code = 0;
    auto const said = said_by([&] { code = exit_code_of("test", [] { throw std::bad_alloc(); }); });
    CHECK(code == 1);
    CHECK(contains(said, "test: memory: "));
    CHECK(contains(said, "smaller --size"));
    CHECK(!contains(said, "bad_alloc"));
    auto const advised = said_by([&] {
        code = exit_code_of(
            "test", [] { throw std::bad_alloc(); }, "take a smaller file");
    });
    CHECK(contains(advised, "not enough of it; take a smaller file"));
    CHECK(!contains(advised, "--size"));
}

TEST_CASE("a size is two numbers, of no more pixels than memory may have") {
    using quell::examples::size_in;
    CHECK(size_in("1920x1080") == Extent{1920, 1080});
    CHECK(size_in("8192x8192") == Extent{8192, 8192});
    for (std::string const text : {"", "16", "16x", "0x5", "-4x5", "16x9x", "8192x8193", "99999x99999"}) {
        INFO(text);
        check_error([&] { static_cast<void>(size_in(text)); }, {"--size", "'" + text + "'", "1920x1080"});
    }
    check_error([] { static_cast<void>(size_in("8x20", 16)); }, {"each at least 16"});
    check_error([] { static_cast<void>(size_in("5x4", 1, 19)); }, {"at most 19 together"});
}

TEST_CASE("threads are 0, which means all, or as many as an arena may have") {
    CHECK(threads_in("0") == 0);
    CHECK(threads_in("1024") == 1024);
    for (std::string const text : {"-1", "1025", "70000", "x"}) {
        INFO(text);
        check_error([&] { threads_in(text); }, {"--threads", text});
    }
}

TEST_CASE("where results go is made, and known to take files before there are any") {
    using quell::examples::make_folder_for;
    using quell::examples::make_output_folder;
    Folder const folder;
    make_output_folder(folder / "a/b");
    make_output_folder(folder / "a/b");
    make_folder_for(folder / "c/d/file.hpp");
    CHECK(std::filesystem::is_empty(folder / "a/b"));
    CHECK(std::filesystem::is_empty(folder / "c/d"));
    write_bytes(folder / "file", "x");
    check_error([&] { make_output_folder(folder / "file"); }, {"file", "the folder can't be made"});
    check_error([&] { make_output_folder(folder / "file/b"); }, {"file/b", "the folder can't be made"});
    check_error([&] { make_folder_for(folder / "file/b.hpp"); }, {"file", "the folder can't be made"});
    check_error([&] { make_folder_for(folder / "a"); }, {"a", "it is a folder"});
    check_error([] { make_output_folder("/proc"); }, {"/proc: ", "no file can be written there"}); // also for root
}

TEST_CASE("each of several scenes has a folder of its own, or there is a word on it") {
    using quell::examples::folders_of_scenes;
    using Folders = std::vector<std::filesystem::path>;
    CHECK(folders_of_scenes("out", {"a/x.glb"}) == Folders{"out"});
    CHECK(folders_of_scenes("out", {"a/x.glb", "room"}) == Folders{"out/x", "out/room"});
    check_error(
        [] {
            static_cast<void>(folders_of_scenes("out", {"a/x.glb", "room", "b/x.gltf"}));
        },
        {"--scene", "'a/x.glb' and 'b/x.gltf'", "out/x", "--out"});
}

TEST_CASE("a build option that names presets chooses these, whole names only, and all where it is empty") {
    using quell_library::any_name, quell_library::is_chosen;
    static_assert(is_chosen("", "svgf") && is_chosen("svgf", "svgf") && is_chosen("trmv,svgf,blur", "svgf"));
    static_assert(!is_chosen("asvgf", "svgf") && !is_chosen("svgf", "asvgf") && !is_chosen("blur-straight,trmv", "blur"));
    std::vector<std::string> seen;
    CHECK_FALSE(any_name("a,b,c", [&](auto name) { return seen.emplace_back(name), false; }));
    CHECK(seen == std::vector<std::string>{"a", "b", "c"});
    CHECK_FALSE(any_name("", [](auto) { return true; }));
}
