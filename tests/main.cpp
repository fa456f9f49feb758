#define DOCTEST_CONFIG_IMPLEMENT
#include "shared_data.hpp"

#include <doctest/doctest.h>

int main(int count, char** arguments) {
    int const code = doctest::Context(count, arguments).run();
    return code == 0 && quell::tests::skipped ? 77 : code;
}
