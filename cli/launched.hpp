// Detects if mpirun or srun started this process together with others, and what follows from that.
#pragma once

#include <memory>
#include <stdexcept>
#include <string>

#include "numerics/processes.hpp"

namespace reeve::cli {

// As the environment says; alone where REEVE_MPI is off. Throws InputError if that is anything
// else.
Launch launched();
// True if another process must speak first.
bool follows_another();
// "rank 1 of 3, on node7: ", for what it says itself.
std::string this_process();

// Throws InputError if there are others: all would do the same, and write the same files.
void require_alone(const Launch& launch);

// A follower is not connected to the leader, which therefore cannot report it.
class Unconnected : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// Throws InputError, or Unconnected, if this program or this machine cannot.
std::unique_ptr<Processes> connected();

// As many as were asked for; 0: this process's part of the cores that it may run on.
int threads_of_one(const Processes& processes, int asked);

}  // namespace reeve::cli
