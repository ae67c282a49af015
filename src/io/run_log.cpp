#include "io/run_log.hpp"

#include "core/input_error.hpp"

#include <fmt/format.h>
#include <spdlog/logger.h>
#include <spdlog/sinks/basic_file_sink.h>

namespace vesica {

RunLog::RunLog(const std::filesystem::path& path) {
    try {
        auto sink = std::make_shared<spdlog::sinks::basic_file_sink_mt>(path.string());
        sink->set_pattern("%Y-%m-%d %H:%M:%S.%e %l: %v");
        logger_ = std::make_unique<spdlog::logger>("vesica", std::move(sink));
    } catch (const spdlog::spdlog_ex& failure) {
        throw RunError(fmt::format("{}: cannot open the log: {}", path.string(), failure.what()));
    }
    logger_->flush_on(spdlog::level::info);                // a crash must not take the last lines with it
    logger_->set_error_handler([](const std::string&) {}); // a full disk is reported by what matters
}

RunLog::~RunLog() = default;

void RunLog::information(std::string_view text) {
    logger_->info("{}", text);
}

void RunLog::warning(std::string_view text) {
    logger_->warn("{}", text);
}

void RunLog::error(std::string_view text) {
    logger_->error("{}", text);
}

} // namespace vesica
