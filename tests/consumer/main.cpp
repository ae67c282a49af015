#include "core/version.hpp"

#include <iostream>

int main() {
    std::cout << "built against vesica " << vesica::version << '\n';
}
