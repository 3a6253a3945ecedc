// The file system functions of rcpputils, which precede those of C++17.
#pragma once

#include <cerrno>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>

namespace rcpputils
{
namespace fs
{

constexpr char kPreferredSeparator = '/';

class path
{
public:
  path() = default;
  path(const std::string & text)  // NOLINT: implicit upstream
  : path_(text) {}
  path(const path &) = default;
  path & operator=(const path &) = default;

  std::string string() const {return path_.string();}
  bool exists() const
  {
    std::error_code error;
    return std::filesystem::exists(path_, error);
  }
  bool is_directory() const noexcept
  {
    std::error_code error;
    return std::filesystem::is_directory(path_, error);
  }
  bool is_regular_file() const noexcept
  {
    std::error_code error;
    return std::filesystem::is_regular_file(path_, error);
  }
  /// Throws std::system_error if it is not a file.
  std::uint64_t file_size() const {return std::filesystem::file_size(path_);}
  bool empty() const {return path_.empty();}
  bool is_absolute() const {return path_.is_absolute();}
  auto cbegin() const {return path_.begin();}
  auto cend() const {return path_.end();}

  path parent_path() const {return from(path_.has_parent_path() ? path_.parent_path() : ".");}
  path filename() const {return from(path_.filename());}
  path extension() const {return from(path_.extension());}
  path clean() const {return from(path_.lexically_normal());}

  path operator/(const std::string & other) const {return from(path_ / other);}
  path operator/(const path & other) const {return from(path_ / other.path_);}
  path & operator/=(const std::string & other) {return *this /= path(other);}
  path & operator/=(const path & other)
  {
    path_ /= other.path_;
    return *this;
  }

  bool operator==(const path & other) const {return path_ == other.path_;}
  bool operator!=(const path & other) const {return path_ != other.path_;}

private:
  static path from(const std::filesystem::path & path) {return fs::path(path.string());}

  std::filesystem::path path_;
};

inline bool exists(const path & path_to_check) {return path_to_check.exists();}
inline bool is_directory(const path & p) noexcept {return p.is_directory();}
inline bool is_regular_file(const path & p) noexcept {return p.is_regular_file();}
inline std::uint64_t file_size(const path & p) {return p.file_size();}

inline path current_path() {return path(std::filesystem::current_path().string());}
inline path temp_directory_path() {return path(std::filesystem::temp_directory_path().string());}

/// Create a folder; true if it exists afterwards.
inline bool create_directories(const path & p)
{
  std::error_code error;
  std::filesystem::create_directories(p.string(), error);
  return p.is_directory();
}

/// Create a folder with a unique name that begins with `base_name`.
inline path create_temp_directory(
  const std::string & base_name, const path & parent_path = temp_directory_path())
{
  if (base_name.find(kPreferredSeparator) != std::string::npos) {
    throw std::invalid_argument("The base_name contain directory-separator.");
  }
  create_directories(parent_path);
  std::string name = (parent_path / (base_name + "XXXXXX")).string();
  if (!::mkdtemp(&name[0])) {
    throw std::system_error(errno, std::system_category(), "could not create the temp directory");
  }
  return path(name);
}

/// The same with the paths of C++17.
inline std::filesystem::path create_temporary_directory(
  const std::string & base_name,
  const std::filesystem::path & parent_path = std::filesystem::temp_directory_path(),
  std::size_t = 1000)
{
  return create_temp_directory(base_name, path(parent_path.string())).string();
}

/// Remove a file or an empty folder; false if it does not exist.
inline bool remove(const path & p)
{
  std::error_code error;
  return std::filesystem::remove(p.string(), error);
}

/// Also remove everything in it.
inline bool remove_all(const path & p)
{
  std::error_code error;
  const auto count = std::filesystem::remove_all(p.string(), error);
  return !error && count != 0;
}

/// `file_path` without its last `n_times` extensions.
inline path remove_extension(const path & file_path, int n_times = 1)
{
  std::filesystem::path rest = file_path.string();
  while (n_times-- > 0) {rest.replace_extension();}
  return path(rest.string());
}

inline bool operator<(const path & a, const path & b) {return a.string() < b.string();}

}  // namespace fs
}  // namespace rcpputils
