#include "shared.hpp"

double FIRST(const std::vector<double>& values) {
    count_calls();
    return sum_of_squares(values);
}
