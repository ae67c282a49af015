#include "shared.hpp"

/// Throws across both borders of the set: from its own template, and through it from the caller's function.
double SECOND(const std::vector<double>& values, void (*visit)(double)) {
    count_calls();
    try {
        const double sum = sum_of_squares(values);
        visit(sum);
        return sum;
    } catch (const Refusal&) {
        return -1 - sum_of_squares(std::vector<double>(values.size() + 1, 0.0));
    }
}
