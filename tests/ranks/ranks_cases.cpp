#include "parallel/agreement.hpp"
#include "parallel/neighbourhood.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cstring>
#include <string>

using namespace vesica;

namespace {

std::vector<std::byte> bytes_of(const std::string& text) {
    const auto bytes = std::as_bytes(std::span(text));
    return {bytes.begin(), bytes.end()};
}

std::string text_of(const std::vector<std::byte>& bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

} // namespace

TEST_CASE("sums, votes, broadcasts and gathered values reach whom they should") {
    const Ranks ranks = Ranks::all();
    const auto count = static_cast<std::uint64_t>(ranks.count());
    const auto rank = static_cast<std::uint64_t>(ranks.rank());
    REQUIRE(count > 1);
    std::uint64_t values[2] = {rank + 1, ~std::uint64_t{0}};
    ranks.sum(values);
    CHECK(values[0] == count * (count + 1) / 2);
    CHECK(values[1] == std::uint64_t{0} - count); // modulo 2^64
    CHECK(ranks.any(ranks.rank() == ranks.count() - 1));
    CHECK_FALSE(ranks.any(false));
    CHECK(ranks.broadcast(ranks.leads() ? "from the first" : "mine") == "from the first");
    CHECK(ranks.broadcast(std::string()).empty());

    std::uint64_t gathered = 0;
    ranks.gather(bytes_of(std::string(rank, 'x')), [&](int from, std::span<const std::byte> bytes) {
        CHECK(static_cast<std::uint64_t>(from) == gathered++);
        CHECK(text_of({bytes.begin(), bytes.end()}) == std::string(static_cast<std::size_t>(from), 'x'));
    });
    CHECK(gathered == (ranks.leads() ? count : 0));
    const std::vector<double> all = ranks.gather_all(0.5 * static_cast<double>(rank));
    REQUIRE(all.size() == count);
    for (std::size_t k = 0; k < all.size(); ++k)
        CHECK(all[k] == 0.5 * static_cast<double>(k));
}

TEST_CASE("what fails on one rank fails on all, in the words of the first") {
    const Ranks ranks = Ranks::all();
    const int last = ranks.count() - 1;
    const auto words = [&](const auto& work) -> std::string {
        try {
            agree(ranks, work);
            return "done";
        } catch (const InputError& error) {
            return std::string("input: ") + error.what();
        } catch (const RunError& error) {
            return std::string("run: ") + error.what();
        }
    };
    CHECK(words([] {}) == "done");
    CHECK(words([&] {
              if (ranks.rank() == last)
                  throw RunError("no disk");
          }) == "run: no disk (rank " + std::to_string(last) + ")");
    CHECK(words([] { throw InputError("case.toml:1:1: wrong"); }) == "input: case.toml:1:1: wrong");
    CHECK(words([&] {
              if (ranks.rank() > 0)
                  throw std::bad_alloc();
          }) == "run: not enough memory (rank 1)");
    CHECK(agreed(ranks, [&] { return ranks.rank(); }) == ranks.rank());
}

TEST_CASE("the processors of a machine are shared by the ranks that may use them") {
    const Ranks ranks = Ranks::all();
    const auto count = static_cast<std::uint64_t>(ranks.count());
    const auto mask = [](std::uint64_t processors) {
        return std::vector<std::uint64_t>{(1ull << processors) - 1, 0};
    };
    CHECK(ranks.share_of_processors(mask(2 * count)) == 2); // all may use the same
    CHECK(ranks.share_of_processors(mask(1)) == 1);         // fewer than ranks
    const auto rank = static_cast<std::uint64_t>(ranks.rank());
    CHECK(ranks.share_of_processors(std::vector<std::uint64_t>{7ull << (3 * rank), 0}) == 3); // each its own
}

TEST_CASE("neighbours around the block get what is meant for them, whatever its length") {
    const Ranks ranks = Ranks::all();
    const Vec3<int> box{80, 82, 84};
    const Neighbourhood neighbourhood(ranks, BlockLayout(box, *choose_blocks(box, ranks.count())));
    std::vector<std::vector<std::byte>> outgoing;
    const auto letter = [&](int from, int to) {
        return std::to_string(from) + " to " + std::to_string(to) +
               std::string(static_cast<std::size_t>(from % 3 * 100), '.');
    };
    for (const Neighbourhood::Neighbour& neighbour : neighbourhood.neighbours()) {
        CHECK(neighbour.rank != ranks.rank());
        // To every third nothing at all.
        outgoing.push_back(neighbour.rank % 3 == 2 ? std::vector<std::byte>{}
                                                   : bytes_of(letter(ranks.rank(), neighbour.rank)));
    }
    const auto incoming = neighbourhood.exchange(outgoing);
    REQUIRE(incoming.size() == neighbourhood.neighbours().size());
    for (std::size_t k = 0; k < incoming.size(); ++k) {
        const int from = neighbourhood.neighbours()[k].rank;
        CHECK(text_of(incoming[k]) == (ranks.rank() % 3 == 2 ? "" : letter(from, ranks.rank())));
    }
}

TEST_CASE("each part of a block's surface goes to one neighbour and comes from the same") {
    const Ranks ranks = Ranks::all();
    const Vec3<int> box{80, 82, 84};
    const Neighbourhood neighbourhood(ranks, BlockLayout(box, *choose_blocks(box, ranks.count())));
    std::vector<int> sent(neighbourhood.parts().size(), 0);
    std::vector<int> received(sent.size(), 0);
    for (const Neighbourhood::Neighbour& neighbour : neighbourhood.neighbours()) {
        CHECK(neighbour.outgoing.size() == neighbour.incoming.size());
        for (const std::size_t part : neighbour.outgoing) {
            ++sent[part];
            const HaloPart& piece = neighbourhood.parts()[part];
            for (int a = 0; a < 3; ++a) {
                // The neighbour's block begins where ours ends, or the other way round.
                const CellBox& own = neighbourhood.block().own;
                const CellBox& other = neighbour.block.own;
                if (piece.link[a] > 0)
                    CHECK((own.begin[a] + own.size[a]) % box[a] == other.begin[a]);
                if (piece.link[a] < 0)
                    CHECK((other.begin[a] + other.size[a]) % box[a] == own.begin[a]);
                if (piece.link[a] == 0)
                    CHECK(own.begin[a] == other.begin[a]);
            }
        }
        for (const std::size_t part : neighbour.incoming)
            ++received[part];
    }
    CHECK(sent == std::vector<int>(sent.size(), 1));
    CHECK(received == sent);
}

TEST_CASE("messages to linked neighbours arrive time after time, and what left is counted") {
    const Ranks ranks = Ranks::all();
    const Vec3<int> box{80, 82, 84};
    const Neighbourhood neighbourhood(ranks, BlockLayout(box, *choose_blocks(box, ranks.count())));
    Messages messages(neighbourhood);
    std::int64_t sent = 0;
    std::int64_t bytes = 0;
    for (int round = 0; round < 4; ++round) {
        const auto filled_with = [&](int rank) {
            return static_cast<std::byte>(10 * rank + round);
        };
        std::vector<std::size_t> lengths; // the same both ways, some of them nothing
        for (const Neighbourhood::Neighbour& neighbour : neighbourhood.linked_neighbours())
            lengths.push_back(static_cast<std::size_t>((ranks.rank() + neighbour.rank + round) % 3 * 70));
        messages.resize(lengths, lengths);
        for (std::size_t k = 0; k < lengths.size(); ++k) {
            std::fill_n(messages.outgoing(k), lengths[k], filled_with(ranks.rank()));
            sent += lengths[k] > 0 ? 1 : 0;
            bytes += static_cast<std::int64_t>(lengths[k]);
        }
        messages.start();
        messages.progress();
        messages.finish();
        for (std::size_t k = 0; k < lengths.size(); ++k) {
            const std::vector<std::byte> expected(lengths[k],
                                                  filled_with(neighbourhood.linked_neighbours()[k].rank));
            CHECK(std::equal(expected.begin(), expected.end(), messages.incoming(k)));
        }
    }
    CHECK(messages.messages_sent() == sent);
    CHECK(messages.bytes_sent() == bytes);
}
