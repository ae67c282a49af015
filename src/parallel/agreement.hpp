#pragma once

#include "core/input_error.hpp"
#include "parallel/ranks.hpp"

#include <functional>
#include <optional>

namespace vesica {

/// What is thrown by all ranks alike: after it they are still in step.
class Agreed {
public:
    virtual ~Agreed() = default;
};
class AgreedInputError : public InputError, public Agreed {
    using InputError::InputError;
};
class AgreedRunError : public RunError, public Agreed {
    using RunError::RunError;
};

/// Does something that no other rank has a part in, on every rank. Where it fails on one of them, all learn
/// of it and throw the same, with the words of the first that failed. By all ranks together; one that is
/// alone throws what there is.
void agree(const Ranks& ranks, const std::function<void()>& work);

template <class Make>
auto agreed(const Ranks& ranks, const Make& make) {
    std::optional<decltype(make())> made;
    agree(ranks, [&] { made.emplace(make()); });
    return std::move(*made);
}

} // namespace vesica
