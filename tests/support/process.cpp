#include "tests/support/process.hpp"

#include <fcntl.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <poll.h>
#include <pty.h>
#include <sys/ioctl.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <termios.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <tuple>

namespace reeve::testing {
namespace {

using Clock = std::chrono::steady_clock;

[[noreturn]] void fail(const std::string& what) {
  throw std::runtime_error(what + ": " + std::strerror(errno));
}

// The two ends of a pipe or of a terminal.
struct Channel {
  int ours = -1;
  int theirs = -1;
};

Channel open_pipe() {
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) fail("pipe2");
  return {ends[0], ends[1]};
}

// One that passes every byte as it is.
Channel open_terminal(unsigned short width) {
  Channel channel;
  const winsize window{static_cast<unsigned short>(width == 0 ? 0 : 24), width, 0, 0};
  if (::openpty(&channel.ours, &channel.theirs, nullptr, nullptr, &window) != 0) fail("openpty");
  termios settings = {};
  ::tcgetattr(channel.theirs, &settings);
  ::cfmakeraw(&settings);
  ::tcsetattr(channel.theirs, TCSANOW, &settings);
  ::fcntl(channel.ours, F_SETFD, FD_CLOEXEC);
  ::fcntl(channel.theirs, F_SETFD, FD_CLOEXEC);
  return channel;
}

Channel open_output(const ProcessOptions& options) {
  if (options.stdout_terminal_width) return open_terminal(*options.stdout_terminal_width);
  if (options.stdout_to.empty()) return open_pipe();
  const int file = ::open(options.stdout_to.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0644);
  if (file < 0) fail(options.stdout_to.string());
  return {-1, file};
}

// From here on asking for another action on SIGXFSZ seems to succeed, and changes nothing.
void cannot_ignore_file_size_limit() {
  constexpr auto number = static_cast<unsigned>(offsetof(seccomp_data, nr));
  constexpr auto signal = static_cast<unsigned>(offsetof(seccomp_data, args));
  std::array<sock_filter, 6> steps{{BPF_STMT(BPF_LD | BPF_W | BPF_ABS, number),
                                    BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, SYS_rt_sigaction, 0, 3),
                                    BPF_STMT(BPF_LD | BPF_W | BPF_ABS, signal),
                                    BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, SIGXFSZ, 0, 1),
                                    BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ERRNO),
                                    BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW)}};
  const sock_fprog filter{static_cast<unsigned short>(steps.size()), steps.data()};
  ::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
  ::prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &filter);
}

[[noreturn]] void become(const std::vector<std::string>& command, const ProcessOptions& options,
                         int out, int err) {
  const int nothing = ::open("/dev/null", O_RDONLY);
  ::dup2(nothing, STDIN_FILENO);
  ::dup2(out, STDOUT_FILENO);
  ::dup2(err, STDERR_FILENO);
  if (options.file_size_limit) {
    const rlimit limit{*options.file_size_limit, *options.file_size_limit};
    ::setrlimit(RLIMIT_FSIZE, &limit);
    const rlimit no_core{0, 0};
    ::setrlimit(RLIMIT_CORE, &no_core);
  }
  if (options.dies_at_file_size_limit) cannot_ignore_file_size_limit();
  if (options.disturbance && options.disturbance->signal == 0) {
    ::setsid();
    ::ioctl(STDERR_FILENO, TIOCSCTTY, 0);
  }
  ::unsetenv("REEVE_CATALOG");
  for (const auto& [name, value] : options.environment) {
    ::setenv(name.c_str(), value.c_str(), 1);
  }
  std::vector<char*> arguments;
  for (const std::string& text : command) arguments.push_back(const_cast<char*>(text.c_str()));
  arguments.push_back(nullptr);
  if (::chdir(options.directory.c_str()) == 0) ::execvp(arguments[0], arguments.data());
  ::_exit(127);
}

// False at the end.
bool read_some(int from, std::string& text) {
  std::array<char, 65536> buffer{};
  const ssize_t count = ::read(from, buffer.data(), buffer.size());
  if (count > 0) text.append(buffer.data(), static_cast<std::size_t>(count));
  // A terminal that nobody holds any more says EIO.
  return count > 0 || (count < 0 && errno == EINTR);
}

void close_if_terminal(Channel& channel) {
  if (channel.ours < 0 || ::isatty(channel.ours) != 1) return;
  ::close(channel.ours);
  channel.ours = -1;
}

}  // namespace

ProcessResult run_process(const std::vector<std::string>& command, const ProcessOptions& options) {
  Channel out = open_output(options);
  Channel err = options.stderr_is_terminal ? open_terminal(80) : open_pipe();
  const pid_t child = ::fork();
  if (child < 0) fail("fork");
  if (child == 0) become(command, options, out.theirs, err.theirs);
  ::close(out.theirs);
  ::close(err.theirs);

  ProcessResult result;
  const auto deadline = Clock::now() + options.timeout;
  bool disturbed = !options.disturbance;
  while (out.ours >= 0 || err.ours >= 0) {
    std::array<pollfd, 2> ready{{{out.ours, POLLIN, 0}, {err.ours, POLLIN, 0}}};
    ::poll(ready.data(), ready.size(), disturbed ? 50 : 1);
    for (auto [channel, text, flags] : {std::tuple{&out, &result.out, ready[0].revents},
                                        std::tuple{&err, &result.err, ready[1].revents}}) {
      if (channel->ours < 0 || flags == 0 || read_some(channel->ours, *text)) continue;
      ::close(channel->ours);
      channel->ours = -1;
    }
    if (!disturbed && options.disturbance->when({child, result.out, result.err})) {
      if (options.disturbance->signal == 0) {
        for (Channel* channel : {&out, &err}) close_if_terminal(*channel);
      } else {
        ::kill(child, options.disturbance->signal);
      }
      disturbed = true;
    }
    if (!result.timed_out && Clock::now() > deadline) {
      result.timed_out = true;
      ::kill(child, SIGKILL);
    }
  }
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) continue;
  if (WIFEXITED(status)) result.exit_code = WEXITSTATUS(status);
  if (WIFSIGNALED(status)) result.signal = WTERMSIG(status);
  return result;
}

Arguments::Arguments(const char* line) {
  std::istringstream words(line);
  for (std::string word; words >> word;) push_back(word == "''" ? "" : word);
}

std::string reeve_path() { return REEVE_EXECUTABLE; }

ProcessResult reeve(const Arguments& arguments, const ProcessOptions& options) {
  std::vector<std::string> command{reeve_path()};
  command.insert(command.end(), arguments.begin(), arguments.end());
  return run_process(command, options);
}

bool catches(pid_t process, int signal) {
  std::ifstream status("/proc/" + std::to_string(process) + "/status");
  for (std::string line; std::getline(status, line);) {
    if (line.rfind("SigCgt:", 0) != 0) continue;
    return (std::strtoull(line.c_str() + 7, nullptr, 16) >> (signal - 1) & 1U) != 0;
  }
  return false;
}

std::function<bool(const RunningProcess&)> after_it_catches(int signal,
                                                            std::chrono::milliseconds pause) {
  const auto since = std::make_shared<std::optional<Clock::time_point>>();
  return [=](const RunningProcess& process) {
    if (!*since && catches(process.id, signal)) *since = Clock::now();
    return *since && Clock::now() - **since >= pause;
  };
}

}  // namespace reeve::testing
