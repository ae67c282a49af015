#pragma once

#include "case/dense_field.hpp"

#include <pybind11/numpy.h>

#include <memory>
#include <utility>
#include <vector>

namespace vesica {

/// A numpy array that takes the vector over: no number is copied.
template <class T>
pybind11::array_t<T> handed_over(std::vector<T>&& values, std::vector<pybind11::ssize_t> shape) {
    auto owned = std::make_unique<std::vector<T>>(std::move(values));
    T* const data = owned->data();
    pybind11::capsule keeper(owned.get(), [](void* vector) { delete static_cast<std::vector<T>*>(vector); });
    owned.release();
    return pybind11::array_t<T>(std::move(shape), data, keeper);
}

/// The same for vectors of small arrays and structs of `Width` numbers of type T: shape (size, Width).
template <class T, std::size_t Width, class Row>
pybind11::array_t<T> handed_over_rows(std::vector<Row>&& rows) {
    static_assert(sizeof(Row) == Width * sizeof(T));
    auto owned = std::make_unique<std::vector<Row>>(std::move(rows));
    const std::vector<pybind11::ssize_t> shape = {static_cast<pybind11::ssize_t>(owned->size()),
                                                  static_cast<pybind11::ssize_t>(Width)};
    const void* const data = owned->data();
    pybind11::capsule keeper(owned.get(),
                             [](void* vector) { delete static_cast<std::vector<Row>*>(vector); });
    owned.release();
    return pybind11::array_t<T>(shape, static_cast<const T*>(data), keeper);
}

/// Shape (nz, ny, nx), or (nz, ny, nx, 3) of a vector.
inline pybind11::array_t<double> handed_over(DenseField&& field) {
    std::vector<pybind11::ssize_t> shape = {field.size.z, field.size.y, field.size.x};
    if (field.components > 1)
        shape.push_back(field.components);
    return handed_over(std::move(field.values), std::move(shape));
}

} // namespace vesica
