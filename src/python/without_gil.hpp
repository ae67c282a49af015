#pragma once

#include <pybind11/pybind11.h>

namespace vesica {

/// Does what takes time while other threads run Python. Nothing in `body` may touch a Python object.
template <class Body>
auto without_gil(const Body& body) {
    const pybind11::gil_scoped_release released;
    return body();
}

} // namespace vesica
