#include "cli/complaint.hpp"

#include <cxxabi.h>
#include <fmt/format.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <csignal>
#include <exception>
#include <iostream>
#include <new>
#include <stdexcept>
#include <thread>
#include <typeinfo>

#include "cli/commands/commands.hpp"
#include "readings/csv.hpp"

namespace reeve::cli {
namespace {

constexpr std::size_t longest_line = 800;
constexpr std::size_t longest_message = 20000;

// Longer than processes that are started together differ.
constexpr std::chrono::seconds patience{5};

std::string second_speaker;  // this process, if it leaves the first word to another
std::atomic_flag is_said = ATOMIC_FLAG_INIT;

bool continues_character(char byte) { return (static_cast<unsigned char>(byte) & 0xC0U) == 0x80U; }

// The first two thirds of `most` bytes and the rest from the end, no UTF-8 character cut.
std::string cut(std::string_view text, std::size_t most) {
  if (text.size() <= most) return std::string(text);
  std::size_t head = most * 2 / 3;
  std::size_t tail = text.size() - (most - head);
  while (head > 0 && continues_character(text[head])) --head;
  while (tail < text.size() && continues_character(text[tail])) ++tail;
  return fmt::format("{} … {} bytes … {}", text.substr(0, head), tail - head, text.substr(tail));
}

// Several threads may come here at once, and one of them speaks: the others give it time to, and to
// end the program.
template <std::size_t Size>
void say_last(const char (&message)[Size]) {
  if (is_said.test_and_set()) {
    ::sleep(1);
    return;
  }
  // No channel is left to report a failure of this write.
  if (::write(STDERR_FILENO, message, Size - 1) < 0) return;
}

// No memory for the exception leaves no exception.
bool is_of_memory(const std::type_info* type) {
  return type == nullptr || *type == typeid(std::bad_alloc) ||
         *type == typeid(std::bad_array_new_length);
}

int say(const std::string& lines, int exit_code) {
  std::cerr << "reeve: " << shortened(lines) << '\n';
  return exit_code;
}

int say_in_turn(const std::string& lines, int exit_code) {
  if (second_speaker.empty()) return say(lines, exit_code);
  std::this_thread::sleep_for(patience);
  return say(second_speaker + lines, exit_code);
}

[[noreturn]] void end() {
  const std::type_info* type = abi::__cxa_current_exception_type();
  if (is_of_memory(type)) {
    complain_of_memory();
  } else if (*type == typeid(std::runtime_error)) {
    // Ours are derived from it; this is a thread of the pool that could not start another one.
    complain_of_threads();
  } else {
    say_last("reeve: internal error: ended in the middle of its work\n");
  }
  ::_exit(interrupted);
}

}  // namespace

std::string shortened(std::string_view message) {
  std::string text;
  while (true) {
    const std::size_t end = message.find('\n');
    text += cut(message.substr(0, end), longest_line);
    if (end == std::string_view::npos) break;
    text += '\n';
    message.remove_prefix(end + 1);
  }
  return cut(text, longest_message);
}

int complain_alone(const std::string& message, int exit_code) {
  return say(one_line(message), exit_code);
}

int complain(const std::string& message, int exit_code) {
  return say_in_turn(one_line(message), exit_code);
}

int complain(const InputError& error, int exit_code) {
  return say_in_turn(sentence(changed(error.fault(), one_line)), exit_code);
}

void leave_first_word_to_others(const std::string& speaker) { second_speaker = speaker; }

int complain_of_memory() {
  say_last("reeve: not enough memory\n");
  return interrupted;
}

int complain_of_threads() {
  say_last("reeve: no more threads: not enough memory, or too many threads\n");
  return interrupted;
}

void catch_termination() { std::set_terminate(end); }

void outlive_full_files() { std::signal(SIGXFSZ, SIG_IGN); }

}  // namespace reeve::cli
