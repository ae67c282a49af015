#pragma once

#include "case/case.hpp"

#include <filesystem>
#include <span>
#include <string>

namespace vesica {

/// Reads a case file (TOML 1.0, docs/case-file.md) and applies the overrides, each `path=value`, in their
/// order. The case is checked as far as it can be without building it. Throws InputError `FILE:LINE:COLUMN:
/// path.key is VALUE; expected ...; try ...`, or `--set path=value: ...` for an override.
Case read_case(const std::filesystem::path& file, std::span<const std::string> overrides = {});

/// The same for a text that stands for the file `name`, which need not exist; mesh files are looked for
/// beside it.
Case read_case_text(std::string text, std::string name, std::span<const std::string> overrides = {});

/// The case with every default filled in, as a case file in lattice units with SI values as comments. Reading
/// it gives the same parameters, run, output and scales, bit for bit.
std::string resolved_toml(const Case& resolved);

/// The reference of all keys in Markdown: docs/case-file.md.
std::string case_file_reference();

} // namespace vesica
