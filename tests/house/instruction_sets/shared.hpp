#pragma once

#include <map>
#include <stdexcept>
#include <string>
#include <vector>

/// An exception whose type information is emitted in every translation unit.
struct Refusal : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Counts its own calls: a static variable, which a set has for itself.
inline int count_calls() {
    static int calls = 0;
    return ++calls;
}

inline int global_counter = 0;

/// Has a landing pad and calls templates that the generic program instantiates as well.
template <class Real>
[[gnu::noinline]] Real sum_of_squares(const std::vector<Real>& values) {
    std::map<std::string, std::vector<Real>> copies;
    copies["values"] = values;
    if (values.empty()) {
        throw Refusal("nothing to sum");
    }
    Real sum = 0;
#pragma omp parallel for reduction(+ : sum)
    for (std::size_t i = 0; i < values.size(); ++i) {
        sum += copies.at("values")[i] * values[i];
    }
#pragma omp critical(counting)
    ++global_counter;
    return sum;
}

#define PASTE_(a, b) a##b
#define PASTE(a, b) PASTE_(a, b)
#define FIRST PASTE(first_isa_entry_, VESICA_ISA)
#define SECOND PASTE(second_isa_entry_, VESICA_ISA)
