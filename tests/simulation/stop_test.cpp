#include "simulation/stop.hpp"

#include <catch2/catch.hpp>
#include <sys/wait.h>
#include <unistd.h>

using namespace vesica;
using namespace std::chrono_literals;

TEST_CASE("each of the three signals asks for a stop instead of ending the process") {
    const std::pair<int, const char*> signals[] = {
        {SIGINT, "SIGINT"}, {SIGTERM, "SIGTERM"}, {SIGUSR1, "SIGUSR1"}};
    for (const auto& [number, name] : signals) {
        const StopSignals listening;
        const StopRequest request(std::nullopt, StopRequest::Clock::now());
        CHECK_FALSE(request.reason());
        raise(number);
        REQUIRE(StopSignals::received());
        CHECK(*StopSignals::received() == name);
        CHECK(*request.reason() == std::string(name) + " received");
    }
}

TEST_CASE("a second SIGINT ends the process at once") {
    const pid_t child = fork();
    if (child == 0) {
        const StopSignals listening;
        raise(SIGINT);
        raise(SIGINT);
        _exit(0);
    }
    int status = 0;
    REQUIRE(waitpid(child, &status, 0) == child);
    REQUIRE(WIFSIGNALED(status));
    CHECK(WTERMSIG(status) == SIGINT);
}

TEST_CASE("the actions of before are back when the listening ends") {
    struct sigaction before {};
    struct sigaction during {};
    struct sigaction after {};
    sigaction(SIGTERM, nullptr, &before);
    {
        const StopSignals listening;
        sigaction(SIGTERM, nullptr, &during);
    }
    sigaction(SIGTERM, nullptr, &after);
    CHECK(before.sa_handler != during.sa_handler);
    CHECK(before.sa_handler == after.sa_handler);
}

TEST_CASE("the wall time stops a run when it is used up, not before") {
    const StopRequest::Clock::time_point begin{};
    const StopRequest request(10.0, begin);
    CHECK_FALSE(request.reason(begin + 9999ms));
    REQUIRE(request.reason(begin + 10s));
    CHECK(*request.reason(begin + 10s) == "the wall time of 10 s is used up");
}
