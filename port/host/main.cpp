// The `osem` command-line tool.
#include <iostream>

#include "tool.hpp"

int main(int argc, char** argv) {
    std::ios::sync_with_stdio(false);
    return osem::host::run(argc, argv, std::cout, std::cerr);
}
