// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "odeum/record/output_folder.hpp"

/// The files that a report is read with, and that no build turns into code: the page's own code
/// (reports/viewer), the libraries that it uses, the texts of studies and the documents. They lie
/// in share/odeum beside the program: in the build's folder as links into the checkout, so that a
/// changed text is shown without a build, and where the program is installed.
namespace odeum::report {

/// The folder share/odeum of this program; empty where it is not there.
std::optional<std::filesystem::path> shared_folder();

/// The text of a file in it; empty where it is not there.
std::string shared_text(const std::filesystem::path& file);

/// Writes the page's own code and the libraries that it uses into folder/viewer, and index.html,
/// whose part for readers without scripts links `files`. Throws FileError.
void write_viewer(const record::OutputFolder& folder, const std::vector<std::string>& files);

/// A template of the shared folder: {{include FILE}} is replaced by the text of a file beside it,
/// {{data}} by `data`.
std::string filled_template(const std::filesystem::path& file, std::string_view data);

}  // namespace odeum::report
