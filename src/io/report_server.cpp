#include "io/report_server.hpp"

#include "core/input_error.hpp"

#include <arpa/inet.h>
#include <fmt/format.h>
#include <httplib.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <charconv>
#include <chrono>
#include <condition_variable>
#include <csignal>
#include <ctime>
#include <deque>
#include <future>
#include <mutex>
#include <thread>

namespace vesica {
namespace {

using Clock = std::chrono::steady_clock;

/// A page asks more often than this: one that is open has asked within it, and will before it has passed
/// again.
constexpr auto patience = std::chrono::milliseconds(2500);
/// For browsers that take an answer slowly, in all.
constexpr auto last_answers = std::chrono::seconds(5);

/// While this lives, threads that are begun leave signals to those that were there before.
class NoSignals {
public:
    NoSignals() {
        sigset_t all;
        ::sigfillset(&all);
        ::pthread_sigmask(SIG_BLOCK, &all, &before_);
    }
    ~NoSignals() { ::pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
    NoSignals(const NoSignals&) = delete;
    NoSignals& operator=(const NoSignals&) = delete;

private:
    sigset_t before_{};
};

/// Threads that this one begins inherit it.
void let_others_go_first() {
    ::setpriority(PRIO_PROCESS, static_cast<id_t>(::syscall(SYS_gettid)), 10);
}

/// What answers may cost: a second of processor time, to open a page without delay, and 1.5 % of the time
/// since. Who asks for more waits.
class Budget {
public:
    /// Waits until there is something left, or the run is over.
    void wait() {
        std::unique_lock lock(guard_);
        while (!over_ && spent_ > first + share * seconds_since_begin())
            changed_.wait_for(lock, std::chrono::milliseconds(50));
    }
    void spend(double seconds) {
        const std::lock_guard lock(guard_);
        spent_ += seconds;
    }
    /// Nobody waits any more.
    void end() {
        const std::lock_guard lock(guard_);
        over_ = true;
        changed_.notify_all();
    }

private:
    static constexpr double first = 1.0;
    static constexpr double share = 0.015;

    double seconds_since_begin() const {
        return std::chrono::duration<double>(Clock::now() - begin_).count();
    }

    std::mutex guard_;
    std::condition_variable changed_;
    Clock::time_point begin_ = Clock::now();
    double spent_ = 0.0;
    bool over_ = false;
};

/// Charges what its thread does while it lives.
class Charge {
public:
    explicit Charge(Budget& budget) : budget_(budget) {
        budget_.wait();
        begin_ = now();
    }
    ~Charge() { budget_.spend(now() - begin_); }
    Charge(const Charge&) = delete;
    Charge& operator=(const Charge&) = delete;

private:
    static double now() {
        timespec time{};
        ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
        return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
    }

    Budget& budget_;
    double begin_ = 0.0;
};

/// The name of the machine in a Host header, without the port.
std::string host_of(const std::string& header) {
    if (header.starts_with('['))
        return header.substr(0, header.find(']') + 1);
    return header.substr(0, header.find(':'));
}

/// Names such as 127.example.org are none.
bool is_loopback(const std::string& address) {
    in_addr number{};
    const bool is_v4 = ::inet_pton(AF_INET, address.c_str(), &number) == 1;
    return address == "localhost" || address == "::1" || (is_v4 && (ntohl(number.s_addr) >> 24) == 127);
}

/// The times of the latest requests, of several threads.
class Asking {
public:
    void note() {
        const std::lock_guard lock(guard_);
        times_.push_back(Clock::now());
        while (Clock::now() - times_.front() > patience)
            times_.pop_front();
    }
    std::size_t lately() const {
        const std::lock_guard lock(guard_);
        const auto now = Clock::now();
        return static_cast<std::size_t>(
            std::count_if(times_.begin(), times_.end(), [&](auto time) { return now - time < patience; }));
    }

private:
    mutable std::mutex guard_;
    std::deque<Clock::time_point> times_;
};

} // namespace

struct ReportServer::Listening {
    std::shared_ptr<LiveReport> report;
    std::string address;
    int port = 0;
    httplib::Server server;
    std::thread thread;
    Budget budget;
    std::promise<void> ended;                ///< the thread has nothing more to do
    Asking asking;                           ///< for the manifest
    std::atomic<bool> at_end{false};         ///< the run is over
    std::atomic<std::size_t> end_fetched{0}; ///< and so many answers said so

    /// A page of another site must not read the run through its reader's browser (DNS rebinding): the name
    /// it was told to ask is none of ours. Whoever opened the port to all has no such names to check.
    bool is_meant(const httplib::Request& request) const {
        if (!is_loopback(address))
            return true;
        const std::string host = host_of(request.get_header_value("Host"));
        return host == "[::1]" || is_loopback(host);
    }

    void route() {
        server.set_pre_routing_handler([this](const httplib::Request& request, httplib::Response& response) {
            response.set_header("X-Content-Type-Options", "nosniff");
            response.set_header("Cache-Control", "no-store");
            const bool reads = request.method == "GET" || request.method == "HEAD";
            if (reads && is_meant(request))
                return httplib::Server::HandlerResponse::Unhandled;
            response.status = reads ? 403 : 405;
            response.set_content(reads ? "ask for 127.0.0.1\n" : "this is for reading\n", "text/plain");
            return httplib::Server::HandlerResponse::Handled;
        });
        server.Get("/", [this](const httplib::Request&, httplib::Response& response) {
            const Charge charge(budget);
            response.set_content(report->page(), "text/html; charset=utf-8");
        });
        server.Get("/manifest", [this](const httplib::Request& request, httplib::Response& response) {
            give_manifest(request, response);
        });
        server.Get(R"(/frame/(\d{1,18}))",
                   [this](const httplib::Request& request, httplib::Response& response) {
                       const Charge charge(budget);
                       const std::string digits = request.matches[1];
                       std::int64_t step = 0;
                       std::from_chars(digits.data(), digits.data() + digits.size(), step);
                       if (const auto bytes = report->frame(step))
                           response.set_content(*bytes, "application/octet-stream");
                       else
                           response.status = 404;
                   });
    }

    void give_manifest(const httplib::Request& request, httplib::Response& response) {
        asking.note();
        const Charge charge(budget);
        const bool last = at_end;
        const std::string tag = report->tag();
        response.set_header("ETag", tag);
        if (!last && request.get_header_value("If-None-Match") == tag)
            response.status = 304;
        else
            response.set_content(report->manifest(), "application/json");
        if (last)
            ++end_fetched;
    }
};

ReportServer::ReportServer(std::shared_ptr<LiveReport> report, const std::string& address, int port)
    : listening_(std::make_shared<Listening>()) {
    listening_->report = std::move(report);
    listening_->address = address;
    httplib::Server& server = listening_->server;
    server.new_task_queue = [] {
        return new httplib::ThreadPool(2);
    };
    server.set_keep_alive_max_count(1); // nobody holds the end of a run up
    server.set_payload_max_length(0);   // nor fills the run's memory
    server.set_read_timeout(2);
    server.set_write_timeout(5);
    // Not even a second process of the same user may share the port, as the library would let it.
    server.set_socket_options([](socket_t socket) {
        const int yes = 1;
        ::setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof(yes));
    });
    const bool bound = port == 0 ? (listening_->port = server.bind_to_any_port(address)) > 0
                                 : server.bind_to_port(address, port);
    if (!bound)
        throw RunError(
            fmt::format("{} port {} cannot be listened to: it is in use, or not this machine's, or "
                        "not allowed; try another with --watch, or --watch 0 for any that is free",
                        address, port));
    if (port != 0)
        listening_->port = port;
    listening_->route();
    const NoSignals quiet;
    listening_->thread = std::thread([listening = listening_] {
        let_others_go_first();
        listening->server.listen_after_bind();
        listening->ended.set_value();
    });
}

ReportServer::~ReportServer() {
    const auto begin = Clock::now();
    const std::size_t pages = listening_->asking.lately(); // at most: one may have asked twice
    listening_->at_end = true;
    listening_->budget.end();
    while (listening_->end_fetched < pages && Clock::now() - begin < patience)
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
    // A server that has not begun to listen yet would not hear that it is to stop.
    while (!listening_->server.is_running() && Clock::now() - begin < 2 * patience)
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    listening_->server.stop();
    // Nobody who reads slowly holds up the end of a run: what the thread needs is its own.
    if (listening_->ended.get_future().wait_for(last_answers) == std::future_status::ready)
        listening_->thread.join();
    else
        listening_->thread.detach();
}

std::string ReportServer::url() const {
    const std::string& address = listening_->address;
    const bool is_v6 = address.find(':') != std::string::npos;
    return fmt::format("http://{}:{}/", is_v6 ? "[" + address + "]" : address, listening_->port);
}

} // namespace vesica
