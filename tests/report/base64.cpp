#include "report/base64.hpp"

#include <doctest/doctest.h>

#include <string_view>

namespace {

std::string encode(std::string_view text) {
    return quell::examples::encode_base64({reinterpret_cast<unsigned char const*>(text.data()), text.size()});
}

} // namespace

TEST_CASE("base64 gives what RFC 4648 lists for every length of the last group") {
    CHECK(encode("") == "");
    CHECK(encode("f") == "Zg==");
    CHECK(encode("fo") == "Zm8=");
    CHECK(encode("foo") == "Zm9v");
    CHECK(encode("foobar") == "Zm9vYmFy");
}

TEST_CASE("base64 takes bytes above 127 and uses its last two digits") {
    CHECK(encode("\xff\xff\xfe") == "///+");
    CHECK(encode("\xfb") == "+w==");
}
