#pragma once

#include <vector>

struct Kernels {
    const char* name;
    double (*first)(const std::vector<double>&);
    double (*second)(const std::vector<double>&, void (*)(double));
};

std::vector<Kernels> available_kernels();
