// The module behind numerics/processes.hpp: the one place of MPI. Only its oldest functions: any
// MPI has them. What is sent is in the background until it has gone; what waits, polls, so that a
// process that has nothing to do leaves its core to others.
#include "numerics/processes.hpp"

#include <mpi.h>
#include <sched.h>

#include <chrono>
#include <cstring>
#include <list>
#include <thread>
#include <utility>
#include <vector>

namespace reeve::mpi {
namespace {

constexpr int tag = 1;

// On how many processes of the machine, this one included, the kernel sets the same cores.
int count_sharing_cores() {
  cpu_set_t mine;
  CPU_ZERO(&mine);
  ::sched_getaffinity(0, sizeof mine, &mine);
  MPI_Comm machine = MPI_COMM_NULL;
  MPI_Comm_split_type(MPI_COMM_WORLD, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &machine);
  int size = 1;
  MPI_Comm_size(machine, &size);
  std::vector<cpu_set_t> all(static_cast<std::size_t>(size));
  MPI_Allgather(&mine, sizeof mine, MPI_BYTE, all.data(), sizeof mine, MPI_BYTE, machine);
  MPI_Comm_free(&machine);
  int sharing = 0;
  for (const cpu_set_t& other : all) sharing += CPU_EQUAL(&mine, &other) != 0 ? 1 : 0;
  return sharing;
}

class MpiProcesses final : public Processes {
 public:
  MpiProcesses() {
    int provided = MPI_THREAD_SINGLE;
    MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &provided);
    MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
    MPI_Comm_size(MPI_COMM_WORLD, &size_);
    sharing_cores_ = count_sharing_cores();
  }

  int rank() const override { return rank_; }
  int size() const override { return size_; }
  int sharing_cores() const override { return sharing_cores_; }

  void send(int to, std::string bytes) override {
    Sending& sending = sending_.emplace_back();
    sending.bytes = std::move(bytes);
    MPI_Isend(sending.bytes.data(), static_cast<int>(sending.bytes.size()), MPI_BYTE, to, tag,
              MPI_COMM_WORLD, &sending.request);
  }

  std::optional<ProcessMessage> poll() override {
    forget_what_has_gone();
    int is_there = 0;
    MPI_Status status;
    MPI_Iprobe(MPI_ANY_SOURCE, tag, MPI_COMM_WORLD, &is_there, &status);
    if (is_there == 0) return std::nullopt;
    int size = 0;
    MPI_Get_count(&status, MPI_BYTE, &size);
    ProcessMessage message{status.MPI_SOURCE, std::string(static_cast<std::size_t>(size), '\0')};
    MPI_Recv(message.bytes.data(), size, MPI_BYTE, message.from, tag, MPI_COMM_WORLD,
             MPI_STATUS_IGNORE);
    return message;
  }

  void finish() override {
    while (!sending_.empty()) {
      forget_what_has_gone();
      std::this_thread::sleep_for(std::chrono::microseconds(100));
    }
    MPI_Finalize();
  }

 private:
  struct Sending {
    std::string bytes;
    MPI_Request request = MPI_REQUEST_NULL;
  };

  void forget_what_has_gone() {
    std::erase_if(sending_, [](Sending& sending) {
      int has_gone = 0;
      MPI_Test(&sending.request, &has_gone, MPI_STATUS_IGNORE);
      return has_gone != 0;
    });
  }

  int rank_ = 0;
  int size_ = 1;
  int sharing_cores_ = 1;
  std::list<Sending> sending_;  // a list, so that buffers in flight stay in place
};

}  // namespace
}  // namespace reeve::mpi

extern "C" reeve::numerics::Processes* reeve_connect_processes() {
  return new reeve::mpi::MpiProcesses;
}
