// Processes that one launcher (mpirun, srun) started to do one job, and messages between them.
//
// The messages go by MPI, which stands in a module of its own (mpi/). A process loads it when it
// finds itself started with others, and no other ever does: a program that is linked with libmpi
// loads seven libraries more, takes 5.2 ms of CPU to start instead of 2.7, and does not
// start at all where they are not installed.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>

#include "numerics/floors.hpp"

namespace reeve::numerics {

// Rank and size from the launcher's environment variables.
struct Launch {
  int rank = 0;
  int size = 1;
};

// Open MPI's mpirun, MPICH's, and srun (with PMIx or PMI-2).
Launch launch_in_environment();

struct ProcessMessage {
  int from = 0;
  std::string bytes;
};

class Processes {
 public:
  Processes() = default;
  virtual ~Processes() = default;
  Processes(const Processes&) = delete;
  Processes& operator=(const Processes&) = delete;

  virtual int rank() const = 0;
  virtual int size() const = 0;
  // Returns the number of processes on this machine, with this one, that may run on the same cores.
  virtual int sharing_cores() const = 0;

  // Returns at once. Messages from one process to another arrive in their order.
  virtual void send(int to, std::string bytes) = 0;
  // The next message; nothing if none has arrived.
  virtual std::optional<ProcessMessage> poll() = 0;
  // All processes call it, after taking all messages sent to them. No call follows it.
  virtual void finish() = 0;
};

// The module cannot be loaded, or does not find the others.
class NoProcesses : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// Connects through this module, which has a function of this name and type. Throws NoProcesses.
inline constexpr const char* connecting_function = "reeve_connect_processes";
using ConnectingFunction = Processes* (*)();
std::unique_ptr<Processes> connected_processes(const std::filesystem::path& module);

}  // namespace reeve::numerics
