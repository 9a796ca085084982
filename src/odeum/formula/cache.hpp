// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <optional>
#include <string>

namespace odeum::formula {

/// Why code that lies in a folder (a canonical path) could be that of another user: the folder
/// is not this user's, or others may write in it, or could put another folder in its place. Empty:
/// it could not.
std::string why_not_private(const std::filesystem::path& folder);

/// The folder in which the program keeps what it computed: $XDG_CACHE_HOME/odeum, else
/// $HOME/.cache/odeum, made for its owner alone. Code is loaded from there, so that `path` is empty
/// where the folder is not private; `problem` then says why.
struct CacheFolder {
  std::string path, problem;
};
CacheFolder find_cache_folder();
/// Its path alone.
std::string cache_folder();
/// Takes another folder than $XDG_CACHE_HOME from now on. To be called before threads begin.
void keep_cache_in(const std::filesystem::path& base);
/// A variable of the environment; empty where there is none of that name.
std::string environment(const char* name);
/// 32 hexadecimal digits that identify a text.
std::string content_key(const std::string& text);

/// A template of mkstemp and mkdtemp for something unfinished in a folder: it names this process,
/// so that a later one can tell whether it is still at work.
std::string unfinished_in(const std::filesystem::path& folder);

/// Keeps a text in the cache folder, sealed with a hash of name and text, and removes what killed
/// runs left unfinished there. Nothing happens where there is no folder or it cannot be written.
void keep_text(const std::string& name, const std::string& text);
/// What is kept under a name; nothing where that is absent or not as it was written.
std::optional<std::string> kept_text(const std::string& name);

}  // namespace odeum::formula
