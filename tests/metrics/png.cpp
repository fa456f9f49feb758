#include "../temporary_folder.hpp"
#include "pictures.hpp"
#include "read_png.hpp"

#include <support/png.hpp>

using namespace pictures;
using namespace quell::examples;

namespace {

/// A file of this test alone, gone at the end of the test.
struct File {
    quell::tests::Folder folder;
    std::filesystem::path path = folder / "picture.png";
    void hold(std::vector<unsigned char> const& bytes) const { quell::tests::write_bytes(path, {bytes.begin(), bytes.end()}); }
};

} // namespace

TEST_CASE("png: every 8-bit value comes back as it was") {
    auto picture = constant({16, 16}, {});
    for (std::size_t i = 0; i < 256; ++i) picture.pixels[i] = glm::vec3(i, 255 - i, i / 2) / 255.f;
    File const file;
    write_png(file.path, picture);
    auto const back = read_png(file.path);
    CHECK(back.size == picture.size);
    CHECK(back.pixels == picture.pixels);
}

TEST_CASE("png: components are rounded to the nearest of 256 values") {
    File const file;
    write_png(file.path, {{1, 1}, {{0.4f / 255.f, 0.6f / 255.f, 254.6f / 255.f}}});
    CHECK(read_png(file.path).pixels[0] == glm::vec3(0.f, 1.f, 255.f) / 255.f);
}

TEST_CASE("png: the encoded bytes are the file") {
    auto const picture = noise({13, 9}, 4);
    auto const bytes = encode_png(picture);
    File const file;
    write_png(file.path, picture);
    CHECK(std::filesystem::file_size(file.path) == bytes.size());
    file.hold(bytes);
    CHECK(read_png(file.path).size == picture.size);
}

TEST_CASE("png: a file is replaced by another, not written over") {
    File const file;
    auto const before = encode_png(noise({13, 9}, 4));
    file.hold(before);
    auto const held = file.folder / "held.png"; // a second name of the same bytes
    std::filesystem::create_hard_link(file.path, held);
    write_png(file.path, noise({9, 13}, 5));
    CHECK(read_png(file.path).size == Extent{9, 13});
    CHECK(read_png(held).size == Extent{13, 9});
}

TEST_CASE("png: errors name the file") {
    auto const picture = noise({13, 9}, 4);
    CHECK(refuses([&] { write_png("/nowhere/at_all.png", picture); }, {"/nowhere/at_all.png", "can't be written", "No such file"}));
    File const file;
    auto broken = picture;
    broken.pixels[14].x = 1.5f;
    CHECK(refuses([&] { write_png(file.path, broken); }, {file.path.string(), "(1, 1)", "1.5"}));
    CHECK(refuses([&] { (void)encode_png({}); }, {"0x0"}));
}
