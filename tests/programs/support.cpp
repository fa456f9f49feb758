#include "../io/files.hpp"

#include <support/frame_pattern.hpp>
#include <support/program.hpp>

using namespace quell;
using namespace quell::tests;
using quell::examples::FramePattern;

TEST_CASE("a frame's number stands where the pattern says") {
    CHECK(FramePattern("a/b.%04d.exr").path(7) == "a/b.0007.exr");
    CHECK(FramePattern("b%d").path(123) == "b123");
    CHECK(FramePattern("%03d.exr").path(12345) == "12345.exr");
    CHECK(FramePattern("f_%04d_x.exr").path(-5) == "f_-005_x.exr");
}

TEST_CASE("patterns without one place for the number are refused") {
    for (auto const* const pattern :
         {"frame.exr", "a%d/frame.exr", "f.%d.%d.exr", "f.%s.exr", "f.%4d.exr", "f.%%04d.exr", "", "%", "f.%0d.exr"}) {
        INFO(pattern);
        check_error([&] { FramePattern const p(pattern); }, {pattern, "write %04d once"});
    }
}

TEST_CASE("the frames on disk are those that the pattern itself would name") {
    Folder const folder;
    for (auto const* const name : {"f.0003.exr", "f.0001.exr", "f.12345.exr", "f.1.exr", "f.00007.exr", "f.0002.exr.123.partial",
                                   "g.0004.exr", "f.x.exr", "f..exr", "f.-001.exr"})
        write_bytes(folder / name, "x");
    CHECK(FramePattern((folder / "f.%04d.exr").string()).on_disk() == std::vector<long long>{-1, 1, 3, 12345});
    CHECK(FramePattern((folder / "h.%04d.exr").string()).on_disk().empty());
    CHECK(FramePattern((folder / "nowhere/h.%04d.exr").string()).on_disk().empty());
}

TEST_CASE("what a program throws decides its exit code") {
    using quell::examples::exit_code_of;
    CHECK(exit_code_of("test", [] {}) == 0);
    CHECK(exit_code_of("test (this line is meant to be here)", [] { throw Error("a", "b", "c"); }) == 2);
    CHECK(exit_code_of("test (this line is meant to be here)", [] { throw std::runtime_error("two\nlines"); }) == 1);
    CHECK(exit_code_of("test (this line is meant to be here)", [] { throw 7; }) == 1);
}
