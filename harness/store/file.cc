#include "harness/store/file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <random>
#include <system_error>
#include <utility>

namespace mb {

namespace {

std::string reason() { return std::generic_category().message(errno); }

// An open file descriptor.
class Descriptor {
 public:
  explicit Descriptor(int fd) : fd_(fd) {}
  ~Descriptor() { close(); }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  bool open() const { return fd_ >= 0; }
  int get() const { return fd_; }
  bool close() {
    const int fd = fd_;
    fd_ = -1;
    return fd < 0 || ::close(fd) == 0;
  }

 private:
  int fd_;
};

// Removes the temporary file unless it got its final name.
class Temporary {
 public:
  explicit Temporary(std::string name) : name_(std::move(name)) {}
  ~Temporary() {
    if (!name_.empty()) ::unlink(name_.c_str());
  }
  Temporary(const Temporary&) = delete;
  Temporary& operator=(const Temporary&) = delete;
  void keep() { name_.clear(); }

 private:
  std::string name_;
};

bool write_all(int fd, std::string_view content) {
  while (!content.empty()) {
    const ssize_t n = ::write(fd, content.data(), content.size());
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) return false;
    content.remove_prefix(static_cast<std::size_t>(n));
  }
  return true;
}

// So that the new name survives a power cut. Some file systems cannot: the file itself is safe already.
void sync_folder(const std::filesystem::path& folder) {
  const Descriptor descriptor(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (descriptor.open()) ::fsync(descriptor.get());
}

// With all that it lies in. A name that is new survives a power cut only with the folder that it stands in.
void make_folder(const std::filesystem::path& folder, const std::filesystem::path& wanted_for) {
  std::error_code error;
  if (folder.empty() || std::filesystem::is_directory(folder, error)) return;
  const std::filesystem::path parent = folder.has_parent_path() ? folder.parent_path() : ".";
  if (parent != folder) make_folder(parent, wanted_for);
  std::filesystem::create_directory(folder, error);  // another process may have made it meanwhile
  if (error) throw StoreError(wanted_for, "its folder cannot be made: " + error.message());
  sync_folder(parent);
}

// A new file FILE.XXXXXX; -1 and the reason in errno where there can be none. Not mkostemp, whose files are the owner's
// alone: a shared store has other readers, and who wants none says so by the umask.
std::pair<int, std::string> open_beside(const std::filesystem::path& file) {
  static constexpr char letters[] = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789";
  std::random_device random;
  for (int tries = 0; tries < 100; ++tries) {
    std::string name = file.string() + ".";
    for (int i = 0; i < 6; ++i) name += letters[random() % (sizeof letters - 1)];
    const int fd = ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (fd >= 0 || errno != EEXIST) return {fd, name};
  }
  return {-1, ""};
}

}  // namespace

StoreError::StoreError(std::filesystem::path file, const std::string& fault)
    : std::runtime_error(file.string() + ": " + fault), file_(std::move(file)), fault_(fault) {}

void write_file(const std::filesystem::path& file, std::string_view content,
                const std::function<void()>& before_rename) {
  const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : ".";
  make_folder(folder, file);
  auto [fd, name] = open_beside(file);
  Descriptor descriptor(fd);
  if (!descriptor.open()) throw StoreError(file, "cannot be written: " + reason());
  Temporary temporary(name);
  if (!write_all(descriptor.get(), content) || ::fsync(descriptor.get()) != 0 || !descriptor.close())
    throw StoreError(file, "cannot be written: " + reason());
  if (before_rename) before_rename();
  if (::rename(name.c_str(), file.c_str()) != 0) throw StoreError(file, "cannot be written: " + reason());
  temporary.keep();
  sync_folder(folder);
}

void remove_file(const std::filesystem::path& file) {
  if (::unlink(file.c_str()) != 0) {
    if (errno == ENOENT || errno == ENOTDIR) return;
    throw StoreError(file, "cannot be removed: " + reason());
  }
  sync_folder(file.has_parent_path() ? file.parent_path() : ".");
}

FolderLock::FolderLock(const std::filesystem::path& folder) {
  make_folder(folder, folder);
  fd_ = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (fd_ < 0) throw StoreError(folder, "cannot be opened to be locked: " + reason());
  while (::flock(fd_, LOCK_EX) != 0) {
    if (errno == EINTR) continue;
    if (errno == ENOSYS || errno == EOPNOTSUPP || errno == ENOLCK || errno == EINVAL) break;  // knows no locks
    const std::string why = reason();
    ::close(fd_);
    throw StoreError(folder, "cannot be locked: " + why);
  }
}
FolderLock::~FolderLock() {
  ::close(fd_);  // which ends the lock
}

std::string read_file(const std::filesystem::path& file, std::uintmax_t max_size) {
  // O_NONBLOCK: opening a named pipe must not wait for its writer.
  const Descriptor descriptor(::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  if (!descriptor.open()) throw StoreError(file, "cannot be read: " + reason());
  struct stat status {};
  if (::fstat(descriptor.get(), &status) != 0) throw StoreError(file, "cannot be read: " + reason());
  if (!S_ISREG(status.st_mode)) throw StoreError(file, "is not a regular file");
  const auto size = static_cast<std::uintmax_t>(status.st_size);
  if (size > max_size) throw StoreError(file, "is larger than " + std::to_string(max_size) + " bytes");

  std::string content(size, '\0');
  std::size_t n_read = 0;
  while (n_read < size) {
    const ssize_t n = ::read(descriptor.get(), content.data() + n_read, size - n_read);
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) throw StoreError(file, "cannot be read: " + reason());
    if (n == 0) throw StoreError(file, "became shorter while it was read");
    n_read += static_cast<std::size_t>(n);
  }
  return content;
}

}  // namespace mb
