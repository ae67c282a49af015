#include "parallel/agreement.hpp"

namespace vesica {

namespace {

struct Failure {
    bool by_input = false; ///< InputError rather than RunError
    std::string text;
};

std::optional<Failure> failure_of(const std::function<void()>& work) {
    try {
        work();
        return std::nullopt;
    } catch (const InputError& error) {
        return Failure{true, error.what()};
    } catch (const std::exception& error) {
        return Failure{false, words_of(error)};
    }
}

} // namespace

void agree(const Ranks& ranks, const std::function<void()>& work) {
    if (ranks.count() == 1) {
        work();
        return;
    }
    const std::optional<Failure> own = failure_of(work);
    if (!ranks.any(own.has_value()))
        return;
    // The first rank knows all reasons and passes on the first of them.
    const std::string told = !own ? "" : (own->by_input ? "i" : "r") + own->text;
    std::string first;
    ranks.gather(std::as_bytes(std::span(told)), [&](int rank, std::span<const std::byte> bytes) {
        if (!first.empty() || bytes.empty())
            return;
        first.assign(reinterpret_cast<const char*>(bytes.data()), bytes.size());
        if (rank > 0)
            first += " (rank " + std::to_string(rank) + ")";
    });
    first = ranks.broadcast(first);
    if (first.front() == 'i')
        throw AgreedInputError(first.substr(1));
    throw AgreedRunError(first.substr(1));
}

} // namespace vesica
